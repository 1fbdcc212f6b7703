//===- FunctionalJit.cpp - The functional mode's code generator -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/FunctionalJit.h"

#include "simulator/functional/Trace.h"
#include "simulator/functional/TraceCode.h"
#include "simulator/jit/BodyLibrary.h"
#include "simulator/jit/CodeSession.h"
#include "simulator/jit/ControlFlow.h"

#include "llvm/Support/WithColor.h"

#include <algorithm>
#include <chrono>
#include <future>

using namespace llvm;

namespace tp {

static const BodyLibrary &functionalSteps() {
  alignas(8) static constexpr unsigned char Bitcode[] = {
#include "simulator/functional/FunctionalStepsBitcode.inc"
  };
  static const BodyLibrary Library(Bitcode);
  return Library;
}

namespace {

/// Traces compiled before the first of them can be used.
constexpr size_t BatchTraces = 8;

class FunctionalJit final : public FunctionalCodeGenerator {
public:
  FunctionalJit(std::unique_ptr<CodeSession> Session,
                const FunctionalJitOptions &Options)
      : Options(Options), Session(std::move(Session)) {}

  void start(FunctionalSubject Subject) override {
    this->Subject = std::move(Subject);
    IsHead.resize(this->Subject.Text->instructions().size());
  }
  std::vector<Handler> update() override;

private:
  using Compiled = Expected<std::vector<Handler>>;

  /// Adds what has become hot to Waiting, the hottest first.
  void look();
  /// In the compiler's host thread.
  Compiled compile(const std::vector<Trace> &Batch);
  std::vector<Handler> take();

  const FunctionalJitOptions Options;
  std::unique_ptr<CodeSession> Session;
  FunctionalSubject Subject;
  unsigned Turns = 0;
  bool HasFailed = false;
  /// Of each word, whether a trace begins there.
  std::vector<bool> IsHead;
  std::vector<Trace> Waiting;
  std::future<Compiled> Running;
};

} // namespace

FunctionalJit::Compiled
FunctionalJit::compile(const std::vector<Trace> &Batch) {
  auto Context = std::make_unique<LLVMContext>();
  Expected<std::unique_ptr<Module>> M = functionalSteps().instantiate(*Context);
  if (!M)
    return M.takeError();
  std::vector<std::string> Names;
  for (const Trace &Steps : Batch) {
    Names.push_back("trace" + std::to_string(Steps.front().Word));
    addTrace(**M, Names.back(), Subject, Steps);
  }
  optimize(**M, [this](Function &F) { foldAddresses(F, Subject); });
  Expected<std::vector<const void *>> Entries =
      Session->compile(std::move(*M), std::move(Context), Names);
  if (!Entries)
    return Entries.takeError();
  std::vector<Handler> Handlers;
  for (size_t I = 0; I != Batch.size(); ++I)
    Handlers.push_back(
        {Batch[I].front().Word, reinterpret_cast<FunctionalHandler>(
                                    const_cast<void *>((*Entries)[I]))});
  return Handlers;
}

void FunctionalJit::look() {
  std::span<const Instruction> Text = Subject.Text->instructions();
  std::vector<uint64_t> Executed;
  std::vector<uint32_t> Heads;
  uint64_t Inside = 0;
  for (size_t Word = 0; Word != Text.size(); ++Word) {
    const FunctionalSlot &S = Subject.Runner->Slots[Word];
    Inside += S.Begun - S.Ended;
    Executed.push_back(Inside);
  }
  auto AddHead = [&](uint32_t Word) {
    if (Word >= Text.size() || IsHead[Word] ||
        Executed[Word] < Options.HotCount)
      return;
    IsHead[Word] = true;
    Heads.push_back(Word);
  };
  for (uint32_t Word = 0; Word != Text.size(); ++Word)
    if (Subject.Runner->Slots[Word].Begun >= Options.HotCount)
      AddHead(Word);
  for (size_t I = 0; I != Heads.size(); ++I) {
    Trace Steps = formTrace(Subject, Heads[I], Executed);
    if (Steps.empty()) {
      AddHead(Heads[I] + 1);
      continue;
    }
    for (uint32_t Exit : exitsOf(Subject, Steps))
      AddHead(Exit);
    Waiting.push_back(std::move(Steps));
  }
  std::ranges::sort(Waiting, std::greater(), [&](const Trace &Steps) {
    uint32_t Head = Steps.front().Word;
    return std::pair(Executed[Head], Head);
  });
}

std::vector<FunctionalCodeGenerator::Handler> FunctionalJit::take() {
  if (!Running.valid() ||
      (!Options.Waits &&
       Running.wait_for(std::chrono::seconds(0)) != std::future_status::ready))
    return {};
  Compiled Result = Running.get();
  if (Result)
    return std::move(*Result);
  HasFailed = true;
  WithColor::warning(errs(), "tpsim")
      << "no more code is generated, the run goes on with the reference "
         "engine: "
      << toString(Result.takeError()) << '\n';
  return {};
}

std::vector<FunctionalCodeGenerator::Handler> FunctionalJit::update() {
  if (HasFailed || Turns++ % Options.TurnsBetweenLooks != 0)
    return {};
  std::vector<Handler> Handlers = take();
  if (HasFailed || Running.valid())
    return Handlers;
  if (Waiting.empty())
    look();
  if (Waiting.empty())
    return Handlers;
  auto End = Waiting.begin() + std::min(BatchTraces, Waiting.size());
  std::vector<Trace> Batch(std::make_move_iterator(Waiting.begin()),
                           std::make_move_iterator(End));
  Waiting.erase(Waiting.begin(), End);
  Running = std::async(std::launch::async, [this, Batch = std::move(Batch)] {
    return compile(Batch);
  });
  return Handlers;
}

Expected<std::unique_ptr<FunctionalCodeGenerator>>
makeFunctionalJit(const FunctionalJitOptions &Options) {
  Expected<std::unique_ptr<CodeSession>> Session = CodeSession::create();
  if (!Session)
    return Session.takeError();
  return std::make_unique<FunctionalJit>(std::move(*Session), Options);
}

} // namespace tp
