//===- ModelContext.h - The machine as a body sees it, naively --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_ORACLE_MODELCONTEXT_H
#define TP_TEST_UNIT_ORACLE_MODELCONTEXT_H

#include "simulator/isa/Bodies.h"
#include "test/unit/oracle/ScoreboardModel.h"

#include <cstring>

namespace tp::test {

/// The context of one instruction in the model (see Bodies.h): notes what it
/// wants. Only the local store, which nobody else sees, is written at once.
template <Subnormals Mode> class ModelContext {
public:
  ModelContext(ScoreboardModel &Model, ModelThread &T, Opcode Op)
      : Model(Model), T(T), Op(Op) {}

  ModelEffects Effects;

  void trap(TrapKind Reason, uint32_t Address = 0) {
    Effects.TrapReason = Reason;
    Effects.TrapAddress = Address;
  }

  float operand(float Value) {
    return checked(Value, FloatRules<Mode>::operand(Value),
                   TrapKind::SubnormalOperand);
  }
  float result(float Value) {
    return checked(Value, FloatRules<Mode>::result(Value),
                   TrapKind::SubnormalResult);
  }

  void branch(int32_t Offset) { jump(T.Pc + uint32_t(Offset)); }
  void jump(uint32_t Target) {
    bool InText = Target % 4 == 0 && Target >= Model.Text.textBegin() &&
                  Target < Model.Text.textEnd();
    if (InText)
      Effects.Target = Target;
    else
      trap(TrapKind::FetchOutsideText, Target);
  }
  uint32_t link() const { return T.Pc + 4; }
  void keepDestination() { Keeps = true; }
  bool keeps() const { return Keeps; }

  template <class V> V load(uint32_t At) {
    if (At % sizeof(V) != 0)
      return trap(TrapKind::MisalignedAccess, At), V();
    if (!Model.isLocal(At) && !Model.isGlobal(At))
      return trapBadAddress(At), V();
    bool Local = Model.isLocal(At);
    Effects.Latency = Local ? 1 : Model.Chip.MemoryLatency;
    Effects.FromGlobal = !Local;
    Effects.Address = At;
    Effects.Bytes = sizeof(V);
    uint8_t Bytes[sizeof(V)];
    for (unsigned I = 0; I != sizeof(V); ++I)
      Bytes[I] = Local ? T.LocalStore[At + I - Model.localBegin()]
                       : globalByte(At + I);
    V Value;
    std::memcpy(&Value, Bytes, sizeof(V));
    return Value;
  }

  template <class V> void store(uint32_t At, V Value) {
    if (!mayStore(At, sizeof(V)))
      return;
    if (Model.isLocal(At)) {
      std::memcpy(&T.LocalStore[At - Model.localBegin()], &Value, sizeof(V));
      return;
    }
    ModelAccess &Access = access(ModelAccess::Store, At, uint32_t(Value));
    Access.Bytes = sizeof(V);
  }

  uint32_t atomic(uint32_t At, uint32_t Operand, uint32_t Expected,
                  ModelAccess::AtomicFunction Function) {
    if (!mayStore(At, 4))
      return 0;
    if (Model.isLocal(At)) {
      uint8_t *Word = &T.LocalStore[At - Model.localBegin()];
      uint32_t Old;
      std::memcpy(&Old, Word, 4);
      uint32_t New = Function(Old, Operand, Expected);
      std::memcpy(Word, &New, 4);
      Effects.Latency = 1;
      return Old;
    }
    ModelAccess &Access = access(ModelAccess::Atomic, At, Operand);
    Access.OnWord = Function;
    Access.Extra = Expected;
    fromGlobal();
    return 0;
  }

  uint32_t stream(uint32_t Descriptor, uint32_t Value,
                  ModelAccess::StreamFunction Function) {
    if (Descriptor % 4 == 0 && Model.isLocal(Descriptor))
      return trap(TrapKind::BadStream, Descriptor), 0;
    if (!mayStore(Descriptor, 4))
      return 0;
    access(ModelAccess::Stream, Descriptor, Value).OnStream = Function;
    fromGlobal();
    return 0;
  }

  uint32_t hostCall(uint32_t Service, uint32_t First, uint32_t Second,
                    uint32_t Third) {
    ModelAccess &Access = access(ModelAccess::HostCall, Second, Third);
    Access.Extra = First;
    Access.Service = Service;
    Effects.Latency = uint32_t(Model.WindowEnd - Model.Cycle);
    sync();
    return 0;
  }

  void barrier() { Effects.Then = ModelEffects::Barrier; }
  void sync() { Effects.Then = ModelEffects::Sync; }
  void sleep(uint32_t Cycles) {
    Effects.Then = ModelEffects::Sleep;
    Effects.Argument = Cycles;
  }
  void halt(uint32_t Status) {
    Effects.Then = ModelEffects::Halt;
    Effects.Argument = Status;
  }

  void marker(uint32_t Number) {
    std::vector<uint64_t> &Markers = Model.Counts.Markers;
    if (Markers.size() <= Number)
      Markers.resize(Number + 1);
    ++Markers[Number];
  }
  void profileValue(uint32_t Marker, uint32_t Value) {
    T.ProfileValues.push_back({Marker, Value});
  }

  uint32_t special(SpecialRegister Register) const {
    const ChipConfig &Chip = Model.Chip;
    switch (Register) {
    case SpecialRegister::thread:
      return T.Number;
    case SpecialRegister::tp:
      return T.Number % Chip.TpsPerTm;
    case SpecialRegister::tm:
      return T.Number / Chip.TpsPerTm;
    case SpecialRegister::nthread:
      return Chip.TmCount * Chip.TpsPerTm;
    case SpecialRegister::ntp:
      return Chip.TpsPerTm;
    case SpecialRegister::ntm:
      return Chip.TmCount;
    case SpecialRegister::lssize:
      return Chip.LocalStoreBytes;
    case SpecialRegister::cycle:
      return uint32_t(Model.Cycle);
    case SpecialRegister::cycleh:
      return uint32_t(Model.Cycle >> 32);
    case SpecialRegister::instret:
      return uint32_t(T.Counts.Instructions);
    case SpecialRegister::instreth:
      return uint32_t(T.Counts.Instructions >> 32);
    }
    __builtin_unreachable();
  }

private:
  float checked(float Before, float After, TrapKind Reason) {
    bool Flushed = Before != 0 && isBelowNormal(Before);
    if (Mode == Subnormals::Trap && Flushed && !Effects.TrapReason)
      trap(Reason, toBits(Before));
    return After;
  }

  void trapBadAddress(uint32_t At) {
    trap(At < kGlobalMemoryBegin ? TrapKind::NullAccess
                                 : TrapKind::AddressOutOfRange,
         At);
  }

  bool mayStore(uint32_t At, unsigned Bytes) {
    if (At % Bytes != 0)
      trap(TrapKind::MisalignedAccess, At);
    else if (Model.isGlobal(At) && Model.isReadOnly(At))
      trap(TrapKind::StoreToReadOnly, At);
    else if (!Model.isGlobal(At) && !Model.isLocal(At))
      trapBadAddress(At);
    return !Effects.TrapReason;
  }

  /// Memory as of the window's start, and over it what the thread itself did
  /// since; the newest says what is there.
  uint8_t globalByte(uint32_t At) {
    for (size_t I = Model.Accesses.size(); I != 0; --I) {
      const ModelAccess &Own = Model.Accesses[I - 1];
      if (Own.Thread != T.Number || Own.Kind == ModelAccess::HostCall)
        continue;
      bool Touches = At - Own.Address < Own.Bytes;
      if (Own.Kind == ModelAccess::Stream ||
          (Own.Kind == ModelAccess::Atomic && Touches)) {
        block(I);
        return 0;
      }
      if (Own.Kind == ModelAccess::Store && Touches)
        return uint8_t(Own.Value >> (At - Own.Address) * 8);
    }
    return Model.Global.data()[At];
  }

  /// Of several accesses that would have to be waited for, the newest counts.
  void block(size_t Access) {
    if (Access <= BlockingAccess)
      return;
    BlockingAccess = Access;
    Effects.Blocker = Model.Accesses[Access - 1].Op;
  }

  void fromGlobal() {
    Effects.Latency = Model.Chip.MemoryLatency;
    Effects.FromGlobal = true;
  }

  ModelAccess &access(ModelAccess::AccessKind Kind, uint32_t Address,
                      uint32_t Value) {
    ModelAccess Access;
    Access.Kind = Kind;
    Access.Address = Address;
    Access.Value = Value;
    Access.Op = Op;
    return Effects.Access.emplace(Access);
  }

  ScoreboardModel &Model;
  ModelThread &T;
  const Opcode Op;
  bool Keeps = false;
  size_t BlockingAccess = 0;
};

} // namespace tp::test

#endif // TP_TEST_UNIT_ORACLE_MODELCONTEXT_H
