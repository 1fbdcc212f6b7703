//===- RaceChecks.h - The check for data races ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_RACE_RACECHECKS_H
#define TP_SIMULATOR_CHECK_RACE_RACECHECKS_H

#include "simulator/check/CheckedProgram.h"
#include "simulator/check/race/AccessSites.h"
#include "simulator/check/race/RaceDetector.h"
#include "simulator/functional/Checks.h"

#include <string>
#include <vector>

namespace tp {

/// Tells a RaceDetector what a run does, and the user what that finds.
/// Accesses to a local store, which has one thread, and to what no thread can
/// write are left out.
class RaceChecks final : public ExecutionChecks {
public:
  struct Step {};

  /// \p Checked must outlive it.
  RaceChecks(CheckedProgram &Checked, const ChipConfig &Chip);

  /// Why it cannot be used; empty if it can.
  std::string error() const;

  /// How often races may have been missed because a limit was reached.
  uint64_t interruptions() const { return Detector.interruptions(); }

  static RaceChecks &of(FunctionalContextState &Shared) {
    return static_cast<RaceChecks &>(*Shared.Checks);
  }

  std::vector<FunctionalSlot> decode(const Program &Text,
                                     bool FlushToZero) override;
  void start(const AddressSpace &Memory, const ChipConfig &,
             std::span<const FunctionalThread>) override {
    Space = &Memory;
  }
  void barrierOpened() override { Detector.barrier(); }

  template <Opcode Op, class Body>
  void before(Step &, FunctionalThread &, uint32_t, const Instruction &,
              const Body &) {}

  template <Opcode Op, class Body>
  void after(Step &, FunctionalThread &T, uint32_t Pc, const Instruction &,
             const Body &Run, bool) {
    if constexpr (Op == Opcode::STREAM_PUSH || Op == Opcode::STREAM_POP)
      Detector.streamOperation(T.Number, Run.rs);
    if constexpr (Op == Opcode::ATOM_CAS || Op == Opcode::ATOM_AND ||
                  Op == Opcode::ATOM_OR || Op == Opcode::ATOM_XOR)
      if (isPartOfWord(Pc) && !Space->isLocal(Run.rs)) [[unlikely]]
        notePartOfWord(T, Pc, Run.rs, changedBits<Op>(Run));
  }

  template <Opcode Op>
  void branched(FunctionalThread &T, uint32_t Pc, const Instruction &,
                uint32_t Target) {
    ThreadCallStack &Stack = Stacks[T.Number];
    const uint32_t StackPointer = T.Registers[StackPointerRegister];
    if constexpr (Op == Opcode::JAL || Op == Opcode::JALR ||
                  Op == Opcode::BLTZAL || Op == Opcode::BGEZAL)
      Stack.called(Checked.Contexts, Pc, Pc + 4, StackPointer);
    if constexpr (Op == Opcode::JR)
      Stack.jumped(Target, StackPointer);
  }

  void stackMoved(FunctionalThread &, uint32_t) {}

  void load(Step &, const CheckedAccess &A) {
    if (A.IsLocal || Space->isReadOnly(A.Address))
      return;
    if (!isAtomic(A.Pc)) [[likely]]
      return Detector.read(A.T.Number, A.Address, A.Bytes,
                           [&] { return site(A.T, A.Pc); });
    if (!isPartOfWord(A.Pc))
      Detector.atomicLoad(A.T.Number, A.Address, A.Bytes, acquires(A.Pc),
                          site(A.T, A.Pc));
  }

  void store(Step &, const CheckedAccess &A) {
    if (A.IsLocal)
      return;
    if (!isAtomic(A.Pc)) [[likely]]
      return Detector.write(A.T.Number, A.Address, A.Bytes,
                            [&] { return site(A.T, A.Pc); });
    Detector.atomicStore(A.T.Number, A.Address, A.Bytes, site(A.T, A.Pc));
  }

  void atomic(Step &, const CheckedAccess &A) {
    if (A.IsLocal)
      return;
    if (isPartOfWord(A.Pc))
      Detector.atomicOrder(A.T.Number, A.Address);
    else
      Detector.atomicChange(A.T.Number, A.Address, site(A.T, A.Pc));
  }

  void streamLoad(Step &, const CheckedAccess &A) {
    Detector.atomicRead(A.T.Number, A.Address, A.Bytes, site(A.T, A.Pc));
  }
  void streamStore(Step &, const CheckedAccess &A) {
    Detector.atomicWrite(A.T.Number, A.Address, A.Bytes, site(A.T, A.Pc));
  }

  void output(FunctionalThread &T, uint32_t Pc, uint32_t Address,
              uint32_t Bytes);
  void sync(FunctionalThread &T, uint32_t) { Detector.fence(T.Number); }
  void barrier(FunctionalThread &, uint32_t) {}
  void message(FunctionalThread &, uint32_t, uint32_t, uint32_t) {}

private:
  /// What the compiler says of an instruction.
  enum AtomicFlags : uint8_t { Atomic = 1, Acquires = 2, PartOfWord = 4 };

  uint8_t flags(uint32_t Pc) const { return Flags[(Pc - TextBegin) / 4]; }
  bool isAtomic(uint32_t Pc) const { return flags(Pc) & Atomic; }
  bool acquires(uint32_t Pc) const { return flags(Pc) & Acquires; }
  bool isPartOfWord(uint32_t Pc) const { return flags(Pc) & PartOfWord; }

  /// The bits of the word that an atomic operation has changed.
  template <Opcode Op, class Body>
  static uint32_t changedBits(const Body &Run) {
    const uint32_t Old = Run.result();
    if constexpr (Op == Opcode::ATOM_AND)
      return Old & ~Run.rt;
    else if constexpr (Op == Opcode::ATOM_OR)
      return ~Old & Run.rt;
    else if constexpr (Op == Opcode::ATOM_XOR)
      return Run.rt;
    else
      return Old == Run.rdold ? Old ^ Run.rt : 0;
  }

  AccessSite site(const FunctionalThread &T, uint32_t Pc) {
    return Sites.of({Pc, Stacks[T.Number].context()});
  }
  /// The bytes of the word at \p Address that are not zero in \p Changed have
  /// been written in an atomic operation.
  void notePartOfWord(const FunctionalThread &T, uint32_t Pc, uint32_t Address,
                      uint32_t Changed);
  void report(const Race &R);
  /// The line that writes and the function of the other side, as far as they
  /// are known: a barrier that is missing gives a race for each pair of
  /// accesses around it.
  std::string causeOf(const Race &R);
  CodePlace place(const RacingAccess &Access) const;
  ReportSide side(const RacingAccess &Access) const;

  CheckedProgram &Checked;
  const uint32_t TextBegin;
  /// AtomicFlags by word of the text.
  std::vector<uint8_t> Flags;
  const AddressSpace *Space = nullptr;
  std::vector<ThreadCallStack> Stacks;
  AccessSites Sites;
  RaceDetector Detector;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_RACE_RACECHECKS_H
