//===- WindowEngine.h - The engine proper -----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Time advances by arbitration windows. In a window each TM is simulated alone,
// and in it each TP alone, highest priority first, against a table of what each
// cycle still has free: a TP can never disturb one of higher priority, so this
// is exact. What leaves a TM takes effect between the windows.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_WINDOWENGINE_H
#define TP_SIMULATOR_CORE_WINDOWENGINE_H

#include "simulator/core/Accounting.h"
#include "simulator/core/DecodedText.h"
#include "simulator/core/EngineImplementation.h"
#include "simulator/core/Handlers.h"
#include "simulator/core/HostThreadPool.h"
#include "simulator/core/TmTurn.h"
#include "simulator/core/WindowCommit.h"
#include "simulator/core/WindowSchedule.h"

#include <algorithm>
#include <chrono>

namespace tp {

template <class Word, bool FlushToZero>
class WindowEngine final : public EngineImplementation {
public:
  WindowEngine(const ChipConfig &Chip, const Program &Text, Memory &Global,
               const ResourceLayout &Layout,
               std::unique_ptr<MemorySystem> Hierarchy);

  bool isMapped() const override {
    return Chip.LocalStoreBytes == 0 || LocalStores.data();
  }
  void setHostThreads(unsigned Count) override { HostThreads = Count; }
  void setObserver(ProfileObserver *Observer) override {
    Context.Observer = Observer;
  }
  void setOutput(OutputFunction Function) override {
    Commit.setOutput(std::move(Function));
  }
  void setCodeGenerator(std::unique_ptr<CodeGenerator> Generator) override;
  void setRecorder(ExecutionRecorder *NewRecorder) override;
  void setIssueObserver(IssueObserver *Observer,
                        const std::vector<bool> &Words) override;
  void setCommitObserver(CommitObserver *Observer) override {
    Commit.setObserver(Observer);
  }
  void setInitialState(std::span<const ArchitecturalState> States) override;
  RunResult run(const RunLimits &Limits) override;
  uint64_t cycles() const override { return EndCycle; }
  Progress progress() const override;
  uint64_t passes(uint32_t Marker) const override {
    return countPasses({&Marker, 1});
  }
  Statistics statistics() const override;
  void serialize(Archive &A) override;
  const Thread &thread(uint32_t Number) const override {
    return Threads[Number];
  }
  ThreadPlace placeOf(uint32_t Number) const override {
    return {nextWord(Threads[Number]), NextCycles[Number]};
  }
  uint64_t epoch() const override { return Epoch; }
  void setRegister(uint32_t Number, unsigned Register, uint32_t Value) override;
  void setNextWord(uint32_t Number, uint32_t NextWord) override;

private:
  using Runner = TmRunner<Word>;

  uint32_t nextWord(const Thread &T) const {
    return uint32_t(static_cast<const Slot<Word> *>(T.Resume) - Slots.data());
  }

  /// As many runners and host threads as are wanted.
  void prepareHostThreads();
  void serialize(Archive &A, Thread &T);
  /// The counters of all host threads are one in a checkpoint.
  void serializeCounters(Archive &A);
  /// For a chip whose instruction caches can miss.
  void prepareFetches();
  void prepareFree();
  /// Finds the next window in which something happens; false if that is not
  /// before \p Limit.
  bool enterWindow(uint64_t Limit);
  void moveEpoch();
  void runWindow();
  /// On all host threads if the window is worth that.
  void share(const HostThreadPool::Job &Job);
  /// The part of a window that a host thread does.
  void runTms(Runner &R, unsigned Number);
  /// The host thread that runs the TM if it comes to that in time.
  unsigned homeOf(uint32_t Tm) const {
    return unsigned(uint64_t(Tm) * Pool->size() / Chip.TmCount);
  }
  /// Whether the TM was left in this window; it is not any more.
  bool claim(uint32_t Tm) {
    return Claims[Tm].load(std::memory_order_relaxed) != Claim &&
           Claims[Tm].exchange(Claim, std::memory_order_relaxed) != Claim;
  }
  uint64_t runTm(Runner &R, uint32_t Tm);
  /// The turn of this TM comes next.
  void prefetchTurn(uint32_t Tm) const;
  /// The rest of it.
  void finishWindow();
  /// What the TMs' memories share.
  void runMemory();
  void releaseBarrier();
  /// How the run has ended for good by now, if it has; sets EndCycle.
  std::optional<RunResult> ending(uint64_t MaxCycles);
  /// The cycle in which to pause: a window's first.
  uint64_t pauseCycle(const RunLimits &Limits) const;
  /// Passes of these markers so far.
  uint64_t countPasses(std::span<const uint32_t> Markers) const;
  /// Puts new generated code into the slots.
  void updateCode();
  /// Adds what generated code has counted to the other counts.
  void foldCodeCounts() const;

  const ChipConfig Chip;
  const Program &Text;
  const ResourceLayout Layout;
  ChipContext Context;
  WindowCommit Commit;
  HostPages LocalStores;
  unsigned HostThreads = 1;

  std::vector<Slot<Word>> Slots;
  /// Of the text, without the slot behind it.
  std::vector<Opcode> Opcodes;
  std::vector<Thread> Threads;
  /// Of each thread the first cycle in which it may issue.
  std::vector<uint64_t> NextCycles;
  WindowSchedule Schedule;
  /// Of each TM that has had its turn in the window, the first cycle in which
  /// it has something to do again.
  std::vector<uint64_t> TurnEnds;

  /// One per TM, the line of each word, and the handlers of fetched
  /// instructions; empty if instruction caches never miss.
  std::vector<InstructionCache> Icaches;
  std::vector<uint32_t> LineOf;
  std::vector<Handler<Word>> Fetched;

  /// Null if the chip has neither caches nor DRAM; then the threads have no
  /// requests.
  std::unique_ptr<MemorySystem> Hierarchy;
  std::vector<ThreadRequests> Requests;
  std::vector<uint64_t> UndecidedFrom;
  /// Requests of each TM that are under way.
  std::vector<int64_t> Unanswered;

  std::vector<std::unique_ptr<Runner>> Runners;
  /// Counters of all runners, for the statistics.
  std::vector<const TmRunnerState *> Counters;
  std::optional<HostThreadPool> Pool;
  /// The resource words of the window's cycles before anything has issued.
  std::vector<Word> InitialFree;
  /// Number of the window, and of each TM the last one in which a host thread
  /// has taken it.
  uint32_t Claim = 0;
  std::vector<std::atomic<uint32_t>> Claims;
  /// Whether this window is worth waking other host threads for: it looks like
  /// the last one, which took LastWork of host time.
  static constexpr std::chrono::nanoseconds WorthSharing =
      std::chrono::microseconds(10);
  bool IsShared = false;
  std::chrono::nanoseconds LastWork = 2 * WorthSharing;

  uint64_t WindowStart = 0;
  uint64_t WindowEnd = 0;
  uint64_t Epoch = 0;
  uint32_t FirstPriority = 0;
  uint32_t Waiting = 0;
  uint32_t Halted = 0;
  std::optional<PendingTrap> FirstTrap;
  uint64_t EndCycle = 0;
  /// How the run has ended for good.
  std::optional<RunResult> Final;
  /// Or none.
  std::unique_ptr<CodeGenerator> Generator;
  ExecutionRecorder *Recorder = nullptr;
  IssueObserver *Issues = nullptr;
};

template <class Word, bool FlushToZero>
WindowEngine<Word, FlushToZero>::WindowEngine(
    const ChipConfig &Chip, const Program &Text, Memory &Global,
    const ResourceLayout &Layout, std::unique_ptr<MemorySystem> Hierarchy)
    : Chip(Chip), Text(Text), Layout(Layout),
      Context{AddressSpace(Chip, Text, Global)}, Commit(Context),
      LocalStores(Chip.threadCount() * localStoreStride(Chip)),
      Slots(decodeText<Word, FlushToZero>(Text, Chip, Layout)),
      Threads(Chip.threadCount()), NextCycles(Chip.threadCount()),
      Schedule(Chip.TmCount, Chip.ArbitrationWindow), TurnEnds(Chip.TmCount),
      Hierarchy(std::move(Hierarchy)), Claims(Chip.TmCount) {
  for (const Instruction &Decoded : Text.instructions())
    Opcodes.push_back(Decoded.Op);
  Context.Chip = &this->Chip;
  Context.StackLimit = Text.stackLimit();
  Context.MemoryLatency = Chip.MemoryLatency;
  Context.BranchLatency = Chip.Latency[unsigned(LatencyClass::Branch)];

  uint32_t EntryWord = (Text.entry() - Text.textBegin()) / 4;
  for (uint32_t I = 0; I != Threads.size(); ++I) {
    Threads[I].Number = I;
    Threads[I].Resume = &Slots[EntryWord];
    Threads[I].LocalStoreBias = localStoreBias(Chip, LocalStores, I);
  }
  if (Chip.IcacheMissKind != IcacheMisses::Never)
    prepareFetches();
  if (!this->Hierarchy)
    return;
  Unanswered.resize(Chip.TmCount);
  UndecidedFrom.resize(Threads.size(), NeverCycle);
  Requests.resize(Threads.size(), ThreadRequests(Chip.StoreBufferEntries));
  for (uint32_t I = 0; I != Threads.size(); ++I)
    Threads[I].Requests = &Requests[I];
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::prepareFetches() {
  Icaches.resize(Chip.TmCount, InstructionCache(Chip));
  LineOf = linesOfText(Text, Chip);
  for (Slot<Word> &S : Slots)
    Fetched.push_back(S.Execute);
  for (size_t I = 0; I != LineOf.size(); ++I)
    if (LineOf[I] != NoLine)
      Slots[I].Execute = Handlers<Word, Subnormals::Keep>::beforeFetch();
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::setCodeGenerator(
    std::unique_ptr<CodeGenerator> NewGenerator) {
  Generator = std::move(NewGenerator);
  CodeSubject Subject = describeText(Slots, Text, Context, Layout, FlushToZero);
  Subject.HasMemorySystem = Hierarchy != nullptr;
  Subject.LineOf = LineOf;
  for (size_t I = 0; I != Fetched.size(); ++I)
    Subject.Interpreter[I] = reinterpret_cast<const void *>(Fetched[I]);
  for (size_t I = 0; I != Opcodes.size(); ++I)
    if (Recorder && Recorder->isObserved(uint32_t(I)))
      Subject.Interpreter[I] = nullptr;
  Generator->start(std::move(Subject));
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::setRecorder(
    ExecutionRecorder *NewRecorder) {
  Recorder = NewRecorder;
  for (uint32_t I = 0; I != Opcodes.size(); ++I)
    if (Recorder->isObserved(I))
      (Fetched.empty() ? Slots[I].Execute : Fetched[I]) =
          handlerOf<Word, FlushToZero>(Text, I, /*IsObserved=*/true);
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::setIssueObserver(
    IssueObserver *Observer, const std::vector<bool> &Words) {
  assert(!Generator && "generated code does not announce what it issues");
  Issues = Observer;
  for (uint32_t I = 0; I != Opcodes.size(); ++I)
    (Fetched.empty() ? Slots[I].Execute : Fetched[I]) =
        handlerOf<Word, FlushToZero>(Text, I,
                                     (Observer && Words[I]) ||
                                         (Recorder && Recorder->isObserved(I)));
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::updateCode() {
  for (const GeneratedHandler &New : Generator->update(Counters))
    (Fetched.empty() ? Slots[New.Word].Execute : Fetched[New.Word]) =
        reinterpret_cast<Handler<Word>>(const_cast<void *>(New.Entry));
  for (std::unique_ptr<Runner> &R : Runners) {
    if (R->CodeCounts.size() == Generator->numCounts())
      continue;
    R->CodeCounts.resize(Generator->numCounts());
    R->CodeCountsBegin = R->CodeCounts.data();
  }
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::foldCodeCounts() const {
  if (!Generator)
    return;
  for (const std::unique_ptr<Runner> &R : Runners)
    Generator->fold(*R);
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::prepareFree() {
  uint64_t Cycles = WindowEnd - WindowStart;
  bool SameLength = InitialFree.size() == Cycles + 1;
  if (SameLength && Layout.isUniform())
    return;
  InitialFree.clear();
  for (uint64_t Cycle = WindowStart; Cycle != WindowEnd; ++Cycle)
    InitialFree.push_back(Word(Layout.unused(Cycle)));
  InitialFree.push_back(Word(Layout.closed()));
}

template <class Word, bool FlushToZero>
bool WindowEngine<Word, FlushToZero>::enterWindow(uint64_t Limit) {
  uint64_t Next = Schedule.first();
  if (Hierarchy)
    Next = std::min(Next, Hierarchy->nextEvent());
  uint64_t Window = Next / Chip.ArbitrationWindow;
  const uint64_t Begin = Window * Chip.ArbitrationWindow;
  // A limit may have ended the last run inside of this window.
  WindowStart = std::max(Begin, WindowEnd);
  if (WindowStart >= Limit) {
    WindowEnd = Limit;
    return false;
  }
  WindowEnd = std::min(Begin + Chip.ArbitrationWindow, Limit);
  FirstPriority = uint32_t(Window % Chip.TpsPerTm);
  if (WindowStart - Epoch > ready::CycleLimit / 2)
    moveEpoch();
  prepareFree();
  return true;
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::moveEpoch() {
  uint64_t Past = WindowStart - Epoch;
  for (Thread &T : Threads)
    for (ReadyWord &Ready : T.Ready)
      if (!ready::isPending(Ready))
        Ready = ready::cycleOf(Ready) < Past
                    ? 0
                    : Ready - ReadyWord(Past << ready::CycleShift);
  Epoch = WindowStart;
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::runTms(Runner &R, unsigned Number) {
  R.WindowStart = WindowStart;
  R.Epoch = Epoch;
  R.End = R.Limit = WindowEnd - Epoch;
  // What a host thread has run before is in its caches: first those TMs, then
  // what others have left, from the other end.
  const std::vector<uint32_t> &Due = Schedule.due();
  auto Run = [&](size_t I, size_t Next) {
    if (!claim(Due[I]))
      return;
    if (Next < Due.size())
      prefetchTurn(Due[Next]);
    TurnEnds[Due[I]] = runTm(R, Due[I]);
  };
  for (size_t I = 0; I != Due.size(); ++I)
    if (homeOf(Due[I]) == Number)
      Run(I, I + 1);
  if (Pool->size() == 1)
    return;
  for (size_t I = Due.size(); I-- != 0;)
    Run(I, I - 1);
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::prefetchTurn(uint32_t Tm) const {
  for (uint32_t Priority = 0; Priority != std::min(2u, Chip.TpsPerTm);
       ++Priority) {
    uint32_t Tp = (FirstPriority + Priority) % Chip.TpsPerTm;
    prefetchThread(Threads[Tm * Chip.TpsPerTm + Tp]);
  }
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::runWindow() {
  using Clock = std::chrono::steady_clock;
  const std::vector<uint32_t> &Due = Schedule.take(WindowEnd);
  ++Claim;
  auto Work = [this](unsigned I) { runTms(*Runners[I], I); };
  if (Due.size() > 1 && Pool->size() > 1) {
    IsShared = LastWork > WorthSharing;
    auto Start = Clock::now();
    share(Work);
    LastWork = (Clock::now() - Start) * (IsShared ? Pool->size() : 1);
  } else {
    IsShared = false;
    Work(0);
  }
  for (uint32_t Tm : Due)
    Schedule.wake(Tm, TurnEnds[Tm]);
  finishWindow();
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::share(const HostThreadPool::Job &Job) {
  if (IsShared)
    Pool->run(Job);
  else
    Job(0);
}

template <class Word, bool FlushToZero>
uint64_t WindowEngine<Word, FlushToZero>::runTm(Runner &R, uint32_t Tm) {
  size_t Begin = size_t(Tm) * Chip.TpsPerTm;
  if (!Icaches.empty())
    R.Icache = &Icaches[Tm];
  TmTurn<Word> Turn(R, Tm, std::span(Threads).subspan(Begin, Chip.TpsPerTm),
                    std::span(NextCycles).subspan(Begin, Chip.TpsPerTm),
                    FirstPriority, InitialFree);
  if (!Hierarchy)
    return Turn.run();
  Hierarchy->prefetch(Tm + 1);
  uint64_t Next =
      Turn.run(Hierarchy->tm(Tm),
               std::span(UndecidedFrom).subspan(Begin, Chip.TpsPerTm));
  Unanswered[Tm] += R.Unanswered;
  return Next;
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::finishWindow() {
  for (const std::unique_ptr<Runner> &R : Runners) {
    Commit.add(R->Log);
    Waiting += R->Arrived;
    Halted += R->Halted;
    R->Arrived = R->Halted = 0;
    if (R->FirstTrap)
      keepFirst(FirstTrap, *R->FirstTrap);
  }
  Commit.commit(WindowStart, FirstTrap);
  for (const std::unique_ptr<Runner> &R : Runners)
    R->Log.clear();
  if (Waiting != 0 && Waiting + Halted == Threads.size())
    releaseBarrier();
  if (Hierarchy)
    runMemory();
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::runMemory() {
  bool IsAsked =
      std::ranges::any_of(Unanswered, [](int64_t Count) { return Count != 0; });
  if (!IsAsked && Hierarchy->nextEvent() >= WindowEnd)
    return;
  for (unsigned Stage = 0; Stage != Hierarchy->stages(); ++Stage) {
    std::atomic<unsigned> NextPart = 0;
    unsigned Parts = Hierarchy->parts(Stage);
    auto RunParts = [&](unsigned) {
      while (true) {
        unsigned Part = NextPart.fetch_add(1, std::memory_order_relaxed);
        if (Part >= Parts)
          return;
        Hierarchy->runPart(Stage, Part, WindowEnd);
      }
    };
    if (Parts > 1)
      share(RunParts);
    else
      RunParts(0);
  }
  for (uint32_t Tm = 0; Tm != Chip.TmCount; ++Tm)
    if (Unanswered[Tm] != 0 && Hierarchy->tm(Tm).hasAnswers())
      Schedule.wake(Tm, WindowEnd);
}

template <class Word, bool FlushToZero>
Statistics WindowEngine<Word, FlushToZero>::statistics() const {
  foldCodeCounts();
  Statistics Result =
      summarize(Threads, NextCycles, EndCycle, Counters, Opcodes);
  if (Hierarchy)
    Result.Memory = Hierarchy->statistics(WindowEnd);
  for (const InstructionCache &Icache : Icaches)
    Result.Icache += Icache.statistics();
  return Result;
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::releaseBarrier() {
  for (Thread &T : Threads) {
    if (T.State != ThreadState::AtBarrier)
      continue;
    T.State = ThreadState::Running;
    Runners[0]->charge(T, T.LastWord, Loss::Barrier, WindowEnd - T.EndCycle);
    NextCycles[T.Number] = WindowEnd;
    Schedule.wake(T.Number / Chip.TpsPerTm, WindowEnd);
  }
  Waiting = 0;
}

template <class Word, bool FlushToZero>
Progress WindowEngine<Word, FlushToZero>::progress() const {
  foldCodeCounts();
  Progress Result{WindowEnd, 0, Halted};
  for (const TmRunnerState *State : Counters)
    for (const IssueCounts &Counts : State->IssuedAt)
      Result.Instructions += Counts.Executed;
  return Result;
}

template <class Word, bool FlushToZero>
std::optional<RunResult>
WindowEngine<Word, FlushToZero>::ending(uint64_t MaxCycles) {
  RunResult Result;
  EndCycle = WindowEnd;
  if (FirstTrap) {
    Result.End = RunResult::Trapped;
    Result.ExitStatus = 1;
    Result.TrapInfo = FirstTrap->Info;
    return Result;
  }
  if (Halted == Threads.size()) {
    EndCycle = 0;
    for (const Thread &T : Threads) {
      EndCycle = std::max(EndCycle, T.EndCycle);
      if (Result.ExitStatus == 0)
        Result.ExitStatus = T.Status;
    }
    Result.End = RunResult::Halted;
    return Result;
  }
  if (WindowEnd >= MaxCycles) {
    Result.End = RunResult::CycleLimit;
    return Result;
  }
  return std::nullopt;
}

template <class Word, bool FlushToZero>
uint64_t
WindowEngine<Word, FlushToZero>::pauseCycle(const RunLimits &Limits) const {
  if (Limits.PauseCycle == 0)
    return NeverCycle;
  uint64_t Windows = (Limits.PauseCycle - 1) / Chip.ArbitrationWindow + 1;
  return Windows * Chip.ArbitrationWindow;
}

template <class Word, bool FlushToZero>
uint64_t WindowEngine<Word, FlushToZero>::countPasses(
    std::span<const uint32_t> Markers) const {
  uint64_t Passes = 0;
  for (const TmRunnerState *State : Counters)
    for (uint32_t Marker : Markers)
      if (Marker < State->Markers.size())
        Passes += State->Markers[Marker];
  return Passes;
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::prepareHostThreads() {
  unsigned Count = std::clamp(HostThreads, 1u, Chip.TmCount);
  while (Runners.size() < Count) {
    auto R = std::make_unique<Runner>();
    R->Slots = Slots.data();
    R->Fetched = Fetched.data();
    R->LineOf = LineOf.data();
    R->Guards = Word(Layout.guards());
    R->IcacheGuards = Word(Layout.icacheGuards());
    R->Closed = Word(Layout.closed());
    R->Free.resize(Chip.ArbitrationWindow + 1);
    R->OwnAccessesOf.resize(Hierarchy ? Chip.TpsPerTm : 0);
    R->L1Latency = Chip.L1 ? Chip.L1->Latency : 0;
    R->IssuedAt.resize(Slots.size());
    if (Recorder)
      R->Record = &Recorder->addPart();
    R->LostAt.resize(Slots.size());
    Counters.push_back(R.get());
    Runners.push_back(std::move(R));
  }
  for (std::unique_ptr<Runner> &R : Runners)
    R->Chip = Context;
  if (!Pool || Pool->size() != Count)
    Pool.emplace(Count);
}

template <class Word, bool FlushToZero>
RunResult WindowEngine<Word, FlushToZero>::run(const RunLimits &Limits) {
  using Clock = std::chrono::steady_clock;
  if (Final)
    return *Final;
  prepareHostThreads();
  for (const std::unique_ptr<Runner> &R : Runners)
    R->Issues = Issues;
  if (Recorder && !Recorder->hasBegun())
    for (const Thread &T : Threads)
      Recorder->begin(T, nextWord(T));
  uint64_t MaxCycles = Limits.MaxCycles ? Limits.MaxCycles : NeverCycle;
  uint64_t PauseCycle = pauseCycle(Limits);
  uint64_t PassesBefore = countPasses(Limits.PauseMarkers);
  auto LastReport = Clock::now();
  for (unsigned Windows = 0; !(Final = ending(MaxCycles)); ++Windows) {
    if (Limits.Stop && Limits.Stop->load(std::memory_order_relaxed))
      return RunResult{RunResult::Stopped, 0, std::nullopt};
    if (WindowEnd >= PauseCycle ||
        countPasses(Limits.PauseMarkers) != PassesBefore)
      return RunResult{RunResult::Paused, 0, std::nullopt};
    if (Limits.Report && Windows % 32 == 0 &&
        Clock::now() - LastReport > std::chrono::milliseconds(100)) {
      LastReport = Clock::now();
      Limits.Report(progress());
    }
    if (!enterWindow(std::min(MaxCycles, PauseCycle)))
      continue;
    if (Generator)
      updateCode();
    runWindow();
  }
  return *Final;
}

template <class Word, bool FlushToZero>
std::unique_ptr<EngineImplementation>
makeEngine(const ChipConfig &Chip, const Program &Text, Memory &Global,
           const ResourceLayout &Layout,
           std::unique_ptr<MemorySystem> Hierarchy) {
  return std::make_unique<WindowEngine<Word, FlushToZero>>(
      Chip, Text, Global, Layout, std::move(Hierarchy));
}

} // namespace tp

#include "simulator/core/WindowEngineState.h"

#endif // TP_SIMULATOR_CORE_WINDOWENGINE_H
