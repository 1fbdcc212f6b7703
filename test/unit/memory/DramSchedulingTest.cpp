//===- DramSchedulingTest.cpp - Which request a DRAM channel serves first ===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Every figure is derived by hand from the times in smallDram().
//
//===----------------------------------------------------------------------===//

#include "test/unit/memory/DramBench.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

void openRow(DramBench &Bench) {
  Bench.read(0, 1000, 0, 0);
  Bench.run(100);
}

TEST(DramScheduling, RowHitsPassOlderRequests) {
  DramBench Bench(smallDram());
  openRow(Bench);
  Bench.read(100, 1, 0, 1);
  Bench.read(100, 2, 0, 0, 1);
  Bench.read(100, 3, 0, 0, 2);
  Bench.run(200);
  // tCCDL = 4 between the hits, tRTP = 6 behind the last.
  EXPECT_EQ(Bench.Trace, "RD0@100 RD0@104 PRE0@110 ACT0@117 RD0@127");
  EXPECT_EQ(Bench.Ready[2], 111);
  EXPECT_EQ(Bench.Ready[3], 115);
  EXPECT_EQ(Bench.Ready[1], 138);
}

TEST(DramScheduling, OldestRowHitFirst) {
  DramBench Bench(smallDram());
  Bench.read(0, 1, 2, 0); // in the other group
  openRow(Bench);
  Bench.read(100, 2, 2, 0, 1);
  Bench.read(100, 3, 0, 0, 1);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "RD2@100 RD0@102");
}

TEST(DramScheduling, LimitOfRowHitsEndsStarvation) {
  DramConfig Config = smallDram();
  Config.RowHitLimit = 1;
  DramBench Bench(Config);
  openRow(Bench);
  Bench.read(100, 1, 0, 1);
  Bench.read(100, 2, 0, 0, 1);
  Bench.read(100, 3, 0, 0, 2);
  Bench.run(300);
  // One hit passes; then row 1 has its turn, which stays open for tRAS = 25.
  EXPECT_EQ(Bench.Trace, "RD0@100 PRE0@106 ACT0@113 RD0@123 PRE0@138 ACT0@145 "
                         "RD0@155");
  EXPECT_EQ(Bench.Channel.statistics(300).RowConflicts, 2);
}

TEST(DramScheduling, RowsOpenWhileOthersRead) {
  DramBench Bench(smallDram());
  openRow(Bench);
  Bench.read(100, 1, 2, 0);
  Bench.read(100, 2, 0, 0, 1);
  Bench.read(100, 3, 0, 0, 2);
  Bench.run(200);
  // A hit takes the tick, the activate the next one.
  EXPECT_EQ(Bench.Trace, "RD0@100 ACT2@101 RD0@104 RD2@111");
}

TEST(DramScheduling, WritesWaitForTheHighMark) {
  DramConfig Config = smallDram();
  Config.WriteHighMark = 4;
  Config.WriteLowMark = 2;
  DramBench Bench(Config);
  openRow(Bench);
  for (uint32_t Column = 0; Column < 5; ++Column)
    Bench.read(100, Column, 0, 0, Column);
  for (uint32_t Column = 0; Column < 4; ++Column)
    Bench.write(100, 10 + Column, 2, 0, Column);
  Bench.run(300);
  // The read of openRow() and the first one here are high - low = 2 bursts, so
  // that the writes may have the bus from 101 on: an activate, and the first
  // write after tRTW = 12. Two writes (tCCDL = 4) reach the low mark. Reads
  // after 116 + 4 + 2 + tWTRS = 6, all of them; then the other two writes,
  // after 140 + tRTW.
  EXPECT_EQ(Bench.Trace, "RD0@100 ACT2@101 WR2@112 WR2@116 RD0@128 RD0@132 "
                         "RD0@136 RD0@140 WR2@152 WR2@156");
  DramChannelStatistics Counts = Bench.Channel.statistics(300);
  EXPECT_EQ(Counts.WriteDrains, 2);
  EXPECT_EQ(Counts.MaxWriteQueue, 4);
  for (uint32_t Column = 0; Column < 4; ++Column)
    EXPECT_EQ(Bench.Ready[10 + Column], 100); // posted
}

TEST(DramScheduling, WritesBelowTheMarkWaitForReads) {
  DramBench Bench(smallDram());
  openRow(Bench);
  Bench.write(100, 1, 0, 0, 1);
  Bench.read(100, 2, 0, 0, 2);
  Bench.read(103, 3, 0, 0, 3);
  Bench.run(200);
  // No read waits from 101 on, but one comes before tRTW is over.
  EXPECT_EQ(Bench.Trace, "RD0@100 RD0@104 WR0@116");
}

TEST(DramScheduling, ReadsTakeTurnsWithAFullWriteQueue) {
  DramConfig Config = smallDram();
  Config.WriteQueueEntries = 4;
  Config.WriteHighMark = 2;
  Config.WriteLowMark = 0;
  DramBench Bench(Config);
  openRow(Bench);
  Bench.read(100, 0, 0, 0, 0);
  Bench.read(100, 1, 0, 0, 1);
  Bench.read(100, 2, 0, 0, 2);
  for (uint32_t Column = 0; Column < 6; ++Column)
    Bench.write(100, 10 + Column, 0, 0, Column);
  Bench.run(400);
  // The bus turns after two bursts (one of them openRow()'s) although the write
  // queue never empties: four writes fit, the others fill it up. Reads after
  // the write at 116: 116 + 4 + 2 + tWTRL = 8.
  EXPECT_EQ(Bench.Trace, "RD0@100 WR0@112 WR0@116 RD0@130 RD0@134 WR0@146 "
                         "WR0@150 WR0@154 WR0@158");
  // The fifth write gets the place that the write at 112 leaves.
  EXPECT_EQ(Bench.Ready[13], 100);
  EXPECT_EQ(Bench.Ready[14], 113);
}

TEST(DramScheduling, ReadsBeyondTheQueueWaitInFront) {
  DramConfig Config = smallDram();
  Config.ReadQueueEntries = 1;
  DramBench Bench(Config);
  openRow(Bench);
  Bench.read(100, 1, 0, 1);
  Bench.read(100, 2, 0, 0, 1);
  Bench.run(300);
  // The second would have been a row hit, but is not seen before 118.
  EXPECT_EQ(Bench.Trace, "PRE0@100 ACT0@107 RD0@117 PRE0@132 ACT0@139 RD0@149");
  EXPECT_EQ(Bench.Channel.statistics(300).MaxReadQueue, 1);
}

TEST(DramScheduling, WriteQueueAnswersReadsAndMergesWrites) {
  DramBench Bench(smallDram());
  Bench.write(0, 1, 0, 0, 5);
  Bench.write(0, 2, 0, 0, 5);
  Bench.read(0, 3, 0, 0, 5);
  Bench.run(100);
  EXPECT_EQ(Bench.Trace, "ACT0@0 WR0@8");
  EXPECT_EQ(Bench.Ready[3], 9 + 2); // as a row hit
  DramChannelStatistics Counts = Bench.Channel.statistics(100);
  EXPECT_EQ(Counts.Writes, 1);
  EXPECT_EQ(Counts.MergedWrites, 1);
  EXPECT_EQ(Counts.ForwardedReads, 1);
  EXPECT_EQ(Counts.Reads, 0);
  EXPECT_EQ(Counts.Pending, 0);
}

TEST(DramScheduling, CountsWhatWaits) {
  DramBench Bench(smallDram());
  Bench.read(0, 1, 0, 0);
  Bench.read(0, 2, 0, 1);
  Bench.read(50, 3, 0, 1, 1);
  Bench.run(12);
  EXPECT_EQ(Bench.Channel.statistics(12).Pending, 2);
  // PRE is allowed at 25.
  EXPECT_EQ(Bench.Channel.nextEvent(), 25);
}

} // namespace
