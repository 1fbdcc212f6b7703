//===- MemoryCounts.h - Names of what the memory system counts --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The one list of the counts in MemoryStatistics.h: their differences, their
// sums and their names in JSON and CSV follow from it.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_MEMORYCOUNTS_H
#define TP_SIMULATOR_STATS_MEMORYCOUNTS_H

#include "simulator/memory/MemoryStatistics.h"

#include <cstdint>
#include <iterator>

namespace tp {

/// What the difference of a count between two pauses means.
enum class CountKind : uint8_t {
  /// What was counted between them.
  Sum,
  /// Nothing: the most since the run's start remains.
  Maximum,
  /// By how much what is there now has grown; it may be negative, modulo 2^64.
  Level,
};

/// A count of \p Counts with its name in JSON.
template <class Counts> struct MemoryCount {
  const char *Name;
  uint64_t Counts::*Member;
  CountKind Kind = CountKind::Sum;
};

inline constexpr MemoryCount<CacheStatistics> CacheCounts[] = {
    {"loads", &CacheStatistics::Loads},
    {"stores", &CacheStatistics::Stores},
    {"atomics", &CacheStatistics::Atomics},
    {"fetches", &CacheStatistics::Fetches},
    {"hits", &CacheStatistics::Hits},
    {"misses", &CacheStatistics::Misses},
    {"sector_misses", &CacheStatistics::SectorMisses},
    {"merged", &CacheStatistics::Merged},
    {"store_hits", &CacheStatistics::StoreHits},
    {"bank_conflicts", &CacheStatistics::BankConflicts},
    {"bank_conflict_cycles", &CacheStatistics::BankConflictCycles},
    {"miss_register_wait_cycles", &CacheStatistics::MissRegisterWaitCycles},
    {"evictions", &CacheStatistics::Evictions},
    {"writeback_bytes", &CacheStatistics::WritebackBytes},
    {"bytes_read", &CacheStatistics::BytesRead},
    {"bytes_written", &CacheStatistics::BytesWritten},
};

inline constexpr MemoryCount<CrossbarStatistics> CrossbarCounts[] = {
    {"requests", &CrossbarStatistics::Requests},
    {"request_bytes", &CrossbarStatistics::RequestBytes},
    {"answer_bytes", &CrossbarStatistics::AnswerBytes},
    {"request_wait_cycles", &CrossbarStatistics::RequestWaitCycles},
    {"answer_wait_cycles", &CrossbarStatistics::AnswerWaitCycles},
};

inline constexpr MemoryCount<DramChannelStatistics> DramCounts[] = {
    {"reads", &DramChannelStatistics::Reads},
    {"writes", &DramChannelStatistics::Writes},
    {"forwarded_reads", &DramChannelStatistics::ForwardedReads},
    {"merged_writes", &DramChannelStatistics::MergedWrites},
    {"pending", &DramChannelStatistics::Pending, CountKind::Level},
    {"row_hits", &DramChannelStatistics::RowHits},
    {"row_misses", &DramChannelStatistics::RowMisses},
    {"row_conflicts", &DramChannelStatistics::RowConflicts},
    {"activates", &DramChannelStatistics::Activates},
    {"precharges", &DramChannelStatistics::Precharges},
    {"refreshes", &DramChannelStatistics::Refreshes},
    {"write_drains", &DramChannelStatistics::WriteDrains},
    {"ticks", &DramChannelStatistics::Ticks, CountKind::Level},
    {"bus_busy_ticks", &DramChannelStatistics::BusBusyTicks},
    {"refresh_ticks", &DramChannelStatistics::RefreshTicks},
    {"read_queue_ticks", &DramChannelStatistics::ReadQueueTicks},
    {"write_queue_ticks", &DramChannelStatistics::WriteQueueTicks},
    {"max_read_queue", &DramChannelStatistics::MaxReadQueue,
     CountKind::Maximum},
    {"max_write_queue", &DramChannelStatistics::MaxWriteQueue,
     CountKind::Maximum},
    {"read_latency_cycles", &DramChannelStatistics::ReadLatencySum},
};

/// Between the levels, in units of the level that receives them.
inline constexpr MemoryCount<MemoryStatistics> FlowCounts[] = {
    {"waiting_at_l1", &MemoryStatistics::WaitingAtL1, CountKind::Level},
    {"sent_by_tms", &MemoryStatistics::SentByTms},
    {"sent_by_tms_under_way", &MemoryStatistics::SentByTmsUnderWay,
     CountKind::Level},
    {"sent_by_l2s", &MemoryStatistics::SentByL2s},
    {"sent_by_l2s_under_way", &MemoryStatistics::SentByL2sUnderWay,
     CountKind::Level},
};

static_assert(sizeof(CacheStatistics) ==
                  std::size(CacheCounts) * sizeof(uint64_t),
              "a count has no name");
static_assert(sizeof(CrossbarStatistics) ==
                  std::size(CrossbarCounts) * sizeof(uint64_t),
              "a count has no name");
static_assert(sizeof(DramChannelStatistics) ==
                  std::size(DramCounts) * sizeof(uint64_t) +
                      sizeof(LatencyHistogram),
              "a count has no name");

/// What was counted between \p Earlier and \p Later, two pauses of one run.
/// Maxima are those up to \p Later.
MemoryStatistics difference(const MemoryStatistics &Later,
                            const MemoryStatistics &Earlier);

/// Appends the counts of a later part of the same run.
void add(MemoryStatistics &Sum, const MemoryStatistics &Later);

/// All channels together: sums, and the largest of the maxima.
DramChannelStatistics
sumOfChannels(const std::vector<DramChannelStatistics> &Channels);

} // namespace tp

#endif // TP_SIMULATOR_STATS_MEMORYCOUNTS_H
