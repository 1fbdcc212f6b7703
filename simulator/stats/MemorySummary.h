//===- MemorySummary.h - What follows from the memory's counts --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_MEMORYSUMMARY_H
#define TP_SIMULATOR_STATS_MEMORYSUMMARY_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/memory/MemoryStatistics.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// Bytes over time.
struct Bandwidth {
  uint64_t Bytes = 0;
  double BytesPerCycle = 0;
  /// 10^9 bytes per second at the chip's clock.
  double GBPerSecond = 0;
};

/// A bandwidth with what the connection could carry at most.
struct LimitedBandwidth : Bandwidth {
  double PeakGBPerSecond = 0;
  /// 0 to 1.
  double ShareOfPeak = 0;
};

/// All caches of one level.
struct CacheSummary {
  CacheStatistics Counts;
  /// Caches of this level on the chip.
  uint64_t Caches = 0;
  /// Hits of all that is a hit, a miss or merged, 0 to 1.
  double HitRate = 0;
  /// What joined a miss, likewise.
  double MergedRate = 0;
  /// Share of the requests that the banks could have served, 0 to 1.
  double BankUtilisation = 0;
  /// From and to the next level.
  Bandwidth Read;
  Bandwidth Written;
};

/// Towards memory and back, over all ports.
struct CrossbarSummary {
  CrossbarStatistics Counts;
  LimitedBandwidth Requests;
  LimitedBandwidth Answers;
};

/// A channel, or all of them.
struct DramSummary {
  DramChannelStatistics Counts;
  /// Row hits per access, 0 to 1.
  double RowHitRate = 0;
  LimitedBandwidth Data;
  Bandwidth Read;
  Bandwidth Written;
  /// Entries of a channel's queues, averaged over time.
  double MeanReadQueue = 0;
  double MeanWriteQueue = 0;
  /// Cycles of the chip.
  double MeanReadLatency = 0;
};

/// The levels that the chip has.
struct MemorySummary {
  std::optional<CacheSummary> L1;
  std::optional<CrossbarSummary> Crossbar;
  std::optional<CacheSummary> L2;
  /// All channels together, and each.
  std::optional<DramSummary> Dram;
  std::vector<DramSummary> DramChannels;
};

/// What \p Counts of \p Cycles cycles say of the memory of \p Chip.
MemorySummary summarizeMemory(const ChipConfig &Chip, uint64_t Cycles,
                              const MemoryStatistics &Counts);

} // namespace tp

#endif // TP_SIMULATOR_STATS_MEMORYSUMMARY_H
