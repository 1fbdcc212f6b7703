//===- MemoryChecks.h - Bad accesses and undefined values -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What stands in this file is done for each instruction of a run: a look
// whether an access is allowed and whether an operand is undefined. Everything
// else is in MemoryChecks.cpp.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_MEMORYCHECKS_H
#define TP_SIMULATOR_CHECK_MEMORYCHECKS_H

#include "simulator/check/CheckedProgram.h"
#include "simulator/check/HeapBlocks.h"
#include "simulator/check/ShadowMemory.h"
#include "simulator/check/ThreadShadow.h"
#include "simulator/check/UndefinedOrigins.h"
#include "simulator/functional/Checks.h"
#include "simulator/isa/StreamAccess.h"

#include <memory>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace tp {

/// Bytes behind each block of the heap that nobody may access.
inline constexpr uint32_t HeapPaddingBytes = 16;

/// Which faults are shown.
struct MemoryCheckOptions {
  /// Accesses outside of objects, to memory given back; bad frees.
  bool Memory = false;
  /// Undefined values that reach a branch, an address or an output.
  bool Init = false;
  /// Accesses below the stack pointer, stack overflows.
  bool Stack = false;
};

/// The checks memory, init and stack.
class MemoryChecks : public ExecutionChecks {
public:
  /// Undefined bits of what the instruction loads and stores, and where they
  /// come from.
  struct Step {
    UndefinedBits Loaded = 0;
    UndefinedBits Stored = 0;
    OriginId LoadedOrigin = NoOrigin;
    OriginId StoredOrigin = NoOrigin;
    /// Of a stream operation, where the stream's words begin, behind the
    /// descriptor.
    uint32_t StreamWords = 0;
  };

  /// The arguments must outlive it.
  MemoryChecks(const MemoryCheckOptions &Wanted, CheckedProgram &Program);

  static MemoryChecks &of(FunctionalContextState &Shared) {
    return static_cast<MemoryChecks &>(*Shared.Checks);
  }

  std::vector<FunctionalSlot> decode(const tp::Program &Text,
                                     bool FlushToZero) override;
  void start(const AddressSpace &Space, const ChipConfig &Chip,
             std::span<const FunctionalThread> Threads) override;
  /// Why there can be no run after start(); empty if there can.
  const std::string &error() const { return Error; }

  /// The run has ended by a trap of the thread.
  void trapped(const Trap &Why);
  /// The program has left this as its result.
  void checkResult(uint32_t Address, uint64_t Bytes, const char *Name);

  template <Opcode Op, class BodyType>
  [[gnu::always_inline]] void before(Step &, FunctionalThread &T, uint32_t Pc,
                                     const Instruction &Decoded,
                                     const BodyType &Run);
  template <Opcode Op, class BodyType>
  [[gnu::always_inline]] void after(Step &, FunctionalThread &T, uint32_t Pc,
                                    const Instruction &Decoded,
                                    const BodyType &Run, bool KeepsDestination);
  template <Opcode Op>
  [[gnu::always_inline]] void branched(FunctionalThread &T, uint32_t Pc,
                                       const Instruction &Decoded,
                                       uint32_t Target);
  void stackMoved(FunctionalThread &T, uint32_t Pc);

  [[gnu::always_inline]] void load(Step &S, const CheckedAccess &A);
  [[gnu::always_inline]] void store(Step &S, const CheckedAccess &A);
  void atomic(Step &S, const CheckedAccess &A);
  void streamLoad(Step &S, const CheckedAccess &A);
  void streamStore(Step &S, const CheckedAccess &A);
  void output(FunctionalThread &T, uint32_t Pc, uint32_t Address,
              uint32_t Bytes);
  void sync(FunctionalThread &, uint32_t) {}
  void barrier(FunctionalThread &, uint32_t) {}
  void message(FunctionalThread &T, uint32_t Pc, uint32_t Marker,
               uint32_t Value);

private:
  ThreadShadow &shadowOf(const FunctionalThread &T) {
    return Shadows[T.Number];
  }
  ShadowMemory &memoryOf(const CheckedAccess &A) {
    return A.IsLocal ? *shadowOf(A.T).Local : *Global;
  }
  CodePlace placeOf(const FunctionalThread &T, uint32_t Pc) {
    return {T.Number, Pc, shadowOf(T).Calls.context()};
  }

  [[gnu::always_inline]] void
  checkAccess(ShadowMemory &Memory, const CheckedAccess &A, bool IsStore) {
    if (Memory.accessOf(A.Address) != 0) [[unlikely]]
      checkCode(A, IsStore);
    if (A.IsLocal ? A.Address < A.T.Registers[StackPointerRegister]
                  : A.Address >= HeapFrontier) [[unlikely]]
      checkBound(A, IsStore);
  }
  [[gnu::noinline]] void checkCode(const CheckedAccess &A, bool IsStore);
  [[gnu::noinline]] void checkBound(const CheckedAccess &A, bool IsStore);
  /// Whether the instruction is of the code that copies the first values of a
  /// thread's variables, and with them what lies between.
  bool isOfStart(uint32_t Pc);
  void reportAccess(const CheckedAccess &A, bool IsStore, Access Code);
  /// What \p Address is, as far as the stack's objects or a block of the heap
  /// say it.
  void nameStackObject(const FunctionalThread &T, uint32_t Address, Report &R);
  void nameBlock(const HeapBlock &Block, uint32_t Address, Report &R) const;

  [[gnu::noinline]] void loadUndefined(Step &S, const CheckedAccess &A);
  /// The instruction depends on undefined bits of its source \p Operand.
  [[gnu::noinline]] void reportUndefined(FunctionalThread &T, uint32_t Pc,
                                         const char *Kind, const char *Title,
                                         uint8_t Register);
  void reportUndefined(const char *Kind, const std::string &Title,
                       std::vector<ReportSide> Sides, OriginId Origin,
                       std::optional<uint32_t> Address = std::nullopt);
  template <Opcode Op, class BodyType>
  [[gnu::noinline]] void afterUndefined(ThreadShadow &Shadow,
                                        const Instruction &Decoded,
                                        const BodyType &Run);
  template <Opcode Op, class BodyType>
  [[gnu::noinline]] void wordUndefined(const Step &S, FunctionalThread &T,
                                       const Instruction &Decoded,
                                       const BodyType &Run);
  template <Opcode Op, class BodyType>
  [[gnu::noinline]] void conditionUndefined(FunctionalThread &T, uint32_t Pc,
                                            const Instruction &Decoded,
                                            const BodyType &Run);

  void padGlobals();
  void padLaunch();
  /// Gives the bytes that the innermost call of the allocator was asked for.
  uint32_t leaveAllocator(FunctionalThread &T);
  void allocated(FunctionalThread &T, uint32_t Pc, uint32_t Address);
  void resized(FunctionalThread &T, uint32_t Pc, uint32_t Address);
  void freeing(FunctionalThread &T, uint32_t Pc, uint32_t Address);
  /// Whether global memory has [Address, Address + Bytes).
  bool hasGlobal(uint32_t Address, uint32_t Bytes) const;
  /// The text in global memory, shortened if it is long.
  std::string_view textAt(uint32_t Address) const;
  /// Whether a message about this block of global memory, or this object of a
  /// local store, with padding behind it, can be believed.
  bool isBlock(uint32_t Address, uint32_t Bytes) const;
  bool isLocalObject(uint32_t Address, uint32_t Bytes) const;
  void markBlock(uint32_t Address, uint32_t Bytes);
  void objectBegins(FunctionalThread &T, uint32_t Pc, uint32_t Address);
  void objectEnds(FunctionalThread &T, uint32_t Pc, uint32_t Address);
  ReportSide side(const char *What, const CodePlace &Place) const;

  const MemoryCheckOptions Wanted;
  CheckedProgram &Program;
  AddressSpace Space;
  std::unique_ptr<ShadowMemory> Global;
  std::vector<ThreadShadow> Shadows;
  /// Atomic accesses to a word for the sake of some of its bytes: the rest
  /// takes part in a comparison whose outcome does not matter.
  std::unordered_set<uint32_t> AccessesToParts;
  /// Global memory from here on has never been allocated.
  uint32_t HeapFrontier = UINT32_MAX;
  /// The lowest address that the stack may reach.
  uint32_t StackBegin = 0;
  HeapBlocks Blocks;
  UndefinedOrigins Origins;
  std::string Error;
};

/// Whether an instruction's sources have undefined bits.
template <class BodyType>
[[gnu::always_inline]] inline UndefinedBits
undefinedSources(const ThreadShadow &Shadow, const Instruction &Decoded) {
  UndefinedBits Bits = 0;
  for (unsigned I = 0; I != BodyType::NumSources; ++I)
    Bits |= Shadow.Undefined[Decoded.Source[I]];
  return Bits;
}

/// Instructions that access memory at rs and something, and which source that
/// register is.
template <Opcode Op> constexpr bool isStore() {
  return (Op >= Opcode::SB && Op <= Opcode::SWC1) ||
         (Op >= Opcode::SBX && Op <= Opcode::SWXC1);
}
template <Opcode Op> constexpr bool isLoad() {
  return (Op >= Opcode::LB && Op <= Opcode::LWC1) ||
         (Op >= Opcode::LBX && Op <= Opcode::LWXC1);
}
template <Opcode Op> constexpr bool isIndexed() {
  return Op >= Opcode::LBX && Op <= Opcode::SWXC1;
}
template <Opcode Op> constexpr bool isStream() {
  return Op == Opcode::STREAM_PUSH || Op == Opcode::STREAM_POP;
}
template <Opcode Op> constexpr bool isAtomicOrStream() {
  return Op >= Opcode::ATOM_ADD && Op <= Opcode::STREAM_POP;
}
/// The number of the source that is the address's first register.
template <Opcode Op> constexpr unsigned addressSource() {
  if (isStore<Op>())
    return 1;
  if (Op == Opcode::ATOM_CAS)
    return 2;
  return isLoad<Op>() || Op == Opcode::STREAM_POP ? 0 : 1;
}
template <Opcode Op> constexpr bool hasCondition() {
  return (Op >= Opcode::BEQ && Op <= Opcode::BGEZAL) ||
         (Op >= Opcode::TEQ && Op <= Opcode::TGEU);
}

template <Opcode Op, class BodyType>
void MemoryChecks::before(Step &S, FunctionalThread &T, uint32_t Pc,
                          const Instruction &Decoded, const BodyType &Run) {
  const ThreadShadow &Shadow = shadowOf(T);
  if constexpr (isLoad<Op>() || isStore<Op>() || isAtomicOrStream<Op>()) {
    if constexpr (isStream<Op>())
      S.StreamWords = Run.rs + StreamDescriptorBytes;
    constexpr unsigned First = addressSource<Op>();
    for (unsigned I = 0; I != First; ++I) {
      S.Stored |= Shadow.Undefined[Decoded.Source[I]];
      if (Shadow.Undefined[Decoded.Source[I]] != 0) [[unlikely]]
        S.StoredOrigin = Shadow.Origin[Decoded.Source[I]];
    }
    for (unsigned I = First; I <= First + isIndexed<Op>(); ++I)
      if (Shadow.Undefined[Decoded.Source[I]] != 0) [[unlikely]]
        reportUndefined(T, Pc, "undefined-address",
                        "an address depends on an undefined value",
                        Decoded.Source[I]);
  } else if constexpr (Op == Opcode::JR || Op == Opcode::JALR) {
    if (Shadow.Undefined[Decoded.Source[0]] != 0) [[unlikely]]
      reportUndefined(T, Pc, "undefined-jump",
                      "the target of a jump depends on an undefined value",
                      Decoded.Source[0]);
  } else if constexpr (hasCondition<Op>()) {
    if (undefinedSources<BodyType>(Shadow, Decoded) != 0) [[unlikely]]
      conditionUndefined<Op>(T, Pc, Decoded, Run);
  } else if constexpr (Op == Opcode::HALT) {
    if (Shadow.Undefined[Decoded.Source[0]] != 0) [[unlikely]]
      reportUndefined(T, Pc, "undefined-output",
                      "the exit status depends on an undefined value",
                      Decoded.Source[0]);
  } else if constexpr (Op == Opcode::HOSTCALL) {
    for (uint8_t Register : Decoded.Source)
      if (Shadow.Undefined[Register] != 0) [[unlikely]]
        reportUndefined(T, Pc, "undefined-output",
                        "an argument of a host call is an undefined value",
                        Register);
  }
}

template <Opcode Op, class BodyType>
void MemoryChecks::conditionUndefined(FunctionalThread &T, uint32_t Pc,
                                      const Instruction &Decoded,
                                      const BodyType &Run) {
  const ThreadShadow &Shadow = shadowOf(T);
  auto BitsOf = [&](unsigned I) { return Shadow.Undefined[Decoded.Source[I]]; };
  if (!isConditionUndefined<Op>(Run, BitsOf(0), BitsOf(1)))
    return;
  reportUndefined(T, Pc, "undefined-branch",
                  "a branch depends on an undefined value",
                  Decoded.Source[BitsOf(0) != 0 ? 0 : 1]);
}

template <Opcode Op, class BodyType>
void MemoryChecks::after(Step &S, FunctionalThread &T, uint32_t Pc,
                         const Instruction &Decoded, const BodyType &Run,
                         bool KeepsDestination) {
  if constexpr (isAtomicOrStream<Op>() && !isStream<Op>())
    if ((S.Loaded | S.Stored) != 0) [[unlikely]]
      wordUndefined<Op>(S, T, Decoded, Run);
  if constexpr (BodyType::HasDestination) {
    ThreadShadow &Shadow = shadowOf(T);
    uint8_t Destination = Decoded.Destination;
    if constexpr (isLoad<Op>() || isAtomicOrStream<Op>()) {
      Shadow.Undefined[Destination] = S.Loaded;
      if (S.Loaded != 0) [[unlikely]] {
        constexpr bool IsByte = Op == Opcode::LB || Op == Opcode::LBX;
        constexpr bool IsHalf = Op == Opcode::LH || Op == Opcode::LHX;
        if constexpr (IsByte)
          Shadow.Undefined[Destination] = int8_t(S.Loaded);
        if constexpr (IsHalf)
          Shadow.Undefined[Destination] = int16_t(S.Loaded);
        Shadow.Origin[Destination] = S.LoadedOrigin;
      }
    } else if constexpr (BodyType::NumSources == 0 || hasCondition<Op>() ||
                         Op == Opcode::JALR || Op == Opcode::HOSTCALL) {
      if (!KeepsDestination)
        Shadow.Undefined[Destination] = 0;
    } else {
      if (undefinedSources<BodyType>(Shadow, Decoded) != 0) [[unlikely]]
        afterUndefined<Op>(Shadow, Decoded, Run);
      else
        Shadow.Undefined[Destination] = 0;
    }
  }
}

template <Opcode Op, class BodyType>
void MemoryChecks::afterUndefined(ThreadShadow &Shadow,
                                  const Instruction &Decoded,
                                  const BodyType &Run) {
  UndefinedBits Sources[3];
  OriginId Origin = NoOrigin;
  for (unsigned I = 3; I-- != 0;) {
    Sources[I] = Shadow.Undefined[Decoded.Source[I]];
    if (Sources[I] != 0)
      Origin = Shadow.Origin[Decoded.Source[I]];
  }
  Shadow.Undefined[Decoded.Destination] =
      undefinedResult<Op>(Decoded, Run, Sources);
  Shadow.Origin[Decoded.Destination] = Origin;
}

template <Opcode Op, class BodyType>
void MemoryChecks::wordUndefined(const Step &S, FunctionalThread &T,
                                 const Instruction &Decoded,
                                 const BodyType &Run) {
  ThreadShadow &Shadow = shadowOf(T);
  constexpr unsigned Operand = addressSource<Op>() - 1;
  const UndefinedBits New = undefinedWord<Op>(
      Run, Run.result(), S.Loaded, Shadow.Undefined[Decoded.Source[Operand]],
      Operand == 0 ? 0 : Shadow.Undefined[Decoded.Source[0]]);
  ShadowMemory &Memory = Space.isLocal(Run.rs) ? *Shadow.Local : *Global;
  std::memcpy(Memory.undefined(Run.rs), &New, sizeof(New));
  if (New != 0)
    Memory.setOrigin(Run.rs, S.Stored != 0 ? S.StoredOrigin : S.LoadedOrigin);
}

template <Opcode Op>
void MemoryChecks::branched(FunctionalThread &T, uint32_t Pc,
                            const Instruction &, uint32_t Target) {
  if constexpr (Op == Opcode::JAL || Op == Opcode::JALR ||
                Op == Opcode::BLTZAL || Op == Opcode::BGEZAL)
    shadowOf(T).Calls.called(Program.Contexts, Pc, Pc + 4,
                             T.Registers[StackPointerRegister]);
  else if constexpr (Op == Opcode::JR)
    shadowOf(T).Calls.jumped(Target, T.Registers[StackPointerRegister]);
}

// What the rare paths are given a reference to counts as changed by them; the
// rest is done with copies, whose sizes are constants.
inline void MemoryChecks::load(Step &S, const CheckedAccess &A) {
  ShadowMemory &Memory = memoryOf(A);
  const uint32_t Address = A.Address;
  const uint32_t Bytes = A.Bytes;
  checkAccess(Memory, A, /*IsStore=*/false);
  UndefinedBits Loaded = 0;
  std::memcpy(&Loaded, Memory.undefined(Address), Bytes);
  S.Loaded = Loaded;
  if (Loaded != 0) [[unlikely]]
    loadUndefined(S, A);
}

inline void MemoryChecks::store(Step &S, const CheckedAccess &A) {
  ShadowMemory &Memory = memoryOf(A);
  const uint32_t Address = A.Address;
  const uint32_t Bytes = A.Bytes;
  const UndefinedBits Stored = S.Stored;
  checkAccess(Memory, A, /*IsStore=*/true);
  std::memcpy(Memory.undefined(Address), &Stored, Bytes);
  if (Stored != 0) [[unlikely]]
    Memory.setOrigin(Address, S.StoredOrigin);
}

} // namespace tp

#endif // TP_SIMULATOR_CHECK_MEMORYCHECKS_H
