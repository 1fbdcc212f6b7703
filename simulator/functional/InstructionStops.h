//===- InstructionStops.h - Ending turns at any instruction -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Instructions at which a turn may end get another handler, which decides. The
// others cost nothing. Instructions that take no time are not stopped at.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_INSTRUCTIONSTOPS_H
#define TP_SIMULATOR_FUNCTIONAL_INSTRUCTIONSTOPS_H

#include "simulator/functional/FunctionalHandlers.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// Sees chosen instructions of a functional machine before they are executed.
class InstructionObserver {
public:
  virtual ~InstructionObserver() = default;
  /// \p T is about to execute \p Word, before which all threads have executed
  /// \p Number instructions. True ends the run here.
  virtual bool stopsBefore(const FunctionalThread &T, uint32_t Word,
                           uint64_t Number) = 0;
};

/// The handlers of a text, some of them with one before that may end the turn.
class InstructionStops {
public:
  /// In place of a number of instructions.
  static constexpr uint64_t Never = ~uint64_t(0);

  /// \p Slots must outlive it and have their final handlers.
  explicit InstructionStops(std::span<FunctionalSlot> Slots) : Slots(Slots) {
    for (const FunctionalSlot &S : Slots)
      Original.push_back(S.Execute);
  }

  /// Shows the instructions of \p NewWords to \p NewObserver, which may be
  /// null.
  void setObserver(InstructionObserver *NewObserver,
                   const std::vector<bool> &NewWords) {
    Observer = NewObserver;
    Words = NewWords;
    Words.resize(Slots.size());
    apply();
  }

  /// Where a run ends: before the instruction with this number.
  void setEnd(uint64_t Number) { End = Number; }
  /// \p SeesAll: no instruction is executed without looking at its number.
  void setSeesAll(bool Now) {
    if (Now == SeesAll)
      return;
    SeesAll = Now;
    apply();
  }

  /// A turn begins; the number of an instruction is this plus those that its
  /// thread has issued.
  void beginTurn(uint64_t IssuedByOthers) {
    Others = IssuedByOthers;
    Stopped = false;
  }
  bool hasStopped() const { return Stopped; }

private:
  using Ending = FunctionalHandlers<Subnormals::Keep>;

  __attribute__((preserve_none)) static void
  stopOrExecute(TP_FUNCTIONAL_PARAMETERS) {
    InstructionStops &Stops = *R->Stops;
    if (Stops.stopsBefore(*T, S, T->TurnEnd - Quantum + (S - Block)))
      TP_FUNCTIONAL_TAIL_CALL Ending::endTurn(TP_FUNCTIONAL_ARGUMENTS);
    TP_FUNCTIONAL_TAIL_CALL
    Stops.Original[S - R->Slots](TP_FUNCTIONAL_ARGUMENTS);
  }

  bool stopsBefore(const FunctionalThread &T, const FunctionalSlot *S,
                   uint64_t Issued) {
    const uint64_t Number = Others + Issued;
    const auto Word = uint32_t(S - Slots.data());
    Stopped = Number >= End ||
              (Words[Word] && Observer->stopsBefore(T, Word, Number));
    return Stopped;
  }

  void apply() {
    for (size_t I = 0; I != Slots.size(); ++I) {
      const Opcode Op = Slots[I].Instruction.Op;
      const bool IsTimed = Op == IllegalOpcode || takesTime(Op);
      const bool IsSeen = SeesAll || (!Words.empty() && Words[I]);
      Slots[I].Execute = IsSeen && IsTimed ? stopOrExecute : Original[I];
    }
  }

  std::span<FunctionalSlot> Slots;
  std::vector<FunctionalHandler> Original;
  InstructionObserver *Observer = nullptr;
  std::vector<bool> Words = std::vector<bool>(Slots.size());
  uint64_t End = Never;
  uint64_t Others = 0;
  bool SeesAll = false;
  bool Stopped = false;
};

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_INSTRUCTIONSTOPS_H
