//===- Handlers.h - Issue and execution of one thread -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One handler per opcode. It checks whether the instruction can issue in this
// cycle, executes it and continues with the handler of the next instruction by
// a tail call: the state of the running thread stays in host registers.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_HANDLERS_H
#define TP_SIMULATOR_CORE_HANDLERS_H

#include "simulator/core/ExecutionContext.h"
#include "simulator/core/Waiting.h"

namespace tp {

template <class Word, Subnormals Mode> struct Handlers {
  /// The handler of an opcode; of IllegalOpcode one that traps.
  static Handler<Word> of(Opcode Op) {
    static constexpr Handler<Word> Table[] = {
#define TP_HANDLER_OF(NAME) handlerOf<Opcode::NAME>(),
        TP_EACH_OPCODE(TP_HANDLER_OF)
#undef TP_HANDLER_OF
            trapAtFetch<TrapKind::IllegalInstruction>,
    };
    return Table[unsigned(Op)];
  }

  /// Likewise, and tells the observer and the recorder of each issue.
  /// Instructions that take no time are not issued.
  static Handler<Word> observed(Opcode Op) {
    static constexpr Handler<Word> Table[] = {
#define TP_HANDLER_OF(NAME) handlerOf<Opcode::NAME, true>(),
        TP_EACH_OPCODE(TP_HANDLER_OF)
#undef TP_HANDLER_OF
            trapAtFetch<TrapKind::IllegalInstruction>,
    };
    return Table[unsigned(Op)];
  }

  /// The handler of an instruction behind one that moved the stack pointer:
  /// traps if that was too far.
  static Handler<Word> afterStackMove(bool IsObserved = false) {
    return IsObserved ? checkStack<true> : checkStack<false>;
  }

  /// Charges a taken branch, which is the thread's LastWord.
  static Handler<Word> afterTakenBranch() { return waitForTarget; }

  /// Follows the last word of the text.
  static Handler<Word> endOfText() {
    return trapAtFetch<TrapKind::FetchOutsideText>;
  }

  /// On a chip whose instruction caches can miss: looks whether the instruction
  /// is there, and goes on with its Fetched handler.
  static Handler<Word> beforeFetch() { return checkLine; }

private:
  template <Opcode Op, bool IsObserved = false>
  static constexpr Handler<Word> handlerOf() {
    if constexpr (takesTime(Op))
      return execute<Op, IsObserved>;
    else
      return deliver<Op>;
  }

  static uint32_t pcOf(const Slot<Word> *S, const TmRunner<Word> *R) {
    return R->Chip.TextBegin + S->Number * 4;
  }

  template <Opcode Op, bool IsObserved>
  __attribute__((preserve_none)) static void execute(TP_HANDLER_PARAMETERS) {
    using Instruction = Body<Op>;
    using Context = ExecutionContext<Op, Mode>;
    using Outcome = typename Context::Outcome;

    ReadyWord Latest = latestSource<Instruction::NumSources>(T, S);
    if (ready::cycleOf(Latest) > Cycle) [[unlikely]]
      TP_TAIL_CALL waitForData(TP_HANDLER_ARGUMENTS);
    Word Used = Free[Cycle] + S->Use;
    if ((Used & R->Guards) != 0) [[unlikely]]
      TP_TAIL_CALL waitForResource(TP_HANDLER_ARGUMENTS);

    uint8_t Destination = S->Instruction.Destination;
    Instruction Run(S->Instruction, T->Registers.data());
    IssueCounts &Counts = R->IssuedAt[S->Number];
    Context C(*T, *R, S->Number, Counts, Cycle, Destination, S->Result);
    if constexpr (IsObserved)
      announceIssue(T, S, Cycle, R);
    // Where most of the time goes; observed instructions need not be as fast.
    if constexpr (IsObserved)
      Run.run(C);
    else [[clang::always_inline]]
      Run.run(C);
    if (C.outcome() == Outcome::Trap) [[unlikely]]
      return stopAtTrap(T, R, pcOf(S, R), Cycle, C.trapReason(),
                        C.trapAddress());
    if constexpr (IsObserved)
      withdrawIssue(T, R, C.outcome());
    if (C.outcome() == Outcome::Blocked) [[unlikely]]
      return block(T, S, Cycle, R, C.blocker());
    if (C.outcome() == Outcome::StoreBufferFull) [[unlikely]]
      TP_TAIL_CALL waitForStoreBuffer(TP_HANDLER_ARGUMENTS);

    Free[Cycle] = Used;
    ++Counts.Executed;
    if constexpr (Instruction::HasDestination) {
      if (!C.keepsDestination()) {
        T->Ready[Destination] = C.resultReady();
        if (!C.isDeferred())
          T->Registers[Destination] = Run.result();
      }
    }
    ++Cycle;
    if constexpr (IsObserved)
      recordIssue(T, R, S->Number, Cycle, C);
    if (C.outcome() == Outcome::Leave) {
      T->Resume = S + 1;
      return;
    }
    if (C.outcome() == Outcome::Branch) {
      uint32_t BranchWord = S->Number;
      S = R->Slots + C.targetWord();
      if (R->Chip.BranchLatency != 1) [[unlikely]] {
        T->LastWord = BranchWord;
        TP_TAIL_CALL waitForTarget(TP_HANDLER_ARGUMENTS);
      }
    } else {
      ++S;
    }
    TP_TAIL_CALL S->Execute(TP_HANDLER_ARGUMENTS);
  }

  [[gnu::noinline]] static void announceIssue(const Thread *T,
                                              const Slot<Word> *S,
                                              uint64_t Cycle,
                                              TmRunner<Word> *R) {
    if (R->Issues)
      R->Issues->issuing(*T, S->Number, R->Epoch + Cycle, *R);
  }

  template <class Outcome>
  static void withdrawIssue(const Thread *T, TmRunner<Word> *R, Outcome Kind) {
    if (R->Issues &&
        (Kind == Outcome::Blocked || Kind == Outcome::StoreBufferFull))
      R->Issues->postponed(*T);
  }

  template <class Context>
  [[gnu::noinline]] static void recordIssue(const Thread *T, TmRunner<Word> *R,
                                            uint32_t Number, uint64_t Cycle,
                                            const Context &C) {
    if (!R->Record)
      return;
    bool IsTaken = C.outcome() == Context::Outcome::Branch;
    R->Record->issued(*T,
                      {.Word = Number,
                       .NextWord = IsTaken ? C.targetWord() : Number + 1,
                       .IsTaken = IsTaken,
                       .Cycle = R->Epoch + Cycle,
                       .BranchLoss = IsTaken ? R->Chip.BranchLatency - 1 : 0});
  }

  /// An instruction that takes no time.
  template <Opcode Op>
  __attribute__((preserve_none)) static void deliver(TP_HANDLER_PARAMETERS) {
    using Instruction = Body<Op>;
    static_assert(!Instruction::HasDestination);
    ReadyWord Latest = latestSource<Instruction::NumSources>(T, S);
    // A thread can be at a message in the cycle after the window, before the
    // window's commit.
    if (ready::cycleOf(Latest) >= std::min(Cycle + 1, R->End) &&
        isUnknownBefore(Latest)) [[unlikely]]
      TP_TAIL_CALL waitForData(TP_HANDLER_ARGUMENTS);
    Instruction Run(S->Instruction, T->Registers.data());
    uint32_t Number = S->Number;
    ExecutionContext<Op, Mode> C(*T, *R, Number, R->IssuedAt[Number], Cycle,
                                 S->Instruction.Destination, S->Result);
    Run.run(C);
    ++S;
    TP_TAIL_CALL S->Execute(TP_HANDLER_ARGUMENTS);
  }

  /// Whether a value is not known yet before it is ready: those that a window's
  /// commit makes.
  static bool isUnknownBefore(ReadyWord Ready) {
    return (Ready & ready::FromGlobalMemory) != 0 &&
           latencyClassOf(ready::producerOf(Ready)) == LatencyClass::Atomic;
  }

  template <bool IsObserved>
  __attribute__((preserve_none)) static void checkStack(TP_HANDLER_PARAMETERS) {
    const uint32_t StackPointer = T->Registers[StackPointerRegister];
    if (StackPointer >= R->Chip.StackLimit) [[likely]] {
      Handler<Word> Next =
          IsObserved ? observed(S->Instruction.Op) : of(S->Instruction.Op);
      TP_TAIL_CALL Next(TP_HANDLER_ARGUMENTS);
    }
    if (Cycle >= R->Limit)
      return waiting::leave(T, S, Cycle, R);
    stopAtTrap(T, R, pcOf(S - 1, R), Cycle, TrapKind::StackOverflow,
               StackPointer);
  }

  __attribute__((preserve_none)) static void checkLine(TP_HANDLER_PARAMETERS) {
    uint32_t Number = S->Number;
    if (T->Line != R->LineOf[Number]) [[unlikely]]
      TP_TAIL_CALL lookUpLine(TP_HANDLER_ARGUMENTS);
    TP_TAIL_CALL R->Fetched[Number](TP_HANDLER_ARGUMENTS);
  }

  __attribute__((preserve_none, noinline)) static void
  lookUpLine(TP_HANDLER_PARAMETERS) {
    if (Cycle >= R->Limit)
      return waiting::leave(T, S, Cycle, R);
    uint32_t Number = S->Number;
    uint64_t Now = R->Epoch + Cycle;
    T->Line = R->LineOf[Number];
    uint64_t There = R->Icache->lookUp(T->Line, Now);
    if (There == InstructionCache::Unknown)
      return waiting::missLine(T, S, Cycle, R);
    if (There != Now) {
      R->charge(*T, Number, Loss::IcacheMiss, There - Now);
      Cycle += There - Now;
      if (Cycle >= R->Limit)
        return waiting::leave(T, S, Cycle, R);
    }
    TP_TAIL_CALL R->Fetched[Number](TP_HANDLER_ARGUMENTS);
  }

  template <TrapKind Reason>
  __attribute__((preserve_none)) static void
  trapAtFetch(TP_HANDLER_PARAMETERS) {
    if (Cycle >= R->Limit)
      return waiting::leave(T, S, Cycle, R);
    stopAtTrap(T, R, pcOf(S, R), Cycle, Reason, pcOf(S, R));
  }

  __attribute__((preserve_none, noinline)) static void
  waitForData(TP_HANDLER_PARAMETERS) {
    ReadyWord Latest = latestSource<3>(T, S);
    if (ready::isPending(Latest))
      return waiting::suspend(T, S, Cycle, R, Awaited::Sources,
                              ready::producerOf(Latest));
    uint64_t Lost = ready::cycleOf(Latest) - Cycle;
    waiting::chargeSources(T, S, R, Latest, Lost);
    Cycle += Lost;
    if (Cycle >= R->Limit)
      return waiting::leave(T, S, Cycle, R);
    TP_TAIL_CALL S->Execute(TP_HANDLER_ARGUMENTS);
  }

  __attribute__((preserve_none, noinline)) static void
  waitForStoreBuffer(TP_HANDLER_PARAMETERS) {
    uint64_t FreeFrom = T->Requests->oldestStore().FreeFrom;
    if (FreeFrom == ThreadRequests::NeverFree)
      return waiting::suspend(T, S, Cycle, R, Awaited::StoreEntry,
                              S->Instruction.Op);
    uint64_t Lost = FreeFrom - (R->Epoch + Cycle);
    waiting::chargeProducer(T, S->Number, R, Loss::StoreBuffer,
                            S->Instruction.Op, Lost);
    Cycle += Lost;
    if (Cycle >= R->Limit)
      return waiting::leave(T, S, Cycle, R);
    TP_TAIL_CALL S->Execute(TP_HANDLER_ARGUMENTS);
  }

  __attribute__((preserve_none, noinline)) static void
  waitForResource(TP_HANDLER_PARAMETERS) {
    uint64_t Fetches = 0, Units = 0;
    for (; Cycle < R->Limit; ++Cycle) {
      Word Used = Free[Cycle] + S->Use;
      if ((Used & R->Guards) == 0)
        break;
      ++((Used & R->IcacheGuards) != 0 ? Fetches : Units);
    }
    LossCounts &LostHere = R->LostAt[S->Number];
    for (auto [Reason, Cycles] : {std::pair(Loss::IcacheConflict, Fetches),
                                  std::pair(Loss::UnitConflict, Units)}) {
      T->Lost[unsigned(Reason)] += Cycles;
      LostHere[unsigned(Reason)] += Cycles;
    }
    if (Cycle >= R->Limit)
      return waiting::leave(T, S, Cycle, R);
    TP_TAIL_CALL S->Execute(TP_HANDLER_ARGUMENTS);
  }

  /// LastWord is the branch.
  __attribute__((preserve_none, noinline)) static void
  waitForTarget(TP_HANDLER_PARAMETERS) {
    uint64_t Lost = R->Chip.BranchLatency - 1;
    R->charge(*T, T->LastWord, Loss::Branch, Lost);
    Cycle += Lost;
    if (Cycle >= R->Limit)
      return waiting::leave(T, S, Cycle, R);
    TP_TAIL_CALL S->Execute(TP_HANDLER_ARGUMENTS);
  }

  [[gnu::noinline]] static void block(Thread *T, const Slot<Word> *S,
                                      uint64_t Cycle, TmRunner<Word> *R,
                                      Opcode Producer) {
    waiting::chargeProducer(T, S->Number, R, Loss::Memory, Producer,
                            R->End - Cycle);
    waiting::leave(T, S, R->End, R);
  }

  [[gnu::noinline]] static void stopAtTrap(Thread *T, TmRunner<Word> *R,
                                           uint32_t Pc, uint64_t Cycle,
                                           TrapKind Reason, uint32_t Address) {
    Trap Info{Reason, T->Number, Pc, Address, R->Epoch + Cycle};
    keepFirst(R->FirstTrap, {R->keyAt(Cycle), Info});
    T->State = ThreadState::Trapped;
    T->EndCycle = Info.Cycle;
    R->NextCycle = NeverCycle;
  }
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_HANDLERS_H
