//===- ThreadTrace.h - What chosen threads do in each cycle -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_THREADTRACE_H
#define TP_SIMULATOR_PROFILE_THREADTRACE_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/EngineObservers.h"
#include "simulator/core/ExecutionRecorder.h"
#include "simulator/core/Program.h"
#include "simulator/stats/Statistics.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tp {

/// The cycles [Begin, End).
struct CycleRange {
  uint64_t Begin = 0;
  uint64_t End = 0;
};

/// An instruction that was issued.
struct TracedIssue {
  uint64_t Cycle = 0;
  uint32_t Word = 0;
  /// What it accessed, if it is an access.
  std::optional<uint32_t> Address;
};

/// Cycles that a thread lost at an instruction.
struct TracedStall {
  CycleRange Cycles;
  uint32_t Word = 0;
  Loss Reason = Loss::Data;
};

/// A thread's cycles in the range that was asked for: each is an issue or in
/// one stall. Accesses that overlap the range are whole.
struct ThreadTrace {
  uint32_t Thread = 0;
  std::vector<TracedIssue> Issues;
  std::vector<TracedStall> Stalls;
  std::vector<AnsweredRequest> Accesses;
};

/// Traces threads from the start of a run on. The words to observe are all of
/// the text.
class ThreadTracer final : public IssueObserver {
public:
  /// \p Threads are different ones.
  ThreadTracer(const ChipConfig &Chip, const Program &Text,
               std::span<const uint32_t> Threads, CycleRange Range);

  void issuing(const Thread &T, uint32_t Word, uint64_t Cycle,
               const TmRunnerState &Runner) override;
  void postponed(const Thread &T) override;

  /// The traces of a run that has ended with these statistics, in the order of
  /// the threads as they were given. \p Answers are those in the range, of all
  /// of them.
  std::vector<ThreadTrace> finish(const Statistics &Now,
                                  std::span<const AnsweredRequest> Answers);

private:
  /// An instruction that is issued unless it is postponed or traps.
  struct Announced {
    TracedIssue Issue;
    LossCounts Lost;
  };
  struct Course {
    ThreadTrace Result;
    /// The cycle up to which everything is known, and the losses up to there.
    uint64_t KnownTo = 0;
    LossCounts Lost{};
    uint64_t Issued = 0;
    uint32_t LastWord = 0;
    std::optional<Announced> Next;
  };

  void confirm(Course &Of);
  /// The losses of the cycles up to \p To.
  void addStalls(Course &Of, const LossCounts &Lost, uint64_t To,
                 uint32_t NextWord);
  void addFixedAccesses(ThreadTrace &Trace) const;
  bool overlaps(uint64_t Begin, uint64_t End) const {
    return Begin < Range.End && End > Range.Begin;
  }

  const ChipConfig &Chip;
  const Program &Text;
  const CycleRange Range;
  std::vector<Course> Courses;
  /// By thread: its place in Courses plus 1, or 0.
  std::vector<uint32_t> CourseOf;
};

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_THREADTRACE_H
