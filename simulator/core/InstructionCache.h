//===- InstructionCache.h - Which instructions a TM has at hand -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// TPs of a TM are simulated one after the other through a window. So what the
// cache holds in each of its cycles is known before: hits change nothing (lines
// leave in the order in which they came), and the lines that are missed in a
// window do not come before its end.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_INSTRUCTIONCACHE_H
#define TP_SIMULATOR_CORE_INSTRUCTIONCACHE_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Archive.h"
#include "simulator/core/Program.h"
#include "simulator/core/Thread.h"

#include <cstdint>
#include <vector>

namespace tp {

/// The line of each word of the text; NoLine for messages, which nobody
/// fetches. The lines hold the text as it is without messages.
std::vector<uint32_t> linesOfText(const Program &Text, const ChipConfig &Chip);

/// The instruction cache of a TM. All cycles are absolute.
class InstructionCache {
public:
  /// A TP found a line neither there nor known to come.
  struct Miss {
    uint64_t Cycle;
    uint32_t Line;
    uint16_t Priority;
    uint16_t Tp;
  };
  static constexpr uint64_t Unknown = ~uint64_t(0);

  explicit InstructionCache(const ChipConfig &Chip);

  /// Lookups may be of any order from \p Start on.
  void beginWindow(uint64_t Start);
  /// The first cycle from \p Cycle on in which the line is there or comes;
  /// Unknown if that has not been said.
  uint64_t lookUp(uint32_t Line, uint64_t Cycle);

  void addMiss(const Miss &Missed) { Misses.push_back(Missed); }
  /// Takes out the misses before \p Limit, in the order (cycle, priority).
  std::vector<Miss> takeMisses(uint64_t Limit);

  /// Whether the line is asked for already, or known to come after \p Cycle;
  /// notes otherwise that it is asked for from now on.
  bool isAskedFor(uint32_t Line, uint64_t Cycle);
  /// The line will come in this cycle: not before the end of the window in
  /// which it was missed.
  void arrives(uint32_t Line, uint64_t Cycle);
  /// The cycle in which the line comes that was missed in \p Cycle; Unknown if
  /// that has not been said.
  uint64_t arrivalOf(uint32_t Line, uint64_t Cycle) const;

  const IcacheStatistics &statistics() const { return Counts; }
  void serialize(Archive &A);

private:
  /// A line that comes.
  struct Fill {
    uint64_t Cycle;
    uint32_t Line;

    void serialize(Archive &A) {
      A(Cycle);
      A(Line);
    }
  };
  /// The lines of a set, the oldest first.
  using Set = std::vector<uint32_t>;

  static bool holds(const Set &Lines, uint32_t Line);
  static void put(Set &Lines, uint32_t Line);
  Set &setOf(uint32_t Line) { return Sets[Line % Sets.size()]; }

  std::vector<Set> Sets;
  /// In the order in which they come.
  std::vector<Fill> Fills;
  std::vector<uint32_t> AskedFor;
  /// Of the window at hand.
  std::vector<Miss> Misses;
  IcacheStatistics Counts;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_INSTRUCTIONCACHE_H
