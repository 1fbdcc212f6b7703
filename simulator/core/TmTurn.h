//===- TmTurn.h - One TM in one window --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each TP is simulated alone, highest priority first, against a table of what
// each cycle still has free: it can never disturb one of higher priority, so
// this is exact.
//
// With an L1, whose hits come back within the window, that is done in sweeps. A
// TP that waits for the L1 is left at its cycle, and those of lower priority
// may not pass the first cycle in which it may go on: its frontier. When the
// sweep is over, the L1 decides all that happens before the least frontier of
// all, which lets some go on in the next sweep.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_TMTURN_H
#define TP_SIMULATOR_CORE_TMTURN_H

#include "simulator/core/HostPrefetch.h"
#include "simulator/core/Waiting.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace tp {

/// A TM's share of the window that the runner is in.
template <class Word> class TmTurn {
public:
  /// \p Tps and \p NextCycles are those of the TM; \p FirstPriority is the TP
  /// that comes first, \p Unused what the cycles have free at first.
  TmTurn(TmRunner<Word> &R, uint32_t Tm, std::span<Thread> Tps,
         std::span<uint64_t> NextCycles, uint32_t FirstPriority,
         std::span<const Word> Unused)
      : R(R), Tm(Tm), Tps(Tps), NextCycles(NextCycles),
        FirstPriority(FirstPriority), WindowEnd(R.Epoch + R.End) {
    std::copy(Unused.begin(), Unused.end(), R.Free.begin());
    // The handlers index by relative cycles.
    Free = reinterpret_cast<Word *>(reinterpret_cast<uintptr_t>(R.Free.data()) -
                                    R.windowStartRelative() * sizeof(Word));
  }

  /// Gives the first cycle in which the TM has something to do again.
  uint64_t run() {
    if (R.Icache)
      R.Icache->beginWindow(R.WindowStart);
    uint64_t First = NeverCycle;
    for (uint32_t Priority = 0; Priority != Tps.size(); ++Priority) {
      uint32_t Tp = tpOf(Priority);
      prefetchBehind(Priority);
      if (NextCycles[Tp] < WindowEnd)
        runTp(Tp, Priority);
      First = std::min(First, NextCycles[Tp]);
    }
    if (R.Icache)
      First = std::min(First, fetchMissedLines(WindowEnd));
    return First;
  }

  /// The same for a TM with a memory system.
  /// \p Undecided is of its TPs, and kept from turn to turn.
  uint64_t run(TmMemory &Memory, std::span<uint64_t> Undecided) {
    UndecidedFrom = Undecided;
    R.Memory = &Memory;
    R.Unanswered = 0;
    LastAdvance = R.WindowStart;
    if (R.Icache)
      R.Icache->beginWindow(R.WindowStart);
    if (Memory.hasAnswers()) {
      Memory.takeAnswers(R.Answers);
      assert(std::ranges::all_of(R.Answers,
                                 [&](const MemoryAnswer &Answer) {
                                   return Answer.ReadyCycle >= R.WindowStart;
                                 }) &&
             "an answer comes back within the window of its request");
      takeAnswers();
    }
    while (LastAdvance != WindowEnd) {
      LastAdvance = sweep();
      if (R.Icache)
        fetchMissedLines(LastAdvance);
      Memory.advance(LastAdvance, R.Answers);
      takeAnswers();
    }
    for (TmRunnerState::OwnAccesses &Own : R.OwnAccessesOf)
      R.moveToLog(Own);
    uint64_t First = Memory.nextEvent();
    for (uint64_t Next : NextCycles)
      First = std::min(First, Next);
    return First;
  }

private:
  uint32_t tpOf(uint32_t Priority) const {
    uint32_t Tp = FirstPriority + Priority;
    return Tp < Tps.size() ? Tp : Tp - uint32_t(Tps.size());
  }

  /// Brings what the next TPs will touch into the host's cache: of the second
  /// next its state, of the next, whose state is there, the top of its stack.
  void prefetchBehind(uint32_t Priority) const {
    if (Priority + 2 < Tps.size())
      prefetchThread(Tps[tpOf(Priority + 2)]);
    if (Priority + 1 >= Tps.size())
      return;
    uint32_t Next = tpOf(Priority + 1);
    if (NextCycles[Next] < WindowEnd)
      prefetchStack(Tps[Next], *R.Chip.Chip);
  }

  void runTp(uint32_t Tp, uint32_t Priority) {
    R.OwnLogBegin = R.Log.size();
    R.OwnWords = 0;
    R.OwnOrder = orderKey(0, Priority, Tm);
    runTpTo(Tp, WindowEnd);
  }

  void runTpTo(uint32_t Tp, uint64_t Limit) {
    Thread *T = &Tps[Tp];
    uint64_t Next = NextCycles[Tp];
    do {
      auto *S = static_cast<const Slot<Word> *>(T->Resume);
      R.NextCycle = NeverCycle;
      S->Execute(T, S, Next - R.Epoch, Free, &R);
      Next = R.NextCycle;
    } while (Next < Limit);
    NextCycles[Tp] = Next;
  }

  /// Runs all TPs as far as they may go, and gives the least frontier.
  uint64_t sweep() {
    uint64_t Least = WindowEnd;
    for (uint32_t Priority = 0; Priority != Tps.size(); ++Priority) {
      uint32_t Tp = tpOf(Priority);
      if (LastAdvance == R.WindowStart)
        prefetchBehind(Priority);
      if (NextCycles[Tp] < Least)
        runTpInSweep(Tp, Priority, Least);
      Least = std::min(Least, frontier(Tp));
    }
    return Least;
  }

  /// Runs a TP that may not reach \p Limit.
  void runTpInSweep(uint32_t Tp, uint32_t Priority, uint64_t Limit) {
    R.OwnOrder = orderKey(0, Priority, Tm);
    R.swapLog(R.OwnAccessesOf[Tp]);
    R.Limit = Limit - R.Epoch;
    Word AtLimit = Free[R.Limit];
    Free[R.Limit] |= R.Closed;
    runTpTo(Tp, Limit);
    Free[R.Limit] = AtLimit;
    R.Limit = R.End;
    R.swapLog(R.OwnAccessesOf[Tp]);
    noteUndecided(Tp);
  }

  /// The first cycle in which a TP may issue again, if that is within the
  /// window.
  uint64_t frontier(uint32_t Tp) const {
    uint64_t From = UndecidedFrom[Tp];
    if (From == NeverCycle)
      return NextCycles[Tp];
    return std::max(From, LastAdvance + R.L1Latency);
  }

  /// A TP has stopped, or there was an answer for it.
  void noteUndecided(uint32_t Tp) { UndecidedFrom[Tp] = undecidedFrom(Tp); }

  /// If the TP waits for what the L1 has yet to decide, the first cycle in
  /// which it may go on for all that is known when it is asked; else
  /// NeverCycle.
  uint64_t undecidedFrom(uint32_t Tp) const {
    const Thread &T = Tps[Tp];
    const ThreadRequests &Requests = *T.Requests;
    if (R.L1Latency == 0)
      return NeverCycle;
    switch (Requests.waitsFor()) {
    case Awaited::Nothing:
    case Awaited::Line:
      return NeverCycle;
    case Awaited::Sources: {
      auto *S = static_cast<const Slot<Word> *>(T.Resume);
      uint64_t From = Requests.suspendedAt();
      for (uint8_t Source : S->Instruction.Source) {
        if (!ready::isPending(T.Ready[Source]))
          continue;
        const auto &Request = Requests.request(Source);
        if (Request.GoneOn)
          return NeverCycle;
        From = std::max(From, Request.issuedBefore(Requests.suspendedAt()) +
                                  R.L1Latency);
      }
      return From;
    }
    case Awaited::StoreEntry:
      return Requests.oldestStore().GoneOn ? NeverCycle
                                           : Requests.suspendedAt();
    case Awaited::AllStores:
      return Requests.hasStoreGoneOn() ? NeverCycle : Requests.suspendedAt();
    }
    __builtin_unreachable();
  }

  /// Decides where the lines come from that were missed before \p Limit, and
  /// gives the first cycle in which one of those who wait goes on, as far as
  /// that is known now.
  uint64_t fetchMissedLines(uint64_t Limit) {
    const ChipConfig &Chip = *R.Chip.Chip;
    bool IsFixed = Chip.IcacheMissKind == IcacheMisses::Fixed;
    uint64_t First = NeverCycle;
    for (const InstructionCache::Miss &Missed : R.Icache->takeMisses(Limit)) {
      bool IsNew = !R.Icache->isAskedFor(Missed.Line, Missed.Cycle);
      if (IsNew && IsFixed)
        R.Icache->arrives(Missed.Line, Missed.Cycle + Chip.IcacheMissLatency);
      else if (IsNew)
        R.requestLine(Missed);
      if (IsFixed)
        First = std::min(First, goOnWithLine(Missed));
    }
    return First;
  }

  /// Of a thread that waits for a line of which it is known when it comes.
  uint64_t goOnWithLine(const InstructionCache::Miss &Missed) {
    Thread &T = Tps[Missed.Tp];
    uint64_t There = R.Icache->arrivalOf(Missed.Line, Missed.Cycle);
    R.charge(T, T.LastWord, Loss::IcacheMiss, There - Missed.Cycle);
    if (T.Requests)
      T.Requests->resume();
    return NextCycles[Missed.Tp] = There;
  }

  /// Those who wait for a line that comes in \p Cycle go on.
  void takeLine(uint32_t Line, uint64_t Cycle) {
    R.Icache->arrives(Line, Cycle);
    for (size_t Tp = 0; Tp != Tps.size(); ++Tp)
      if (Tps[Tp].Line == Line && Tps[Tp].Requests->waitsFor() == Awaited::Line)
        NextCycles[Tp] = waiting::resume(&Tps[Tp], &R);
  }

  void recordAnswers() {
    for (const MemoryAnswer &Answer : R.Answers) {
      if (Answer.ReadyCycle == AnsweredLater ||
          ThreadRequests::lineOf(Answer.Ticket) != NoLine)
        continue;
      const Thread &T = Tps[Answer.Tp];
      ThreadRequests::Origin From = T.Requests->takeOrigin(Answer.Ticket);
      R.Record->served(
          {T.Number, From.Word, From.Cycle, Answer.ReadyCycle, Answer.Level});
    }
  }

  void takeAnswers() {
    if (R.Record)
      recordAnswers();
    for (const MemoryAnswer &Answer : R.Answers) {
      R.Unanswered -= Answer.ReadyCycle != AnsweredLater;
      if (uint32_t Line = ThreadRequests::lineOf(Answer.Ticket);
          Line != NoLine) {
        if (Answer.ReadyCycle != AnsweredLater)
          takeLine(Line, Answer.ReadyCycle);
        continue;
      }
      Thread &T = Tps[Answer.Tp];
      ThreadRequests &Requests = *T.Requests;
      bool Known = Answer.ReadyCycle != AnsweredLater;
      uint8_t Register = ThreadRequests::registerOf(Answer.Ticket);
      if (Register == NumRegisters) {
        Requests.noteStore(Answer);
      } else if (Requests.noteRegister(Answer) && Known) {
        ReadyWord &Ready = T.Ready[Register];
        if (ready::isPending(Ready))
          Ready = ready::withCycle(Ready, Answer.ReadyCycle - R.Epoch);
      }
      if (Requests.waitsFor() == Awaited::Nothing)
        continue;
      if (Known)
        NextCycles[Answer.Tp] = waiting::resume(&T, &R);
      noteUndecided(Answer.Tp);
    }
    R.Answers.clear();
  }

  TmRunner<Word> &R;
  const uint32_t Tm;
  const std::span<Thread> Tps;
  const std::span<uint64_t> NextCycles;
  const uint32_t FirstPriority;
  const uint64_t WindowEnd;
  Word *Free;
  /// Of each TP that waits for what the L1 has yet to decide, the first cycle
  /// in which it may go on; NeverCycle of the others.
  std::span<uint64_t> UndecidedFrom;
  /// The cycle before which the TM's memory has decided everything.
  uint64_t LastAdvance = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_TMTURN_H
