//===- MemorySummaryTest.cpp - Rates of the memory's levels ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/MemorySummary.h"
#include "test/unit/stats/MemoryRun.h"

#include "gtest/gtest.h"

using namespace tp;

static MemorySummary summary(const MemoryRun &Run) {
  return summarizeMemory(Run.Chip, Run.Stats.Cycles, *Run.Stats.Memory);
}

// 2 L1s of 2 banks can serve 400 requests in 100 cycles; 40 loads and 10 stores
// came. 256 bytes in 100 cycles of 0.5 ns.
TEST(MemorySummary, DerivesCacheRates) {
  MemorySummary Memory = summary(MemoryRun());
  EXPECT_EQ(Memory.L1->Caches, 2u);
  EXPECT_DOUBLE_EQ(Memory.L1->HitRate, 0.75);
  EXPECT_DOUBLE_EQ(Memory.L1->BankUtilisation, 50.0 / 400);
  EXPECT_DOUBLE_EQ(Memory.L1->Read.BytesPerCycle, 2.56);
  EXPECT_DOUBLE_EQ(Memory.L1->Read.GBPerSecond, 5.12);
  EXPECT_EQ(Memory.L2->Caches, 1u);
  EXPECT_DOUBLE_EQ(Memory.L2->BankUtilisation, 20.0 / 400);
}

// 2 ports of 8 bytes at 2 GHz: 32 GB/s. 160 bytes in 50 ns: 3.2 GB/s.
TEST(MemorySummary, DerivesSharesOfTheCrossbar) {
  MemorySummary Memory = summary(MemoryRun());
  EXPECT_DOUBLE_EQ(Memory.Crossbar->Requests.PeakGBPerSecond, 32);
  EXPECT_DOUBLE_EQ(Memory.Crossbar->Requests.ShareOfPeak, 0.1);
  EXPECT_DOUBLE_EQ(Memory.Crossbar->Answers.PeakGBPerSecond, 128);
  EXPECT_DOUBLE_EQ(Memory.Crossbar->Answers.ShareOfPeak, 0.05);
}

// 8 accesses of 32 bytes in 50 ns: 5.12 of 32 GB/s.
TEST(MemorySummary, DerivesDramRates) {
  MemorySummary Memory = summary(MemoryRun());
  EXPECT_EQ(Memory.Dram->Data.Bytes, 256u);
  EXPECT_DOUBLE_EQ(Memory.Dram->Data.PeakGBPerSecond, 32);
  EXPECT_DOUBLE_EQ(Memory.Dram->Data.ShareOfPeak, 0.16);
  EXPECT_DOUBLE_EQ(Memory.Dram->RowHitRate, 0.25);
  EXPECT_DOUBLE_EQ(Memory.Dram->MeanReadQueue, 1);
  EXPECT_DOUBLE_EQ(Memory.Dram->MeanReadLatency, 40);
  ASSERT_EQ(Memory.DramChannels.size(), 2u);
  EXPECT_DOUBLE_EQ(Memory.DramChannels[1].Data.PeakGBPerSecond, 16);
  EXPECT_DOUBLE_EQ(Memory.DramChannels[1].Data.ShareOfPeak, 0.16);
  EXPECT_DOUBLE_EQ(Memory.DramChannels[1].MeanReadQueue, 1.5);
}

TEST(MemorySummary, HasOnlyTheChipsLevels) {
  MemoryRun Run;
  Run.Chip.L1.reset();
  Run.Stats.Memory->L1.reset();
  Run.Stats.Memory->DramChannels.clear();
  MemorySummary Memory = summary(Run);
  EXPECT_FALSE(Memory.L1);
  EXPECT_FALSE(Memory.Dram);
  EXPECT_TRUE(Memory.L2);
}
