//===- ThreadTrace.cpp - What chosen threads do in each cycle -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ThreadTrace.h"

#include "simulator/core/LocalStore.h"
#include "simulator/isa/Access.h"

#include <algorithm>

namespace tp {

ThreadTracer::ThreadTracer(const ChipConfig &Chip, const Program &Text,
                           std::span<const uint32_t> Threads, CycleRange Range)
    : Chip(Chip), Text(Text), Range(Range), CourseOf(Chip.threadCount()) {
  for (uint32_t Thread : Threads) {
    Courses.emplace_back().Result.Thread = Thread;
    CourseOf[Thread] = uint32_t(Courses.size());
  }
}

void ThreadTracer::issuing(const Thread &T, uint32_t Word, uint64_t Cycle,
                           const TmRunnerState &) {
  if (CourseOf[T.Number] == 0)
    return;
  Course &Of = Courses[CourseOf[T.Number] - 1];
  confirm(Of);
  Of.Next = Announced{{Cycle, Word, std::nullopt}, T.Lost};
  if (!overlaps(Cycle, Cycle + 1))
    return;
  if (auto Access = accessOf(Text.instructions()[Word], T.Registers))
    Of.Next->Issue.Address = Access->Address;
}

void ThreadTracer::postponed(const Thread &T) {
  if (CourseOf[T.Number] != 0)
    Courses[CourseOf[T.Number] - 1].Next.reset();
}

void ThreadTracer::confirm(Course &Of) {
  if (!Of.Next)
    return;
  const TracedIssue &Issue = Of.Next->Issue;
  addStalls(Of, Of.Next->Lost, Issue.Cycle, Issue.Word);
  if (overlaps(Issue.Cycle, Issue.Cycle + 1))
    Of.Result.Issues.push_back(Issue);
  Of.KnownTo = Issue.Cycle + 1;
  Of.LastWord = Issue.Word;
  ++Of.Issued;
  Of.Next.reset();
}

void ThreadTracer::addStalls(Course &Of, const LossCounts &Lost, uint64_t To,
                             uint32_t NextWord) {
  // In the order in which a thread comes to them.
  static constexpr Loss InOrder[] = {
      Loss::Branch,       Loss::Sync,        Loss::Sleep,
      Loss::Barrier,      Loss::IcacheMiss,  Loss::Data,
      Loss::Memory,       Loss::L1,          Loss::L2,
      Loss::Dram,         Loss::StoreBuffer, Loss::IcacheConflict,
      Loss::UnitConflict, Loss::Finished};
  static_assert(std::size(InOrder) == NumLosses);
  uint64_t Cycle = Of.KnownTo;
  for (Loss Reason : InOrder) {
    uint64_t Cycles = Lost[unsigned(Reason)] - Of.Lost[unsigned(Reason)];
    // Before a trap may come a loss that reaches beyond the end.
    uint64_t End = std::min(Cycle + Cycles, To);
    bool IsBehind = Reason == Loss::Branch || Reason == Loss::Sync ||
                    Reason == Loss::Sleep || Reason == Loss::Barrier;
    if (Cycle != End && overlaps(Cycle, End))
      Of.Result.Stalls.push_back(
          {{std::max(Cycle, Range.Begin), std::min(End, Range.End)},
           IsBehind ? Of.LastWord : NextWord,
           Reason});
    Cycle = End;
  }
  Of.Lost = Lost;
  Of.KnownTo = To;
}

void ThreadTracer::addFixedAccesses(ThreadTrace &Trace) const {
  LocalStoreRange Local(Chip.LocalStoreBytes);
  for (const TracedIssue &Issue : Trace.Issues) {
    const Instruction &Decoded = Text.instructions()[Issue.Word];
    bool HasAnswer = Decoded.Destination != NoRegister;
    if (Issue.Address && HasAnswer && !Local.contains(*Issue.Address, 1))
      Trace.Accesses.push_back({Trace.Thread, Issue.Word, Issue.Cycle,
                                Issue.Cycle + Chip.MemoryLatency,
                                ServedBy::Memory});
  }
}

std::vector<ThreadTrace>
ThreadTracer::finish(const Statistics &Now,
                     std::span<const AnsweredRequest> Answers) {
  for (const AnsweredRequest &Answer : Answers)
    Courses[CourseOf[Answer.Thread] - 1].Result.Accesses.push_back(Answer);
  std::vector<ThreadTrace> Result;
  for (Course &Of : Courses) {
    const ThreadStatistics &Thread = Now.Threads[Of.Result.Thread];
    if (Of.Issued != Thread.Instructions)
      confirm(Of);
    addStalls(Of, Thread.Lost, Now.Cycles, Of.LastWord);
    if (!Chip.hasMemorySystem())
      addFixedAccesses(Of.Result);
    std::ranges::sort(Of.Result.Accesses, {}, [](const AnsweredRequest &A) {
      return std::tuple(A.Issued, A.Ready, A.Word);
    });
    Result.push_back(std::move(Of.Result));
  }
  return Result;
}

} // namespace tp
