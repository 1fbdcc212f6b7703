//===- FunctionalContext.h - The machine without its timing -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALCONTEXT_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALCONTEXT_H

#include "simulator/core/ContextFloats.h"
#include "simulator/core/HostServices.h"
#include "simulator/core/SpecialRegisters.h"
#include "simulator/functional/Checks.h"
#include "simulator/functional/FunctionalThread.h"
#include "simulator/isa/Bodies.h"

#include <cstring>
#include <type_traits>

namespace tp {

/// The context of one instruction in the functional mode (see Bodies.h):
/// everything takes effect at once. It tells \p Checks what is done.
template <Subnormals Mode, class Checks = NoChecks>
class FunctionalContext
    : public ContextFloats<FunctionalContext<Mode, Checks>, Mode> {
public:
  /// What becomes of the thread after the instruction.
  enum class Outcome : uint8_t {
    /// It goes on with the next instruction.
    Next,
    /// It goes on with instruction targetWord() of the text.
    Branch,
    /// Its turn is over; it goes on with the next instruction.
    Yield,
    /// The instruction traps.
    Trap,
  };

  /// \p Issued are the instructions that the thread has issued before.
  FunctionalContext(FunctionalThread &T, FunctionalContextState &Shared,
                    uint32_t Pc, uint64_t Issued)
      : T(T), Shared(Shared), Pc(Pc), Issued(Issued) {}

  Outcome outcome() const { return Kind; }
  bool hasTrapped() const { return Kind == Outcome::Trap; }
  uint32_t targetWord() const { return TargetWord; }
  TrapKind trapReason() const { return TrapReason; }
  uint32_t trapAddress() const { return Address; }
  bool keepsDestination() const { return KeepsDestination; }

  void trap(TrapKind Reason, uint32_t DataAddress = 0) {
    Kind = Outcome::Trap;
    TrapReason = Reason;
    Address = DataAddress;
  }

  void branch(int32_t Offset) { jump(Pc + uint32_t(Offset)); }
  void jump(uint32_t NewTarget) {
    uint32_t Offset = NewTarget - Shared.Space.TextBegin;
    if (Offset % 4 != 0 || Offset / 4 >= Shared.Space.TextWords) [[unlikely]]
      return trap(TrapKind::FetchOutsideText, NewTarget);
    Kind = Outcome::Branch;
    TargetWord = Offset / 4;
  }
  uint32_t link() const { return Pc + 4; }
  void keepDestination() { KeepsDestination = true; }

  template <class V> [[gnu::always_inline]] V load(uint32_t At) {
    if (At % sizeof(V) != 0) [[unlikely]]
      return trap(TrapKind::MisalignedAccess, At), V();
    if (Shared.Space.isLocal(At))
      return checkedLoad<V>(At, localPointer(At), /*IsLocal=*/true);
    if (!Shared.Space.isGlobal(At)) [[unlikely]]
      return trap(AddressSpace::badAddress(At), At), V();
    return checkedLoad<V>(At, Shared.Space.Global + At, /*IsLocal=*/false);
  }

  template <class V> [[gnu::always_inline]] void store(uint32_t At, V Value) {
    if (At % sizeof(V) != 0) [[unlikely]]
      return trap(TrapKind::MisalignedAccess, At);
    uint8_t *Target = writable(At);
    if (!Target)
      return;
    checks().store(Step, accessTo(At, sizeof(V), Target));
    std::memcpy(Target, &Value, sizeof(Value));
  }

  template <class Function>
  uint32_t atomic(uint32_t At, uint32_t Operand, uint32_t Expected,
                  Function Update) {
    if (At % 4 != 0) [[unlikely]]
      return trap(TrapKind::MisalignedAccess, At), 0;
    uint8_t *Target = writable(At);
    if (!Target)
      return 0;
    checks().atomic(Step, accessTo(At, sizeof(uint32_t), Target));
    uint32_t Old = hostLoad<uint32_t>(Target);
    uint32_t New = Update(Old, Operand, Expected);
    std::memcpy(Target, &New, sizeof(New));
    return Old;
  }

  template <class Function>
  uint32_t stream(uint32_t Descriptor, uint32_t Value, Function Operation) {
    if (Descriptor % 4 != 0)
      return trap(TrapKind::MisalignedAccess, Descriptor), 0;
    if (Shared.Space.isLocal(Descriptor))
      return trap(TrapKind::BadStream, Descriptor), 0;
    if (!Shared.Space.isWritable(Descriptor))
      return trap(Shared.Space.badStore(Descriptor), Descriptor), 0;
    SharedStreamMemory Memory(Shared.Space, Descriptor);
    uint32_t Result;
    if constexpr (std::is_same_v<Checks, NoChecks>) {
      Result = Operation(Memory, Descriptor, Value);
    } else {
      CheckedStreamMemory Checked(*this, Memory);
      Result = Operation(Checked, Descriptor, Value);
    }
    if (Memory.failed())
      trap(Memory.kind(), Memory.address());
    return Result;
  }

  uint32_t hostCall(uint32_t Service, uint32_t First, uint32_t Second,
                    uint32_t Third) {
    Trap Bad;
    std::optional<uint32_t> Answer =
        serveHostCall({Service, First, Second, Third}, Shared.Space,
                      T.LocalStoreBias, Shared.Output, Bad);
    if (!Answer)
      return trap(Bad.Kind, Bad.Address), 0;
    checks().output(T, Pc, Second, *Answer);
    return *Answer;
  }

  /// Who waits for others lets them have their turns.
  void sync() {
    checks().sync(T, Pc);
    Kind = Outcome::Yield;
  }
  void sleep(uint32_t Cycles) {
    T.Slept += Cycles;
    Kind = Outcome::Yield;
  }

  void barrier() {
    checks().barrier(T, Pc);
    T.State = ThreadState::AtBarrier;
    ++Shared.Arrived;
    Kind = Outcome::Yield;
  }

  void halt(int32_t Status) {
    T.State = ThreadState::Halted;
    T.Status = Status;
    ++Shared.Halted;
    Kind = Outcome::Yield;
  }

  void marker(uint32_t Number) {
    if (Number >= Shared.Markers.size())
      Shared.Markers.resize(Number + 1);
    ++Shared.Markers[Number];
    if (Number == Shared.StopMarker) {
      T.AtMarker = true;
      Kind = Outcome::Yield;
    }
  }

  void profileValue(uint32_t Marker, uint32_t Value) {
    checks().message(T, Pc, Marker, Value);
    if (Shared.Observer)
      Shared.Observer->profileValue(T.Number, Marker, Value);
  }

  /// A cycle for each instruction and what the thread slept.
  uint32_t special(SpecialRegister Register) const {
    return readSpecial(
        Register, *Shared.Chip, T.Number, [&] { return Issued + T.Slept; },
        [&] { return Issued; });
  }

  /// Of the instruction.
  typename Checks::Step Step;

private:
  /// The words of a stream operation, each told to the checks.
  class CheckedStreamMemory final : public StreamMemory {
  public:
    CheckedStreamMemory(FunctionalContext &Context, SharedStreamMemory &Memory)
        : Context(Context), Memory(Memory) {}

    uint32_t load(uint32_t Address) override {
      uint32_t Value = Memory.load(Address);
      if (!Memory.failed())
        Context.checks().streamLoad(Context.Step, access(Address));
      return Value;
    }
    void store(uint32_t Address, uint32_t Value) override {
      if (Memory.check(Address))
        Context.checks().streamStore(Context.Step, access(Address));
      Memory.store(Address, Value);
    }
    void reject() override { Memory.reject(); }

  private:
    CheckedAccess access(uint32_t Address) const {
      return Context.accessTo(Address, sizeof(uint32_t),
                              Context.Shared.Space.Global + Address);
    }

    FunctionalContext &Context;
    SharedStreamMemory &Memory;
  };

  decltype(auto) checks() { return Checks::of(Shared); }
  CheckedAccess accessTo(uint32_t At, uint32_t Bytes, const uint8_t *Host) {
    return {T,
            Pc,
            At,
            Bytes,
            Host,
            Shared.Space.isLocal(At),
            Shared.IssuedByOthers + Issued};
  }
  uint8_t *localPointer(uint32_t At) const {
    return reinterpret_cast<uint8_t *>(T.LocalStoreBias + At);
  }
  /// Where a store to \p At goes; null if it traps.
  uint8_t *writable(uint32_t At) {
    if (Shared.Space.isLocal(At))
      return localPointer(At);
    if (!Shared.Space.isWritable(At)) [[unlikely]] {
      trap(Shared.Space.badStore(At), At);
      return nullptr;
    }
    return Shared.Space.Global + At;
  }

  template <class V>
  [[gnu::always_inline]] V checkedLoad(uint32_t At, const uint8_t *Source,
                                       bool IsLocal) {
    checks().load(Step, {T, Pc, At, sizeof(V), Source, IsLocal});
    return hostLoad<V>(Source);
  }

  template <class V> static V hostLoad(const uint8_t *Source) {
    V Value;
    std::memcpy(&Value, Source, sizeof(Value));
    return Value;
  }

  FunctionalThread &T;
  FunctionalContextState &Shared;
  const uint32_t Pc;
  const uint64_t Issued;
  Outcome Kind = Outcome::Next;
  bool KeepsDestination = false;
  TrapKind TrapReason = TrapKind::IllegalInstruction;
  uint32_t TargetWord = 0;
  uint32_t Address = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALCONTEXT_H
