//===- ScoreboardModel.cpp - The cycle model, done naively ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/ScoreboardModel.h"
#include "runtime/include/tp/host_call.h"
#include "runtime/include/tp/memory_map.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>

namespace tp::test {

/// The registers that an instruction reads; the others of its fields are r0,
/// which is always ready.
static const uint8_t (&sourcesOf(const Instruction &I))[3] { return I.Source; }

ScoreboardModel::ScoreboardModel(const ChipConfig &Chip, const Program &Text,
                                 Memory &Global)
    : Chip(Chip), Text(Text), Global(Global), Threads(Chip.threadCount()),
      Hierarchy(makeMemorySystem(this->Chip)) {
  for (uint32_t I = 0; I != Threads.size(); ++I) {
    Threads[I].Number = I;
    Threads[I].Pc = Text.entry();
    Threads[I].LocalStore.resize(Chip.LocalStoreBytes);
    Threads[I].StoreEntries.resize(Chip.StoreBufferEntries);
  }
  Counts.Pcs.resize(Text.instructions().size());
  uint32_t Before = 0;
  for (const Instruction &I : Text.instructions()) {
    Fetches.push_back(Before);
    Before += I.Op == IllegalOpcode || takesTime(I.Op);
  }
}

RunResult ScoreboardModel::run(uint64_t MaxCycles) {
  RunResult Result;
  for (;;) {
    uint64_t Window = Cycle / Chip.ArbitrationWindow;
    WindowStart = Window * Chip.ArbitrationWindow;
    WindowEnd = std::min(WindowStart + Chip.ArbitrationWindow, MaxCycles);
    takeSharedAnswers();
    for (; Cycle != WindowEnd; ++Cycle) {
      simulateCycle();
      advanceMemory();
    }
    endWindow();
    runSharedMemory();
    if (FirstTrap) {
      Result.End = RunResult::Trapped;
      Result.ExitStatus = 1;
      Result.TrapInfo = FirstTrap;
      break;
    }
    bool AllHalted = std::ranges::all_of(Threads, [](const ModelThread &T) {
      return T.State == ModelThread::Halted;
    });
    if (AllHalted) {
      cutToLastHalt();
      for (const ModelThread &T : Threads)
        if (Result.ExitStatus == 0)
          Result.ExitStatus = T.Status;
      break;
    }
    if (Cycle == MaxCycles) {
      Result.End = RunResult::CycleLimit;
      break;
    }
  }
  settleAll();
  Counts.Cycles = Cycle;
  if (Hierarchy)
    Counts.Memory = Hierarchy->statistics(WindowEnd);
  for (const ModelThread &T : Threads)
    Counts.Threads.push_back(T.Counts);
  return Result;
}

void ScoreboardModel::simulateCycle() {
  std::vector<Started> Tms(Chip.TmCount);
  for (Started &S : Tms)
    S.Banks.resize(Chip.IcacheBanks);
  uint64_t Window = Cycle / Chip.ArbitrationWindow;
  for (uint32_t Priority = 0; Priority != Chip.TpsPerTm; ++Priority) {
    uint32_t Tp = uint32_t((Window + Priority) % Chip.TpsPerTm);
    for (uint32_t Tm = 0; Tm != Chip.TmCount; ++Tm)
      simulateThread(Threads[Tm * Chip.TpsPerTm + Tp], Tms[Tm]);
  }
}

void ScoreboardModel::simulateThread(ModelThread &T, Started &S) {
  if (T.State == ModelThread::AtBarrier)
    return lose(T, Loss::Barrier);
  if (T.State != ModelThread::Running)
    return lose(T, Loss::Finished);
  if (Cycle < T.NextIssue)
    return T.Waiting == Loss::Memory
               ? loseToResult(T, Loss::Memory, T.WaitingFor)
               : lose(T, T.Waiting);
  if (awaitsStoreBuffer(T))
    return;
  const Instruction *I = nextInstruction(T);
  if (!I || !areSourcesReady(T, *I) || !hasSlots(T, *I, S))
    return;
  ModelEffects Effects = execute(T, *I);
  if (Effects.TrapReason)
    return trap(T, T.Pc, *Effects.TrapReason, Effects.TrapAddress);
  if (Effects.Blocker) {
    T.NextIssue = WindowEnd;
    T.Waiting = Loss::Memory;
    T.WaitingFor = *Effects.Blocker;
    return loseToResult(T, Loss::Memory, T.WaitingFor);
  }
  bool IsStore = Effects.Access && Effects.Access->Kind == ModelAccess::Store;
  if (Hierarchy && IsStore && T.StoreEntries[T.NextStore] > Cycle) {
    T.AwaitsEntry = true;
    return loseToResult(T, Loss::StoreBuffer, I->Op);
  }
  takeSlots(T, *I, S);
  issue(T, *I, Effects);
}

uint32_t ScoreboardModel::wordOf(const ModelThread &T) const {
  return (T.Pc - Text.textBegin()) / 4;
}

const Instruction *ScoreboardModel::nextInstruction(ModelThread &T) {
  passMessages(T, Cycle);
  uint32_t Word = wordOf(T);
  T.LosingWord = Word;
  if (isBehindStackMove(Word) &&
      T.Registers[StackPointerRegister].Value < Text.stackLimit()) {
    trap(T, T.Pc - 4, TrapKind::StackOverflow,
         T.Registers[StackPointerRegister].Value);
    return nullptr;
  }
  if (T.Pc == Text.textEnd()) {
    trap(T, T.Pc, TrapKind::FetchOutsideText, T.Pc);
    return nullptr;
  }
  const Instruction &I = Text.instructions()[Word];
  if (I.Op == IllegalOpcode) {
    trap(T, T.Pc, TrapKind::IllegalInstruction, T.Pc);
    return nullptr;
  }
  if (takesTime(I.Op))
    return &I;
  // A message about a value that nobody knows yet.
  areSourcesReady(T, I);
  return nullptr;
}

bool ScoreboardModel::isBehindStackMove(uint32_t Word) const {
  if (Text.stackLimit() == 0 || Word == 0 || Word == Text.instructions().size())
    return false;
  const Instruction &Before = Text.instructions()[Word - 1];
  return Before.Destination == StackPointerRegister &&
         std::ranges::find(Before.Source, StackPointerRegister) !=
             std::end(Before.Source);
}

void ScoreboardModel::passMessages(ModelThread &T, uint64_t At) {
  for (;; T.Pc += 4) {
    uint32_t Word = wordOf(T);
    if (Word == Text.instructions().size())
      return;
    const Instruction &I = Text.instructions()[Word];
    if (I.Op == IllegalOpcode || takesTime(I.Op) || !mayPass(T, I, At))
      return;
    if (isBehindStackMove(Word) &&
        T.Registers[StackPointerRegister].Value < Text.stackLimit())
      return;
    settle(T, I);
    execute(T, I);
  }
}

bool ScoreboardModel::mayPass(const ModelThread &T, const Instruction &I,
                              uint64_t At) const {
  for (uint8_t Source : sourcesOf(I)) {
    const ModelRegister &R = T.Registers[Source];
    bool Deferred =
        R.FromGlobal && latencyClassOf(R.Producer) == LatencyClass::Atomic;
    if (R.Unknown || (Deferred && (R.IsPending || R.Ready > At)))
      return false;
  }
  return true;
}

/// The order of registers by who is waited for.
static auto waitOrder(const ModelRegister &R) {
  return std::tuple(R.IsPending, R.IsPending ? 0 : R.Ready, R.FromGlobal,
                    unsigned(R.Producer), R.Level);
}

const ModelRegister &ScoreboardModel::lastSource(const ModelThread &T,
                                                 const Instruction &I) const {
  const ModelRegister *Last = &T.Registers[sourcesOf(I)[0]];
  for (uint8_t Source : sourcesOf(I))
    if (waitOrder(T.Registers[Source]) > waitOrder(*Last))
      Last = &T.Registers[Source];
  return *Last;
}

bool ScoreboardModel::areSourcesReady(ModelThread &T, const Instruction &I) {
  const ModelRegister &Last = lastSource(T, I);
  if (Last.IsPending) {
    ++T.Uncharged;
    return false;
  }
  settle(T, I);
  if (Last.Ready <= Cycle)
    return true;
  loseTo(T, Last, 1);
  return false;
}

void ScoreboardModel::settle(ModelThread &T, const Instruction &I) {
  loseTo(T, lastSource(T, I), T.Uncharged);
  T.Uncharged = 0;
}

void ScoreboardModel::loseTo(ModelThread &T, const ModelRegister &Source,
                             uint64_t Cycles) {
  static constexpr Loss ByLevel[] = {Loss::L1,    Loss::L2,   Loss::Dram,
                                     Loss::Dram,  Loss::Dram, Loss::Dram,
                                     Loss::Memory};
  static_assert(std::size(ByLevel) == NumServedBy);
  Loss Reason =
      Source.FromGlobal ? ByLevel[unsigned(Source.Level)] : Loss::Data;
  loseToResult(T, Reason, Source.Producer, Cycles);
}

uint32_t ScoreboardModel::bankOf(const ModelThread &T) const {
  return (Text.textBegin() / 4 + Fetches[wordOf(T)]) % Chip.IcacheBanks;
}

bool ScoreboardModel::hasSlots(ModelThread &T, const Instruction &I,
                               const Started &S) {
  if (S.Banks[bankOf(T)] == Chip.IcachePorts) {
    lose(T, Loss::IcacheConflict);
    return false;
  }
  unsigned Type = unsigned(unitOf(I.Op));
  const UnitConfig &Config = Chip.Units[Type];
  if (Cycle % Config.Interval != 0 || S.Units[Type] == Config.Count) {
    ++Counts.UnitConflict[unsigned(I.Op)];
    lose(T, Loss::UnitConflict);
    return false;
  }
  return true;
}

void ScoreboardModel::takeSlots(const ModelThread &T, const Instruction &I,
                                Started &S) const {
  ++S.Banks[bankOf(T)];
  ++S.Units[unsigned(unitOf(I.Op))];
}

void ScoreboardModel::issue(ModelThread &T, const Instruction &I,
                            const ModelEffects &Effects) {
  if (Effects.HasResult)
    writeResult(T, I, Effects);
  bool IsLoad = Effects.FromGlobal && !Effects.Access;
  bool IsStore = Effects.Access && Effects.Access->Kind == ModelAccess::Store;
  if (Hierarchy && (Effects.FromGlobal || IsStore))
    request(T,
            IsLoad    ? RequestKind::Load
            : IsStore ? RequestKind::Store
                      : RequestKind::Atomic,
            I.Destination, Effects);
  if (Effects.Access) {
    ModelAccess &Access = Accesses.emplace_back(*Effects.Access);
    Access.Thread = T.Number;
    Access.Pc = T.Pc;
    Access.Cycle = Cycle;
    Access.Priority = priorityOf(T);
    Access.Destination = I.Destination;
    Access.Write = Writes;
  }
  ++Counts.Executed[unsigned(I.Op)];
  ++Counts.Pcs[wordOf(T)].Executed;
  Counts.GlobalAccesses +=
      Effects.FromGlobal ||
      (Effects.Access && Effects.Access->Kind != ModelAccess::HostCall);
  ++T.Counts.Instructions;
  T.NextIssue = Cycle + 1;
  T.Pc = Effects.Target.value_or(T.Pc + 4);
  if (Effects.Target) {
    T.NextIssue = Cycle + Chip.Latency[unsigned(LatencyClass::Branch)];
    T.Waiting = Loss::Branch;
  }
  switch (Effects.Then) {
  case ModelEffects::Next:
    break;
  case ModelEffects::Barrier:
    T.State = ModelThread::AtBarrier;
    return;
  case ModelEffects::Halt:
    T.State = ModelThread::Halted;
    T.Status = int32_t(Effects.Argument);
    T.Counts.FinishCycle = Cycle + 1;
    return;
  case ModelEffects::Sync:
    T.NextIssue = WindowEnd;
    T.Waiting = Loss::Sync;
    T.AwaitsStores = Hierarchy != nullptr;
    return;
  case ModelEffects::Sleep:
    T.NextIssue = Cycle + 1 + Effects.Argument;
    T.Waiting = Loss::Sleep;
    return;
  }
  // At the next cycle it is at the next instruction, past the messages.
  if (T.NextIssue == Cycle + 1)
    passMessages(T, Cycle + 1);
}

void ScoreboardModel::writeResult(ModelThread &T, const Instruction &I,
                                  const ModelEffects &Effects) {
  ModelRegister &R = T.Registers[I.Destination];
  uint32_t OfClass = Chip.Latency[unsigned(latencyClassOf(I.Op))];
  R.Ready = Cycle + Effects.Latency.value_or(OfClass);
  R.FromGlobal = Effects.FromGlobal;
  R.Producer = I.Op;
  R.Write = ++Writes;
  R.Unknown = Effects.Access.has_value();
  R.IsPending = Hierarchy && Effects.FromGlobal;
  R.Level = ServedBy::Memory;
  if (!R.Unknown)
    R.Value = Effects.Result;
}

void ScoreboardModel::lose(ModelThread &T, Loss Reason, uint64_t Cycles) {
  T.Counts.Lost[unsigned(Reason)] += Cycles;
  if (Reason != Loss::Finished)
    Counts.Pcs[T.LosingWord].Lost[unsigned(Reason)] += Cycles;
}

void ScoreboardModel::loseToResult(ModelThread &T, Loss Reason, Opcode Producer,
                                   uint64_t Cycles) {
  lose(T, Reason, Cycles);
  Counts.DataStall[unsigned(Producer)] += Cycles;
}

void ScoreboardModel::trap(ModelThread &T, uint32_t Pc, TrapKind Reason,
                           uint32_t Address) {
  T.State = ModelThread::Trapped;
  lose(T, Loss::Finished);
  keepFirstTrap({Reason, T.Number, Pc, Address, Cycle}, priorityOf(T));
}

uint32_t ScoreboardModel::priorityOf(const ModelThread &T) const {
  uint64_t First = WindowStart / Chip.ArbitrationWindow % Chip.TpsPerTm;
  uint64_t Tp = T.Number % Chip.TpsPerTm;
  return uint32_t((Tp + Chip.TpsPerTm - First) % Chip.TpsPerTm);
}

void ScoreboardModel::keepFirstTrap(const Trap &Info, uint32_t Priority) {
  auto Order = [&](const Trap &Each, uint32_t ItsPriority) {
    return std::tuple(Each.Cycle, ItsPriority, Each.Thread / Chip.TpsPerTm);
  };
  if (FirstTrap && Order(*FirstTrap, FirstTrapPriority) < Order(Info, Priority))
    return;
  FirstTrap = Info;
  FirstTrapPriority = Priority;
}

bool ScoreboardModel::isLocal(uint32_t Address) const {
  return Chip.LocalStoreBytes != 0 && Address >= localBegin() &&
         Address < 0 - kLocalStoreReservedBytes;
}

bool ScoreboardModel::isGlobal(uint32_t Address) const {
  return Address >= kGlobalMemoryBegin && Address < Chip.MemoryBytes;
}

bool ScoreboardModel::isReadOnly(uint32_t Address) const {
  return Address >= Text.textBegin() && Address < Text.readOnlyEnd();
}

uint32_t ScoreboardModel::loadWord(uint32_t Address) const {
  uint32_t Value;
  std::memcpy(&Value, Global.data() + Address, 4);
  return Value;
}

/// Memory for stream operations. A failed one reads zeros and writes nothing
/// more.
class ScoreboardModel::Streams final : public StreamMemory {
public:
  Streams(ScoreboardModel &Model, uint32_t Descriptor)
      : Model(Model), Descriptor(Descriptor) {}

  std::optional<std::pair<TrapKind, uint32_t>> Failure;

  uint32_t load(uint32_t Address) override {
    check(Address);
    return Failure ? 0 : Model.loadWord(Address);
  }
  void store(uint32_t Address, uint32_t Value) override {
    check(Address);
    if (!Failure)
      std::memcpy(Model.Global.data() + Address, &Value, 4);
  }
  void reject() override { fail(TrapKind::BadStream, Descriptor); }

private:
  void check(uint32_t Address) {
    if (!Model.isGlobal(Address))
      fail(TrapKind::AddressOutOfRange, Address);
    else if (Model.isReadOnly(Address))
      fail(TrapKind::StoreToReadOnly, Address);
  }
  void fail(TrapKind Kind, uint32_t Address) {
    if (!Failure)
      Failure.emplace(Kind, Address);
  }

  ScoreboardModel &Model;
  const uint32_t Descriptor;
};

void ScoreboardModel::commit(const ModelAccess &Access) {
  Trap Bad;
  std::optional<uint32_t> Result;
  switch (Access.Kind) {
  case ModelAccess::Store:
    std::memcpy(Global.data() + Access.Address, &Access.Value, Access.Bytes);
    return;
  case ModelAccess::Atomic: {
    Result = loadWord(Access.Address);
    uint32_t New = Access.OnWord(*Result, Access.Value, Access.Extra);
    std::memcpy(Global.data() + Access.Address, &New, 4);
    break;
  }
  case ModelAccess::Stream: {
    Streams Rings(*this, Access.Address);
    Result = Access.OnStream(Rings, Access.Address, Access.Value);
    if (Rings.Failure) {
      std::tie(Bad.Kind, Bad.Address) = *Rings.Failure;
      Result.reset();
    }
    break;
  }
  case ModelAccess::HostCall:
    Result = hostCall(Access, Bad);
    break;
  }
  if (!Result) {
    Bad.Thread = Access.Thread;
    Bad.Pc = Access.Pc;
    Bad.Cycle = Access.Cycle;
    return keepFirstTrap(Bad, Access.Priority);
  }
  ModelRegister &R = Threads[Access.Thread].Registers[Access.Destination];
  if (R.Write != Access.Write)
    return;
  R.Value = *Result;
  R.Unknown = false;
}

std::optional<uint32_t> ScoreboardModel::hostCall(const ModelAccess &Access,
                                                  Trap &Bad) {
  bool IsWrite = Access.Service == kHostCallWrite &&
                 (Access.Extra == 1 || Access.Extra == 2);
  Bad.Kind = TrapKind::BadHostCall;
  Bad.Address = Access.Service;
  if (!IsWrite)
    return std::nullopt;
  uint32_t Bytes = std::min(Access.Value, 4096u);
  for (uint32_t I = 0; I != Bytes; ++I) {
    uint32_t At = Access.Address + I;
    if (isGlobal(At)) {
      Output += char(Global.data()[At]);
    } else if (isLocal(At)) {
      Output += char(Threads[Access.Thread].LocalStore[At - localBegin()]);
    } else {
      Output.resize(Output.size() - I);
      Bad.Kind = Access.Address < kGlobalMemoryBegin
                     ? TrapKind::NullAccess
                     : TrapKind::AddressOutOfRange;
      Bad.Address = Access.Address;
      return std::nullopt;
    }
  }
  return Bytes;
}

void ScoreboardModel::endWindow() {
  for (const ModelAccess &Access : Accesses)
    commit(Access);
  Accesses.clear();
  releaseBarrier();
}

void ScoreboardModel::releaseBarrier() {
  for (const ModelThread &T : Threads)
    if (T.State != ModelThread::AtBarrier && T.State != ModelThread::Halted)
      return;
  for (ModelThread &T : Threads)
    if (T.State == ModelThread::AtBarrier)
      T.State = ModelThread::Running;
}

void ScoreboardModel::cutToLastHalt() {
  uint64_t Last = 0;
  for (const ModelThread &T : Threads)
    Last = std::max(Last, T.Counts.FinishCycle);
  for (ModelThread &T : Threads)
    T.Counts.Lost[unsigned(Loss::Finished)] -= Cycle - Last;
  Cycle = Last;
}

} // namespace tp::test
