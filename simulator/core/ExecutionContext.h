//===- ExecutionContext.h - The machine as a body sees it -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_EXECUTIONCONTEXT_H
#define TP_SIMULATOR_CORE_EXECUTIONCONTEXT_H

#include "simulator/core/ContextFloats.h"
#include "simulator/core/SpecialRegisters.h"
#include "simulator/core/TmRunner.h"
#include "simulator/isa/Bodies.h"

#include <cstring>

namespace tp {

/// The context of one instruction in the cycle model (see Bodies.h). It lives
/// in registers of the host: what a body does not use costs nothing.
template <Opcode Op, Subnormals Mode>
class ExecutionContext
    : public ContextFloats<ExecutionContext<Op, Mode>, Mode> {
public:
  /// What becomes of the thread after the instruction.
  enum class Outcome : uint8_t {
    /// It goes on with the next instruction in the next cycle.
    Next,
    /// It goes on with instruction TargetWord of the text.
    Branch,
    /// It goes on with the next instruction in the cycle NextCycle of the
    /// runner.
    Leave,
    /// The instruction traps: TrapReason, Address.
    Trap,
    /// The instruction has not been executed: it must wait for the end of the
    /// window, for the result of Blocker.
    Blocked,
    /// The instruction has not been executed: its store found the store buffer
    /// full.
    StoreBufferFull,
  };

  /// \p Counts are those of the instruction, at \p Word of the text.
  ExecutionContext(Thread &T, TmRunnerState &Runner, uint32_t Word,
                   IssueCounts &Counts, uint64_t Cycle, uint8_t Destination,
                   ReadyWord Result)
      : T(T), Runner(Runner), Word(Word), Counts(Counts), Cycle(Cycle),
        Destination(Destination),
        ResultReady(ReadyWord(Cycle << ready::CycleShift) + Result) {}

  Outcome outcome() const { return Kind; }
  bool hasTrapped() const { return Kind == Outcome::Trap; }
  /// Number of the next instruction in the text after Outcome::Branch.
  uint32_t targetWord() const { return TargetWord; }
  TrapKind trapReason() const { return TrapReason; }
  uint32_t trapAddress() const { return Address; }
  Opcode blocker() const { return Blocker; }
  /// When the destination is ready.
  ReadyWord resultReady() const { return ResultReady; }
  bool keepsDestination() const { return KeepsDestination; }
  /// The destination is written later, by the window's commit.
  bool isDeferred() const { return Deferred; }

  void trap(TrapKind Reason, uint32_t DataAddress = 0) {
    Kind = Outcome::Trap;
    TrapReason = Reason;
    Address = DataAddress;
  }

  void branch(int32_t Offset) { jump(pc() + uint32_t(Offset)); }
  void jump(uint32_t NewTarget) {
    uint32_t Offset = NewTarget - Runner.Chip.TextBegin;
    if (Offset % 4 != 0 || Offset / 4 >= Runner.Chip.TextWords) [[unlikely]]
      return trap(TrapKind::FetchOutsideText, NewTarget);
    Kind = Outcome::Branch;
    TargetWord = Offset / 4;
  }
  uint32_t link() const { return pc() + 4; }
  void keepDestination() { KeepsDestination = true; }

  template <class T> [[gnu::always_inline]] T load(uint32_t At) {
    if (At % sizeof(T) != 0) [[unlikely]]
      return trap(TrapKind::MisalignedAccess, At), T();
    if (isLocal(At)) {
      ResultReady = readyAfter(LocalStoreLatency, false);
      return hostLoad<T>(localPointer(At));
    }
    if (!Runner.Chip.isGlobal(At)) [[unlikely]]
      return trap(AddressSpace::badAddress(At), At), T();
    T Value = hostLoad<T>(Runner.Chip.Global + At);
    if (Runner.OwnWords & Runner.wordBit(At)) [[unlikely]] {
      uint32_t Bits = 0;
      std::memcpy(&Bits, &Value, sizeof(T));
      if (std::optional<Opcode> Producer =
              Runner.forwardOwn(At, sizeof(T), Bits)) {
        Kind = Outcome::Blocked;
        Blocker = *Producer;
        return T();
      }
      std::memcpy(&Value, &Bits, sizeof(T));
    }
    ++Counts.Global;
    ResultReady = Runner.Memory ? Runner.requestLoad(this->T, Word, Destination,
                                                     Op, Cycle, At, sizeof(T))
                                : readyAfter(Runner.Chip.MemoryLatency, true);
    return Value;
  }

  template <class T> [[gnu::always_inline]] void store(uint32_t At, T Value) {
    if (At % sizeof(T) != 0) [[unlikely]]
      return trap(TrapKind::MisalignedAccess, At);
    if (isLocal(At)) {
      std::memcpy(localPointer(At), &Value, sizeof(T));
      return;
    }
    if (!Runner.Chip.isWritable(At)) [[unlikely]]
      return trap(Runner.Chip.badStore(At), At);
    if (Runner.Memory && !Runner.requestStore(this->T, Word, Cycle, At,
                                              sizeof(T))) [[unlikely]] {
      Kind = Outcome::StoreBufferFull;
      return;
    }
    ++Counts.Global;
    GlobalAccess &Access = log(GlobalAccess::Store, At, Value);
    Access.Bytes = sizeof(T);
    Runner.OwnWords |= Runner.wordBit(At);
  }

  uint32_t atomic(uint32_t At, uint32_t Operand, uint32_t Expected,
                  AtomicFunction Function) {
    if (At % 4 != 0) [[unlikely]]
      return trap(TrapKind::MisalignedAccess, At), 0;
    if (isLocal(At)) {
      uint32_t Old = hostLoad<uint32_t>(localPointer(At));
      uint32_t New = Function(Old, Operand, Expected);
      std::memcpy(localPointer(At), &New, sizeof(New));
      ResultReady = readyAfter(LocalStoreLatency, false);
      return Old;
    }
    if (!Runner.Chip.isWritable(At)) [[unlikely]]
      return trap(Runner.Chip.badStore(At), At), 0;
    deferToMemory(At);
    GlobalAccess &Access = log(GlobalAccess::Atomic, At, Operand);
    Access.AtomicOperation = Function;
    Access.Extra = Expected;
    Runner.OwnWords |= Runner.wordBit(At);
    return 0;
  }

  uint32_t stream(uint32_t Descriptor, uint32_t Value,
                  StreamFunction Function) {
    if (Descriptor % 4 != 0)
      return trap(TrapKind::MisalignedAccess, Descriptor), 0;
    if (isLocal(Descriptor))
      return trap(TrapKind::BadStream, Descriptor), 0;
    if (!Runner.Chip.isWritable(Descriptor))
      return trap(Runner.Chip.badStore(Descriptor), Descriptor), 0;
    deferToMemory(Descriptor);
    GlobalAccess &Access = log(GlobalAccess::Stream, Descriptor, Value);
    Access.StreamOperation = Function;
    Runner.OwnWords = ~uint64_t(0);
    return 0;
  }

  /// The thread waits until the call is done at the end of the window.
  uint32_t hostCall(uint32_t Service, uint32_t First, uint32_t Second,
                    uint32_t Third) {
    defer(ready::after(0, Op) + ReadyWord(Runner.End << ready::CycleShift));
    GlobalAccess &Access = log(GlobalAccess::HostCall, Second, Third);
    Access.Service = Service;
    Access.Extra = First;
    sync();
    return 0;
  }

  void sync() {
    charge(Loss::Sync, Runner.End - (Cycle + 1));
    leaveUntil(Runner.Epoch + Runner.End);
    if (Runner.Memory)
      Runner.awaitStores(T);
  }

  void sleep(uint32_t Cycles) {
    charge(Loss::Sleep, Cycles);
    leaveUntil(now() + 1 + Cycles);
  }

  void barrier() {
    T.State = ThreadState::AtBarrier;
    T.EndCycle = now() + 1;
    T.LastWord = Word;
    ++Runner.Arrived;
    leaveUntil(NeverCycle);
  }

  void halt(int32_t Status) {
    T.State = ThreadState::Halted;
    T.EndCycle = now() + 1;
    T.Status = Status;
    ++Runner.Halted;
    leaveUntil(NeverCycle);
  }

  void marker(uint32_t Number) { Runner.countMarker(Number); }

  void profileValue(uint32_t Marker, uint32_t Value) {
    if (Runner.Chip.Observer)
      Runner.Chip.Observer->profileValue(T.Number, Marker, Value);
  }

  uint32_t special(SpecialRegister Register) const {
    auto Now = [this] { return now(); };
    return readSpecial(Register, *Runner.Chip.Chip, T.Number, Now,
                       [&] { return now() - T.totalLost(); });
  }

private:
  uint64_t now() const { return Runner.Epoch + Cycle; }
  /// The instruction's number in the text.
  uint32_t pc() const { return Runner.Chip.TextBegin + Word * 4; }

  ReadyWord readyAfter(uint32_t Latency, bool FromGlobal) const {
    return ReadyWord(Cycle << ready::CycleShift) +
           ready::after(Latency, Op, FromGlobal);
  }

  bool isLocal(uint32_t At) const { return Runner.Chip.isLocal(At); }
  uint8_t *localPointer(uint32_t At) const {
    return reinterpret_cast<uint8_t *>(T.LocalStoreBias + At);
  }

  template <class V> static V hostLoad(const uint8_t *Source) {
    V Value;
    std::memcpy(&Value, Source, sizeof(Value));
    return Value;
  }

  /// The result comes with the window's commit.
  void defer(ReadyWord When) {
    ResultReady = When;
    Deferred = true;
  }

  void deferToMemory(uint32_t At) {
    ++Counts.Global;
    defer(Runner.Memory
              ? Runner.requestAtomic(T, Word, Destination, Op, Cycle, At)
              : readyAfter(Runner.Chip.MemoryLatency, true));
  }

  GlobalAccess &log(GlobalAccess::AccessKind AccessKind, uint32_t At,
                    uint32_t Value) {
    GlobalAccess &Access = Runner.appendToLog();
    Access.Key = Runner.keyAt(Cycle);
    Access.Owner = &T;
    Access.Address = At;
    Access.Value = Value;
    Access.Pc = pc();
    Access.Ready = ResultReady;
    Access.Kind = AccessKind;
    Access.Destination = Destination;
    return Access;
  }

  void charge(Loss Reason, uint64_t Cycles) {
    Runner.charge(T, Word, Reason, Cycles);
  }

  void leaveUntil(uint64_t NextCycle) {
    Kind = Outcome::Leave;
    Runner.NextCycle = NextCycle;
  }

  Thread &T;
  TmRunnerState &Runner;
  /// Of the text.
  const uint32_t Word;
  IssueCounts &Counts;
  const uint64_t Cycle;
  const uint8_t Destination;
  ReadyWord ResultReady;
  Outcome Kind = Outcome::Next;
  bool KeepsDestination = false;
  bool Deferred = false;
  TrapKind TrapReason = TrapKind::IllegalInstruction;
  Opcode Blocker = Op;
  uint32_t TargetWord = 0;
  uint32_t Address = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_EXECUTIONCONTEXT_H
