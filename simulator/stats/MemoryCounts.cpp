//===- MemoryCounts.cpp - Names of what the memory system counts ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/MemoryCounts.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace tp {

template <class Counts>
static void subtract(Counts &From, const Counts &Earlier,
                     std::span<const MemoryCount<Counts>> Members) {
  for (const MemoryCount<Counts> &Count : Members)
    if (Count.Kind != CountKind::Maximum)
      From.*Count.Member -= Earlier.*Count.Member;
}

template <class Counts>
static void add(Counts &Sum, const Counts &Later,
                std::span<const MemoryCount<Counts>> Members) {
  for (const MemoryCount<Counts> &Count : Members) {
    uint64_t &Value = Sum.*Count.Member;
    uint64_t More = Later.*Count.Member;
    Value =
        Count.Kind == CountKind::Maximum ? std::max(Value, More) : Value + More;
  }
}

static void addChannel(DramChannelStatistics &Sum,
                       const DramChannelStatistics &More) {
  add<DramChannelStatistics>(Sum, More, DramCounts);
  for (size_t I = 0; I != Sum.ReadLatency.size(); ++I)
    Sum.ReadLatency[I] += More.ReadLatency[I];
}

MemoryStatistics difference(const MemoryStatistics &Later,
                            const MemoryStatistics &Earlier) {
  assert(Later.DramChannels.size() == Earlier.DramChannels.size());
  MemoryStatistics Result = Later;
  subtract<MemoryStatistics>(Result, Earlier, FlowCounts);
  if (Result.L1)
    subtract<CacheStatistics>(*Result.L1, *Earlier.L1, CacheCounts);
  if (Result.L2)
    subtract<CacheStatistics>(*Result.L2, *Earlier.L2, CacheCounts);
  if (Result.Crossbar)
    subtract<CrossbarStatistics>(*Result.Crossbar, *Earlier.Crossbar,
                                 CrossbarCounts);
  for (size_t I = 0; I != Result.DramChannels.size(); ++I) {
    DramChannelStatistics &Channel = Result.DramChannels[I];
    const DramChannelStatistics &Before = Earlier.DramChannels[I];
    subtract<DramChannelStatistics>(Channel, Before, DramCounts);
    for (size_t J = 0; J != Channel.ReadLatency.size(); ++J)
      Channel.ReadLatency[J] -= Before.ReadLatency[J];
  }
  return Result;
}

void add(MemoryStatistics &Sum, const MemoryStatistics &Later) {
  assert(Sum.DramChannels.size() == Later.DramChannels.size());
  add<MemoryStatistics>(Sum, Later, FlowCounts);
  if (Sum.L1)
    add<CacheStatistics>(*Sum.L1, *Later.L1, CacheCounts);
  if (Sum.L2)
    add<CacheStatistics>(*Sum.L2, *Later.L2, CacheCounts);
  if (Sum.Crossbar)
    add<CrossbarStatistics>(*Sum.Crossbar, *Later.Crossbar, CrossbarCounts);
  for (size_t I = 0; I != Sum.DramChannels.size(); ++I)
    addChannel(Sum.DramChannels[I], Later.DramChannels[I]);
}

DramChannelStatistics
sumOfChannels(const std::vector<DramChannelStatistics> &Channels) {
  DramChannelStatistics Sum;
  for (const DramChannelStatistics &Channel : Channels)
    addChannel(Sum, Channel);
  return Sum;
}

} // namespace tp
