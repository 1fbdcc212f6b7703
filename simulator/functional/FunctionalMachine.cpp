//===- FunctionalMachine.cpp - A chip without its timing ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/FunctionalMachine.h"

#include "simulator/core/Archive.h"
#include "simulator/functional/FunctionalCode.h"
#include "simulator/functional/FunctionalText.h"
#include "simulator/functional/InstructionStops.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

namespace tp {

/// Instructions of a turn: enough that changing the thread costs nothing, few
/// enough that a thread that waits for another does not wait long.
static constexpr int64_t TurnInstructions = 1 << 14;

class FunctionalMachine::Implementation {
public:
  Implementation(const ChipConfig &Chip, const Program &Text, Memory &Global);

  bool isMapped() const {
    return Chip.LocalStoreBytes == 0 || LocalStores.data();
  }
  RunResult run(const FunctionalLimits &Limits);
  Statistics statistics() const;
  std::vector<ArchitecturalState> threads() const;
  void setCodeGenerator(std::unique_ptr<FunctionalCodeGenerator> Generator);
  void setStepObserver(uint32_t Thread, StepObserver Function);
  void setChecks(ExecutionChecks &Checks);
  InstructionStops &stops();
  void serialize(Archive &A);

  FunctionalRunner Runner;
  std::vector<FunctionalThread> Threads;
  /// Instructions that all threads have issued.
  uint64_t Executed = 0;

private:
  size_t following(size_t Number) const {
    return Number + 1 == Threads.size() ? 0 : Number + 1;
  }
  /// Whether it can go on by itself.
  static bool canRun(const FunctionalThread &T) {
    return T.State == ThreadState::Running && !T.AtMarker;
  }
  void runTurn(FunctionalThread &T);
  /// Whether the turn was ended before its end.
  bool isInterrupted() const { return Stops && Stops->hasStopped(); }
  /// For the next turn.
  void prepareStops(const FunctionalLimits &Limits);
  /// Lets all threads go on that wait at the barrier.
  void releaseBarrier();
  std::optional<RunResult> ending() const;
  Progress progress() const;

  const ChipConfig Chip;
  const Program &Text;
  HostPages LocalStores;
  std::vector<FunctionalSlot> Slots;
  std::unique_ptr<FunctionalCodeGenerator> Generator;
  std::unique_ptr<InstructionStops> Stops;
  /// Who has the next turn, so that a stop changes nothing.
  size_t Next = 0;
  /// What it has of its quantum.
  int64_t Quantum = TurnInstructions;
  /// Turns since a thread could go on the last time.
  size_t Idle = 0;
};

FunctionalMachine::Implementation::Implementation(const ChipConfig &Chip,
                                                  const Program &Text,
                                                  Memory &Global)
    : Threads(Chip.threadCount()), Chip(Chip), Text(Text),
      LocalStores(Chip.threadCount() * localStoreStride(Chip)),
      Slots(decodeFunctional(Text, Chip.FlushToZero)) {
  Runner.Space = AddressSpace(Chip, Text, Global);
  Runner.Chip = &this->Chip;
  Runner.StackLimit = Text.stackLimit();
  Runner.Slots = Slots.data();
  for (uint32_t I = 0; I != Threads.size(); ++I) {
    Threads[I].Number = I;
    Threads[I].NextWord = (Text.entry() - Text.textBegin()) / 4;
    Threads[I].LocalStoreBias = localStoreBias(Chip, LocalStores, I);
  }
}

void FunctionalMachine::Implementation::setCodeGenerator(
    std::unique_ptr<FunctionalCodeGenerator> NewGenerator) {
  Generator = std::move(NewGenerator);
  FunctionalSubject Subject{&Text,
                            &Runner,
                            {},
                            FunctionalHandlers<Subnormals::Keep>::endTurn,
                            Chip.FlushToZero};
  for (const FunctionalSlot &S : Slots)
    Subject.Interpreter.push_back(S.Execute);
  Generator->start(std::move(Subject));
}

void FunctionalMachine::Implementation::setStepObserver(uint32_t Thread,
                                                        StepObserver Function) {
  Runner.ObservedThread = Thread;
  Runner.ObserveStep = std::move(Function);
  for (FunctionalSlot &S : Slots)
    Runner.Observed.push_back(std::exchange(
        S.Execute, FunctionalHandlers<Subnormals::Keep>::observeStep));
}

void FunctionalMachine::Implementation::setChecks(ExecutionChecks &Checks) {
  Runner.Checks = &Checks;
  Slots = Checks.decode(Text, Chip.FlushToZero);
  Runner.Slots = Slots.data();
  Checks.start(Runner.Space, Chip, Threads);
}

void FunctionalMachine::Implementation::runTurn(FunctionalThread &T) {
  FunctionalSlot *S = &Slots[T.NextWord];
  ++S->Begun;
  const uint64_t Before = T.TurnEnd;
  Runner.IssuedByOthers = Executed - Before;
  if (Stops)
    Stops->beginTurn(Runner.IssuedByOthers);
  T.TurnEnd += uint64_t(Quantum);
  S->Execute(&T, S, S, Quantum, &Runner);
  Executed += T.TurnEnd - Before;
  if (isInterrupted()) {
    Quantum -= int64_t(T.TurnEnd - Before);
    return;
  }
  Quantum = TurnInstructions;
  Next = following(Next);
}

InstructionStops &FunctionalMachine::Implementation::stops() {
  if (!Stops) {
    Stops = std::make_unique<InstructionStops>(Slots);
    Runner.Stops = Stops.get();
  }
  return *Stops;
}

void FunctionalMachine::Implementation::prepareStops(
    const FunctionalLimits &Limits) {
  const uint64_t End = Limits.PauseBefore.value_or(InstructionStops::Never);
  // A turn ends at a branch: beyond its quantum it may go through the text.
  const uint64_t Longest =
      uint64_t(std::max<int64_t>(Quantum, 0)) + Slots.size();
  stops().setEnd(End);
  stops().setSeesAll(End <= Executed || End - Executed <= Longest);
}

void FunctionalMachine::Implementation::serialize(Archive &A) {
  for (FunctionalThread &T : Threads) {
    A(T.Registers);
    A(T.NextWord);
    A(T.TurnEnd);
    A(T.Slept);
    A(T.Status);
    A(T.State);
    A(T.AtMarker);
  }
  LocalStores.serialize(A);
  for (FunctionalSlot &S : Slots) {
    A(S.Begun);
    A(S.Ended);
  }
  A(Runner.Markers);
  A(Runner.Arrived);
  A(Runner.Halted);
  A(Executed);
  A(Next);
  A(Quantum);
  if (A.isRestoring())
    Runner.FirstTrap.reset();
}

void FunctionalMachine::Implementation::releaseBarrier() {
  for (FunctionalThread &T : Threads)
    if (T.State == ThreadState::AtBarrier)
      T.State = ThreadState::Running;
  Runner.Arrived = 0;
  if (Runner.Checks)
    Runner.Checks->barrierOpened();
}

std::optional<RunResult> FunctionalMachine::Implementation::ending() const {
  if (Runner.FirstTrap)
    return RunResult{RunResult::Trapped, 1, Runner.FirstTrap};
  if (Runner.Halted != Threads.size())
    return std::nullopt;
  RunResult Result{RunResult::Halted, 0, std::nullopt};
  for (const FunctionalThread &T : Threads)
    if (Result.ExitStatus == 0)
      Result.ExitStatus = T.Status;
  return Result;
}

Progress FunctionalMachine::Implementation::progress() const {
  return {0, Executed, Runner.Halted};
}

RunResult
FunctionalMachine::Implementation::run(const FunctionalLimits &Limits) {
  using Clock = std::chrono::steady_clock;
  constexpr unsigned TurnsPerReport = 256;
  Runner.StopMarker = Limits.StopMarker;
  auto LastReport = Clock::now();
  Idle = 0;
  for (unsigned Turns = 0;;) {
    if (std::optional<RunResult> End = ending())
      return *End;
    if (Limits.Stop && Limits.Stop->load(std::memory_order_relaxed))
      return RunResult{RunResult::Stopped, 0, std::nullopt};
    if (Runner.Arrived != 0 && Runner.Arrived + Runner.Halted == Threads.size())
      releaseBarrier();
    if (Idle == Threads.size()) {
      for (FunctionalThread &T : Threads)
        T.AtMarker = false;
      return RunResult{RunResult::Paused, 0, std::nullopt};
    }
    FunctionalThread &T = Threads[Next];
    if (!canRun(T)) {
      Next = following(Next);
      ++Idle;
      continue;
    }
    Idle = 0;
    if (Generator)
      for (auto [Word, Execute] : Generator->update())
        Slots[Word].Execute = Execute;
    if (Stops || Limits.PauseBefore)
      prepareStops(Limits);
    runTurn(T);
    if (isInterrupted())
      return RunResult{RunResult::Paused, 0, std::nullopt};
    if (Limits.Report && ++Turns % TurnsPerReport == 0 &&
        Clock::now() - LastReport > std::chrono::milliseconds(100)) {
      LastReport = Clock::now();
      Limits.Report(progress());
    }
  }
}

Statistics FunctionalMachine::Implementation::statistics() const {
  Statistics Sum;
  // Threads that are at an instruction now, going through the text.
  uint64_t Inside = 0;
  for (const FunctionalSlot &S : Slots) {
    Inside += S.Begun - S.Ended;
    Opcode Op = S.Instruction.Op;
    bool Counts = Op != IllegalOpcode && takesTime(Op);
    if (&S != &Slots.back())
      Sum.Pcs.push_back({Counts ? Inside : 0, {}});
    if (Counts)
      Sum.Executed[unsigned(Op)] += Inside;
  }
  Sum.Markers = Runner.Markers;
  for (const FunctionalThread &T : Threads) {
    ThreadStatistics &Counts = Sum.Threads.emplace_back();
    Counts.Instructions = T.TurnEnd;
  }
  return Sum;
}

std::vector<ArchitecturalState>
FunctionalMachine::Implementation::threads() const {
  std::vector<ArchitecturalState> States;
  States.reserve(Threads.size());
  LocalStoreRange Local(Chip.LocalStoreBytes);
  for (const FunctionalThread &T : Threads)
    States.push_back(
        {T.Registers, Runner.Space.TextBegin + T.NextWord * 4, T.State,
         T.Status,
         reinterpret_cast<const uint8_t *>(T.LocalStoreBias + Local.Begin)});
  return States;
}

FunctionalMachine::FunctionalMachine(const ChipConfig &Chip,
                                     const Program &Text, Memory &Global) {
  Error = Engine(Chip, Text, Global).error();
  if (!Error.empty())
    return;
  Machine = std::make_unique<Implementation>(Chip, Text, Global);
  if (!Machine->isMapped())
    Error = "the host has no room for the local stores";
}

FunctionalMachine::~FunctionalMachine() = default;

void FunctionalMachine::setObserver(ProfileObserver *Observer) {
  Machine->Runner.Observer = Observer;
}

void FunctionalMachine::setOutput(OutputFunction Function) {
  Machine->Runner.Output = std::move(Function);
}

void FunctionalMachine::setCodeGenerator(
    std::unique_ptr<FunctionalCodeGenerator> Generator) {
  Machine->setCodeGenerator(std::move(Generator));
}

void FunctionalMachine::setInstructionObserver(InstructionObserver *Observer,
                                               const std::vector<bool> &Words) {
  Machine->stops().setObserver(Observer, Words);
}

uint64_t FunctionalMachine::executed() const { return Machine->Executed; }

void FunctionalMachine::serialize(Archive &A) { Machine->serialize(A); }

const FunctionalThread &FunctionalMachine::thread(uint32_t Number) const {
  return Machine->Threads[Number];
}

void FunctionalMachine::setRegister(uint32_t Number, unsigned Register,
                                    uint32_t Value) {
  Machine->Threads[Number].Registers[Register] = Value;
}

void FunctionalMachine::setNextWord(uint32_t Number, uint32_t Word) {
  Machine->Threads[Number].NextWord = Word;
}

void FunctionalMachine::setStepObserver(uint32_t Thread,
                                        StepObserver Function) {
  Machine->setStepObserver(Thread, std::move(Function));
}

void FunctionalMachine::setChecks(ExecutionChecks &Checks) {
  Machine->setChecks(Checks);
}

RunResult FunctionalMachine::run(const FunctionalLimits &Limits) {
  assert(Error.empty() && "run() of a machine with an error");
  return Machine->run(Limits);
}

Statistics FunctionalMachine::statistics() const {
  return Machine->statistics();
}

uint32_t FunctionalMachine::registerOf(uint32_t Thread,
                                       unsigned Register) const {
  return Machine->Threads[Thread].Registers[Register];
}

std::vector<ArchitecturalState> FunctionalMachine::threads() const {
  return Machine->threads();
}

} // namespace tp
