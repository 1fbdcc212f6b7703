//===- FunctionalHandlers.h - Execution without timing ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One handler per opcode, as in Handlers.h. Instructions are counted where
// blocks are entered and left, not one by one.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALHANDLERS_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALHANDLERS_H

#include "simulator/functional/FunctionalContext.h"

namespace tp {

struct FunctionalRunner;
struct FunctionalSlot;

/// The state of the running thread: itself, the instruction at hand, the first
/// instruction of the block that it is in, and the instructions that remain of
/// its quantum at that first one.
#define TP_FUNCTIONAL_PARAMETERS                                               \
  FunctionalThread *T, FunctionalSlot *S, FunctionalSlot *Block,               \
      int64_t Quantum, FunctionalRunner *R
#define TP_FUNCTIONAL_ARGUMENTS T, S, Block, Quantum, R
#define TP_FUNCTIONAL_TAIL_CALL [[clang::musttail]] return

using FunctionalHandler =
    void(__attribute__((preserve_none)) *)(TP_FUNCTIONAL_PARAMETERS);

/// A decoded instruction and what has been counted at it.
struct FunctionalSlot {
  FunctionalHandler Execute;
  tp::Instruction Instruction;
  /// How often a block began here, and how often one ended before here.
  uint64_t Begun = 0;
  uint64_t Ended = 0;
};

/// The text and what its threads share.
struct FunctionalRunner : FunctionalContextState {
  /// One slot per word and one behind it.
  FunctionalSlot *Slots = nullptr;
  /// For observeStep: whose instructions are observed, and what executes the
  /// instruction in each slot.
  uint32_t ObservedThread = 0;
  StepObserver ObserveStep;
  std::vector<FunctionalHandler> Observed;
};

template <Subnormals Mode, class Checks = NoChecks> struct FunctionalHandlers {
  /// The handler of an opcode; of IllegalOpcode one that traps.
  static FunctionalHandler of(Opcode Op) {
    static constexpr FunctionalHandler Table[] = {
#define TP_HANDLER_OF(NAME) execute<Opcode::NAME>,
        TP_EACH_OPCODE(TP_HANDLER_OF)
#undef TP_HANDLER_OF
            trapAtFetch<TrapKind::IllegalInstruction>,
    };
    return Table[unsigned(Op)];
  }

  /// The handler of an instruction behind one that moved the stack pointer:
  /// traps if that was too far.
  static FunctionalHandler afterStackMove() { return checkStack; }

  /// The handler of one behind an instruction that wrote it: the checks look.
  static FunctionalHandler afterStackWrite() { return noteStack; }

  /// Follows the last word of the text.
  static FunctionalHandler endOfText() {
    return trapAtFetch<TrapKind::FetchOutsideText>;
  }

  /// Shows the instruction at hand to the observer, then executes it.
  __attribute__((preserve_none)) static void
  observeStep(TP_FUNCTIONAL_PARAMETERS) {
    if (T->Number == R->ObservedThread)
      R->ObserveStep(pcOf(S, R), T->Registers);
    TP_FUNCTIONAL_TAIL_CALL R->Observed[S - R->Slots](TP_FUNCTIONAL_ARGUMENTS);
  }

  /// Ends the turn before the instruction at hand.
  __attribute__((preserve_none)) static void endTurn(TP_FUNCTIONAL_PARAMETERS) {
    leave(TP_FUNCTIONAL_ARGUMENTS);
  }

private:
  using Context = FunctionalContext<Mode, Checks>;
  using Outcome = typename Context::Outcome;

  static uint32_t pcOf(const FunctionalSlot *S, const FunctionalRunner *R) {
    return R->Space.TextBegin + uint32_t(S - R->Slots) * 4;
  }
  /// Instructions that the thread has issued before \p S.
  static uint64_t issued(const FunctionalThread *T, const FunctionalSlot *S,
                         const FunctionalSlot *Block, int64_t Quantum) {
    return T->TurnEnd - Quantum + (S - Block);
  }

  template <Opcode Op>
  __attribute__((preserve_none)) static void execute(TP_FUNCTIONAL_PARAMETERS) {
    using Instruction = Body<Op>;
    uint8_t Destination = S->Instruction.Destination;
    Instruction Run(S->Instruction, T->Registers.data());
    Context C(*T, *R, pcOf(S, R), issued(T, S, Block, Quantum));
    Checks::of(*R).template before<Op>(C.Step, *T, pcOf(S, R), S->Instruction,
                                       Run);
    Run.run(C);
    if (C.outcome() == Outcome::Trap) [[unlikely]]
      return stopAtTrap(T, S, Block, Quantum, R, C.trapReason(),
                        C.trapAddress());
    Checks::of(*R).template after<Op>(C.Step, *T, pcOf(S, R), S->Instruction,
                                      Run, C.keepsDestination());
    if constexpr (Instruction::HasDestination)
      if (!C.keepsDestination())
        T->Registers[Destination] = Run.result();
    if constexpr (!takesTime(Op))
      // As if the block were shorter.
      ++Block;
    ++S;
    if (C.outcome() == Outcome::Yield)
      return leave(T, S, Block, Quantum, R);
    if (C.outcome() == Outcome::Branch) {
      Checks::of(*R).template branched<Op>(
          *T, pcOf(S - 1, R), S[-1].Instruction,
          R->Space.TextBegin + C.targetWord() * 4);
      ++S->Ended;
      Quantum -= S - Block;
      Block = S = R->Slots + C.targetWord();
      ++S->Begun;
      if (Quantum <= 0) [[unlikely]]
        return leave(T, S, Block, Quantum, R);
    }
    TP_FUNCTIONAL_TAIL_CALL S->Execute(TP_FUNCTIONAL_ARGUMENTS);
  }

  __attribute__((preserve_none)) static void
  checkStack(TP_FUNCTIONAL_PARAMETERS) {
    const uint32_t StackPointer = T->Registers[StackPointerRegister];
    Checks::of(*R).stackMoved(*T, pcOf(S, R));
    if (StackPointer >= R->StackLimit) [[likely]]
      TP_FUNCTIONAL_TAIL_CALL of(S->Instruction.Op)(TP_FUNCTIONAL_ARGUMENTS);
    stopAtTrap(T, S, Block, Quantum, R, TrapKind::StackOverflow, StackPointer,
               pcOf(S - 1, R));
  }

  __attribute__((preserve_none)) static void
  noteStack(TP_FUNCTIONAL_PARAMETERS) {
    Checks::of(*R).stackMoved(*T, pcOf(S, R));
    TP_FUNCTIONAL_TAIL_CALL of(S->Instruction.Op)(TP_FUNCTIONAL_ARGUMENTS);
  }

  template <TrapKind Reason>
  __attribute__((preserve_none)) static void
  trapAtFetch(TP_FUNCTIONAL_PARAMETERS) {
    stopAtTrap(T, S, Block, Quantum, R, Reason, pcOf(S, R));
  }

  /// The turn ends before \p S.
  static void leave(TP_FUNCTIONAL_PARAMETERS) {
    ++S->Ended;
    T->TurnEnd = issued(T, S, Block, Quantum);
    T->NextWord = uint32_t(S - R->Slots);
  }

  [[gnu::noinline]] static void stopAtTrap(TP_FUNCTIONAL_PARAMETERS,
                                           TrapKind Reason, uint32_t Address) {
    stopAtTrap(TP_FUNCTIONAL_ARGUMENTS, Reason, Address, pcOf(S, R));
  }
  [[gnu::noinline]] static void stopAtTrap(TP_FUNCTIONAL_PARAMETERS,
                                           TrapKind Reason, uint32_t Address,
                                           uint32_t Pc) {
    leave(TP_FUNCTIONAL_ARGUMENTS);
    T->State = ThreadState::Trapped;
    R->FirstTrap = Trap{Reason, T->Number, Pc, Address, T->TurnEnd};
  }
};

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALHANDLERS_H
