//===- MemorySummary.cpp - What follows from the memory's counts ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/MemorySummary.h"

#include "simulator/chip/ChipArea.h"
#include "simulator/stats/MemoryCounts.h"
#include "simulator/stats/Ratio.h"

namespace tp {
namespace {

class MemorySummarizer {
public:
  MemorySummarizer(const ChipConfig &Chip, uint64_t Cycles)
      : Chip(Chip), Cycles(double(Cycles)) {}

  CacheSummary cache(const CacheConfig &Config, uint64_t Caches,
                     const CacheStatistics &Counts) const {
    CacheSummary Result;
    Result.Counts = Counts;
    Result.Caches = Caches;
    uint64_t Lookups = Counts.Hits + Counts.Misses + Counts.Merged;
    Result.HitRate = ratio(Counts.Hits, Lookups);
    Result.MergedRate = ratio(Counts.Merged, Lookups);
    uint64_t Served =
        Counts.Loads + Counts.Stores + Counts.Atomics + Counts.Fetches;
    Result.BankUtilisation =
        ratio(Served, Cycles * double(Caches) * Config.Banks);
    Result.Read = bandwidth(Counts.BytesRead);
    Result.Written = bandwidth(Counts.BytesWritten);
    return Result;
  }

  CrossbarSummary crossbar(const CrossbarConfig &Config,
                           const CrossbarStatistics &Counts) const {
    auto Ports = [&](uint32_t BytesPerCycle) {
      return double(Chip.TmCount) * BytesPerCycle;
    };
    return {Counts,
            limited(Counts.RequestBytes, Ports(Config.RequestBytesPerCycle)),
            limited(Counts.AnswerBytes, Ports(Config.AnswerBytesPerCycle))};
  }

  DramSummary dram(const DramConfig &Config, uint32_t Channels,
                   const DramChannelStatistics &Counts) const {
    double ChannelPeak = double(Config.BurstBytes) * double(Config.ClockKHz) /
                         (Config.BurstTicks * Chip.ClockGHz * 1e6);
    uint64_t Accesses = Counts.Reads + Counts.Writes;
    DramSummary Result;
    Result.Counts = Counts;
    Result.RowHitRate = ratio(Counts.RowHits, Accesses);
    Result.Data = limited(Accesses * Config.BurstBytes, ChannelPeak * Channels);
    Result.Read = bandwidth(Counts.Reads * Config.BurstBytes);
    Result.Written = bandwidth(Counts.Writes * Config.BurstBytes);
    double Ticks =
        Cycles * double(Config.ClockKHz) / (Chip.ClockGHz * 1e6) * Channels;
    Result.MeanReadQueue = ratio(double(Counts.ReadQueueTicks), Ticks);
    Result.MeanWriteQueue = ratio(double(Counts.WriteQueueTicks), Ticks);
    Result.MeanReadLatency =
        ratio(Counts.ReadLatencySum, Counts.Reads + Counts.ForwardedReads);
    return Result;
  }

private:
  const ChipConfig &Chip;
  double Cycles;

  Bandwidth bandwidth(uint64_t Bytes) const {
    double PerCycle = ratio(double(Bytes), Cycles);
    return {Bytes, PerCycle, PerCycle * Chip.ClockGHz};
  }

  LimitedBandwidth limited(uint64_t Bytes, double PeakPerCycle) const {
    Bandwidth Actual = bandwidth(Bytes);
    return {Actual, PeakPerCycle * Chip.ClockGHz,
            ratio(Actual.BytesPerCycle, PeakPerCycle)};
  }
};

} // namespace

MemorySummary summarizeMemory(const ChipConfig &Chip, uint64_t Cycles,
                              const MemoryStatistics &Counts) {
  MemorySummarizer Of(Chip, Cycles);
  MemorySummary Result;
  if (Chip.L1 && Counts.L1)
    Result.L1 = Of.cache(*Chip.L1, Chip.TmCount, *Counts.L1);
  if (Chip.Crossbar && Counts.Crossbar)
    Result.Crossbar = Of.crossbar(*Chip.Crossbar, *Counts.Crossbar);
  if (Chip.L2 && Counts.L2)
    Result.L2 = Of.cache(*Chip.L2, l2Count(Chip), *Counts.L2);
  if (Chip.Dram && !Counts.DramChannels.empty()) {
    auto Channels = uint32_t(Counts.DramChannels.size());
    Result.Dram =
        Of.dram(*Chip.Dram, Channels, sumOfChannels(Counts.DramChannels));
    for (const DramChannelStatistics &Channel : Counts.DramChannels)
      Result.DramChannels.push_back(Of.dram(*Chip.Dram, 1, Channel));
  }
  return Result;
}

} // namespace tp
