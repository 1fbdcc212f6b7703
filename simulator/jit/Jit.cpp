//===- Jit.cpp - The cycle engine's code generator ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/Jit.h"

#include "simulator/jit/BatchCompiler.h"
#include "simulator/jit/HotSpots.h"

#include "llvm/Support/WithColor.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

using namespace llvm;

namespace tp {

namespace {

/// Segments compiled before the first of them can be used.
constexpr size_t BatchSegments = 8;

class Jit final : public CodeGenerator {
public:
  Jit(std::unique_ptr<CodeSession> Session, const JitOptions &Options)
      : Options(Options), Session(std::move(Session)) {}
  ~Jit() override;

  void start(CodeSubject Subject) override;
  std::vector<GeneratedHandler>
  update(std::span<const TmRunnerState *const> Counters) override;
  size_t numCounts() const override { return Exits.size(); }
  void fold(TmRunnerState &Runner) override;

private:
  /// One count of generated code.
  struct Count {
    const SegmentCounts *Code;
    const SegmentExit *Exit;
  };

  using Clock = std::chrono::steady_clock;

  /// The compiler's host thread.
  void compileRequests();
  /// When the compiler may go on after what it has done.
  Clock::time_point nextTurn() const {
    return Options.EverythingAtOnce
               ? Start
               : Start + std::chrono::duration_cast<Clock::duration>(
                             Compiling / Options.CompilerShare);
  }
  void install(const Batch &Compiled, std::vector<GeneratedHandler> &Handlers);
  void look(std::span<const TmRunnerState *const> Counters);

  const JitOptions Options;
  std::unique_ptr<CodeSession> Session;
  std::unique_ptr<BatchCompiler> Compiler;
  Clock::time_point Start;
  /// What the compiler has taken; its thread's.
  std::chrono::duration<double> Compiling{0};
  HotSpots Spots;
  unsigned Windows = 0;
  /// What the interpreter had executed when something was last hot, and what
  /// fold() has added to that.
  std::vector<uint64_t> Seen, Folded;
  std::vector<Count> Exits;
  /// What has been installed; Exits points into it.
  std::vector<std::unique_ptr<Batch>> Installed;

  std::mutex Mutex;
  std::condition_variable Changed;
  /// Under Mutex: what is to be compiled, and what has been.
  std::vector<Segment> Requests;
  std::vector<std::unique_ptr<Batch>> Finished;
  std::optional<std::string> Failure;
  bool IsBusy = false;
  bool IsStopping = false;
  std::thread Thread;
};

} // namespace

Jit::~Jit() {
  {
    std::lock_guard Lock(Mutex);
    IsStopping = true;
  }
  Changed.notify_all();
  if (Thread.joinable())
    Thread.join();
}

void Jit::start(CodeSubject Subject) {
  size_t NumWords = Subject.Text->instructions().size();
  Seen.resize(NumWords);
  Folded.resize(NumWords);
  Compiler =
      std::make_unique<BatchCompiler>(std::move(Session), std::move(Subject));
  Start = Clock::now();
  Thread = std::thread([this] { compileRequests(); });
}

void Jit::compileRequests() {
  std::unique_lock Lock(Mutex);
  for (;;) {
    Changed.wait(Lock, [this] { return IsStopping || !Requests.empty(); });
    Changed.wait_until(Lock, nextTurn(), [this] { return IsStopping; });
    if (IsStopping)
      return;
    IsBusy = true;
    auto End = Requests.begin() + std::min(BatchSegments, Requests.size());
    std::vector<Segment> Segments(std::make_move_iterator(Requests.begin()),
                                  std::make_move_iterator(End));
    Requests.erase(Requests.begin(), End);
    Lock.unlock();
    auto Begin = Clock::now();
    Expected<Batch> Compiled = Compiler->compile(Segments);
    Compiling += Clock::now() - Begin;
    Lock.lock();
    IsBusy = false;
    if (Compiled) {
      Finished.push_back(std::make_unique<Batch>(std::move(*Compiled)));
    } else {
      Failure = toString(Compiled.takeError());
      IsStopping = true;
    }
    Changed.notify_all();
  }
}

void Jit::install(const Batch &Compiled,
                  std::vector<GeneratedHandler> &Handlers) {
  Handlers.insert(Handlers.end(), Compiled.Handlers.begin(),
                  Compiled.Handlers.end());
  for (const SegmentCounts &Code : Compiled.Counts)
    for (const SegmentExit &Exit : Code.Exits)
      Exits.push_back({&Code, &Exit});
}

std::vector<GeneratedHandler>
Jit::update(std::span<const TmRunnerState *const> Counters) {
  if (Windows++ % Options.WindowsBetweenLooks != 0)
    return {};
  std::unique_lock Lock(Mutex);
  bool IsDone = Options.EverythingAtOnce && Windows != 1;
  if (Requests.empty() && !IsBusy && !IsStopping && !IsDone)
    look(Counters);
  if (Options.EverythingAtOnce)
    Changed.wait(
        Lock, [this] { return IsStopping || (Requests.empty() && !IsBusy); });
  std::vector<GeneratedHandler> Handlers;
  for (std::unique_ptr<Batch> &Compiled : Finished) {
    install(*Compiled, Handlers);
    Installed.push_back(std::move(Compiled));
  }
  Finished.clear();
  if (Failure) {
    WithColor::warning(errs(), "tpsim")
        << "no more code is generated, the run goes on with the reference "
           "engine: "
        << *Failure << '\n';
    Failure.reset();
  }
  return Handlers;
}

void Jit::look(std::span<const TmRunnerState *const> Counters) {
  const CodeSubject &Subject = Compiler->subject();
  size_t NumWords = Seen.size();
  std::vector<uint64_t> Executed(NumWords), Interpreted(NumWords);
  for (const TmRunnerState *Counter : Counters)
    for (size_t Word = 0; Word != NumWords; ++Word)
      Executed[Word] += Counter->IssuedAt[Word].Executed;
  uint64_t HotCount = Options.EverythingAtOnce ? 0 : Options.HotCount;
  std::vector<uint64_t> Now(NumWords);
  for (size_t Word = 0; Word != NumWords; ++Word) {
    Now[Word] = Executed[Word] - Folded[Word];
    Interpreted[Word] = Now[Word] - Seen[Word];
  }
  Requests = Spots.choose(Subject, Interpreted, Executed, HotCount);
  if (!Requests.empty())
    Seen = std::move(Now);
  Changed.notify_all();
}

void Jit::fold(TmRunnerState &Runner) {
  std::span<const Instruction> Text = Compiler->subject().Text->instructions();
  for (size_t I = 0; I != Runner.CodeCounts.size(); ++I) {
    uint64_t Times = std::exchange(Runner.CodeCounts[I], 0);
    if (Times == 0)
      continue;
    const auto &[Code, Exit] = Exits[I];
    for (uint32_t Step = 0; Step != Exit->Executed; ++Step) {
      uint32_t Word = Code->Steps[Step].Word;
      if (takesTime(Text[Word].Op)) {
        Runner.IssuedAt[Word].Executed += Times;
        Folded[Word] += Times;
      }
    }
    for (uint32_t Step = 0; Step != Exit->Waited; ++Step) {
      const KnownWait &Wait = Code->Waits[Step];
      Runner.LostAt[Code->Steps[Step].Word][unsigned(Loss::Data)] +=
          Times * Wait.Cycles;
      Runner.DataStall[unsigned(Wait.Producer)] += Times * Wait.Cycles;
    }
  }
}

Expected<std::unique_ptr<CodeGenerator>> makeJit(const JitOptions &Options) {
  Expected<std::unique_ptr<CodeSession>> Session = CodeSession::create();
  if (!Session)
    return Session.takeError();
  return std::make_unique<Jit>(std::move(*Session), Options);
}

} // namespace tp
