//===- MemoryRun.h - A run with every level of memory -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_STATS_MEMORYRUN_H
#define TP_TEST_UNIT_STATS_MEMORYRUN_H

#include "test/unit/stats/SmallRun.h"

namespace tp {

/// The small run on a chip with an L1 of 2 banks for each TM, one L2 of 4
/// banks, ports of 8 and 32 bytes, and 2 channels of DRAM that carry 32 bytes
/// in 2 ticks of 1 GHz: 32 GB/s together, 16 bytes a cycle. An addition costs
/// 0.5 nJ, a read from DRAM 1 nJ; an adder takes 0.25 mm2, which is assumed.
struct MemoryRun : SmallRun {
  MemoryRun() {
    Chip.L1.emplace().Banks = 2;
    Chip.L2.emplace().Banks = 4;
    Chip.TmsPerL2 = 2;
    CrossbarConfig &Ports = Chip.Crossbar.emplace();
    Ports.RequestBytesPerCycle = 8;
    Ports.AnswerBytesPerCycle = 32;
    DramConfig &Dram = Chip.Dram.emplace();
    Dram.ClockKHz = 1000000;
    Dram.Channels = 2;
    Dram.BurstBytes = 32;
    Dram.BurstTicks = 2;
    Dram.Energy.emplace().ReadNj = 1;
    PartCost &Adder = Chip.Technology.emplace().Units[unsigned(Unit::INTADD)];
    Adder = {0.25, 0.5, {"a guess", true}};

    Stats.GlobalAccesses = 52;
    MemoryStatistics &Memory = Stats.Memory.emplace();
    Memory.WaitingAtL1 = 2;
    Memory.SentByTms = 20;
    Memory.SentByL2s = 10;
    Memory.SentByL2sUnderWay = 1;
    CacheStatistics &L1 = Memory.L1.emplace();
    L1.Loads = 40;
    L1.Hits = 30;
    L1.Misses = 8;
    L1.Merged = 2;
    L1.Stores = 10;
    L1.BytesRead = 256;
    L1.BytesWritten = 40;
    CacheStatistics &L2 = Memory.L2.emplace();
    L2.Loads = 8;
    L2.Hits = 2;
    L2.Misses = 5;
    L2.Merged = 1;
    L2.Stores = 12;
    CrossbarStatistics &Crossbar = Memory.Crossbar.emplace();
    Crossbar.Requests = 18;
    Crossbar.RequestBytes = 160;
    Crossbar.AnswerBytes = 320;
    Memory.DramChannels.resize(2);
    for (DramChannelStatistics &Channel : Memory.DramChannels) {
      Channel.Reads = 3;
      Channel.Writes = 1;
      Channel.RowHits = 1;
      Channel.RowMisses = 1;
      Channel.RowConflicts = 2;
      Channel.Ticks = 50;
      Channel.ReadQueueTicks = 25;
      Channel.ReadLatencySum = 120;
      Channel.ReadLatency[6] = 3;
    }
    Memory.DramChannels[1].ReadQueueTicks = 75;
    Memory.DramChannels[1].MaxReadQueue = 4;
    Memory.DramChannels[1].Pending = 1;
  }
};

} // namespace tp

#endif // TP_TEST_UNIT_STATS_MEMORYRUN_H
