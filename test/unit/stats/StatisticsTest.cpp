//===- StatisticsTest.cpp - Differences and sums of counts ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/MemoryCounts.h"
#include "simulator/stats/SumCheck.h"
#include "test/unit/stats/MemoryRun.h"

#include "gtest/gtest.h"

using namespace tp;

/// The run of \p Small's later half, which repeats the first: twice of all.
static Statistics doubled(const SmallRun &Small) {
  Statistics Twice = Small.Stats;
  Twice += Small.Stats;
  return Twice;
}

TEST(Statistics, ASumOfPartsAddsUp) {
  MemoryRun Run;
  Run.Stats.Markers = {0, 3};
  Statistics Twice = doubled(Run);
  EXPECT_EQ(Twice.Cycles, 200u);
  EXPECT_EQ(Twice.instructions(), 220u);
  EXPECT_EQ(Twice.Markers, (std::vector<uint64_t>{0, 6}));
  EXPECT_EQ(Twice.Memory->L1->Hits, 60u);
  EXPECT_EQ(Twice.Memory->DramChannels[0].ReadLatency[6], 6u);
  EXPECT_EQ(Twice.Memory->DramChannels[1].MaxReadQueue, 4u);
  EXPECT_EQ(llvm::toString(checkSums(Run.Chip, Twice, Run.Opcodes)), "");
}

TEST(Statistics, ADifferenceIsWhatCameSince) {
  MemoryRun Run;
  Run.Stats.Markers = {0, 3};
  Statistics Since = doubled(Run).since(Run.Stats);
  EXPECT_EQ(Since.Cycles, 100u);
  EXPECT_EQ(Since.GlobalAccesses, 52u);
  EXPECT_EQ(Since.Executed, Run.Stats.Executed);
  EXPECT_EQ(Since.Markers, Run.Stats.Markers);
  EXPECT_EQ(Since.Threads[0].Lost, Run.Stats.Threads[0].Lost);
  EXPECT_EQ(Since.Pcs[0].Executed, 100u);
  EXPECT_EQ(Since.Memory->Crossbar->RequestBytes, 160u);
  EXPECT_EQ(Since.Memory->DramChannels[0].ReadLatency[6], 3u);
  EXPECT_EQ(Since.Memory->DramChannels[1].MaxReadQueue, 4u);
  EXPECT_EQ(llvm::toString(checkSums(Run.Chip, Since, Run.Opcodes)), "");
}

TEST(Statistics, SinceNothingIsAll) {
  MemoryRun Run;
  Statistics Since = Run.Stats.since(Statistics());
  EXPECT_EQ(Since.Cycles, 100u);
  EXPECT_EQ(Since.Memory->L2->Misses, 5u);
  Statistics Sum;
  Sum += Run.Stats;
  EXPECT_EQ(llvm::toString(checkSums(Run.Chip, Sum, Run.Opcodes)), "");
}

// A marker beyond those of the earlier statistics has no entry there.
TEST(Statistics, LaterMarkersCount) {
  SmallRun Run;
  Run.Stats.Markers = {1};
  Statistics Later = Run.Stats;
  Later.Markers = {1, 5};
  EXPECT_EQ(Later.since(Run.Stats).Markers, (std::vector<uint64_t>{0, 5}));
  Run.Stats += Later;
  EXPECT_EQ(Run.Stats.Markers, (std::vector<uint64_t>{2, 5}));
}

// What is under way may become less.
TEST(Statistics, LevelsMayFall) {
  MemoryRun Run;
  Statistics Later = Run.Stats;
  Later.Memory->SentByL2sUnderWay = 0;
  EXPECT_EQ(int64_t(Later.since(Run.Stats).Memory->SentByL2sUnderWay), -1);
}

TEST(Statistics, ChannelsAddUp) {
  MemoryRun Run;
  DramChannelStatistics Sum = sumOfChannels(Run.Stats.Memory->DramChannels);
  EXPECT_EQ(Sum.Reads, 6u);
  EXPECT_EQ(Sum.ReadQueueTicks, 100u);
  EXPECT_EQ(Sum.MaxReadQueue, 4u);
  EXPECT_EQ(Sum.ReadLatency[6], 6u);
}
