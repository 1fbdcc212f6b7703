//===- MemoryStatistics.h - What the memory system counts -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_MEMORYSTATISTICS_H
#define TP_SIMULATOR_MEMORY_MEMORYSTATISTICS_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// Of all caches of one level. Every access is counted when its bank serves it.
/// Loads, fetches and the L2's atomics are each a hit, a miss or merged; what
/// an L1 does with atomics is to pass them on.
struct CacheStatistics {
  uint64_t Loads = 0;
  uint64_t Stores = 0;
  uint64_t Atomics = 0;
  /// Instruction-cache lines asked for.
  uint64_t Fetches = 0;
  uint64_t Hits = 0;
  /// Of these, SectorMisses found their line but not their sector.
  uint64_t Misses = 0;
  uint64_t SectorMisses = 0;
  /// Joined a miss that was under way.
  uint64_t Merged = 0;
  uint64_t StoreHits = 0;
  /// Requests that found their bank busy, and cycles that requests waited for
  /// one.
  uint64_t BankConflicts = 0;
  uint64_t BankConflictCycles = 0;
  /// Cycles that requests at the head of a bank waited for a miss register, or
  /// for room in one.
  uint64_t MissRegisterWaitCycles = 0;
  uint64_t Evictions = 0;
  uint64_t WritebackBytes = 0;
  /// From and to the next level.
  uint64_t BytesRead = 0;
  uint64_t BytesWritten = 0;

  CacheStatistics &operator+=(const CacheStatistics &Other) {
    using Counts = std::array<uint64_t, sizeof(CacheStatistics) / 8>;
    auto Sum = std::bit_cast<Counts>(*this);
    auto More = std::bit_cast<Counts>(Other);
    for (size_t I = 0; I != Sum.size(); ++I)
      Sum[I] += More[I];
    return *this = std::bit_cast<CacheStatistics>(Sum);
  }
};

/// Over all ports.
struct CrossbarStatistics {
  uint64_t Requests = 0;
  uint64_t RequestBytes = 0;
  uint64_t AnswerBytes = 0;
  /// Cycles that requests and answers waited for their port.
  uint64_t RequestWaitCycles = 0;
  uint64_t AnswerWaitCycles = 0;
};

/// Requests by latency in cycles: bucket 0 counts those of 0, bucket i those of
/// [2^(i-1), 2^i), the last one all above.
using LatencyHistogram = std::array<uint64_t, 20>;

/// Of one channel. Ticks are of the command clock.
struct DramChannelStatistics {
  /// Bursts on the bus.
  uint64_t Reads = 0;
  uint64_t Writes = 0;
  /// Reads that found their burst in the write queue, and writes that joined
  /// one there: neither goes to the device.
  uint64_t ForwardedReads = 0;
  uint64_t MergedWrites = 0;
  /// Requests that are none of these yet.
  uint64_t Pending = 0;
  /// Of each burst: its row was open, no row was, or another one.
  uint64_t RowHits = 0;
  uint64_t RowMisses = 0;
  uint64_t RowConflicts = 0;
  uint64_t Activates = 0;
  uint64_t Precharges = 0;
  uint64_t Refreshes = 0;
  /// Turns of the bus from reads to writes.
  uint64_t WriteDrains = 0;
  /// Ticks simulated, and of these with data on the bus, and in refresh.
  uint64_t Ticks = 0;
  uint64_t BusBusyTicks = 0;
  uint64_t RefreshTicks = 0;
  /// Entries of the queues summed over the ticks, and the most.
  uint64_t ReadQueueTicks = 0;
  uint64_t WriteQueueTicks = 0;
  uint64_t MaxReadQueue = 0;
  uint64_t MaxWriteQueue = 0;
  /// Of reads, from arrival at the controller to the answer, in cycles of the
  /// chip.
  LatencyHistogram ReadLatency{};
  uint64_t ReadLatencySum = 0;
};

/// Of the levels that the chip has. Requests that one level sends to the next
/// are counted in the units of the receiver: what lies in one sector of the L2
/// or in one burst of DRAM.
struct MemoryStatistics {
  /// Made by TPs, and not yet served by their L1's bank.
  uint64_t WaitingAtL1 = 0;
  /// Sent by all TMs if there is an L2 or DRAM, and of these, still in front of
  /// an L2's bank or the DRAM controllers.
  uint64_t SentByTms = 0;
  uint64_t SentByTmsUnderWay = 0;
  /// Sent to DRAM by all L2s, and of these, not yet at the controllers.
  uint64_t SentByL2s = 0;
  uint64_t SentByL2sUnderWay = 0;
  std::optional<CacheStatistics> L1;
  std::optional<CacheStatistics> L2;
  std::optional<CrossbarStatistics> Crossbar;
  /// One per channel; empty without DRAM.
  std::vector<DramChannelStatistics> DramChannels;

  /// Saves or restores (core/Archive.h).
  template <class Archive> void serialize(Archive &A) {
    A(WaitingAtL1);
    A(SentByTms);
    A(SentByTmsUnderWay);
    A(SentByL2s);
    A(SentByL2sUnderWay);
    A(L1);
    A(L2);
    A(Crossbar);
    A(DramChannels);
  }
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_MEMORYSTATISTICS_H
