//===- DramTimingTest.cpp - Commands of a DRAM channel keep their times --===//
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

/// Opens row 0 in \p Banks banks, and waits until nothing of that matters.
void openRows(DramBench &Bench, uint32_t Banks) {
  for (uint32_t Bank = 0; Bank < Banks; ++Bank)
    Bench.read(0, 1000 + Bank, Bank, 0);
  Bench.run(100);
}

TEST(DramTiming, RowMissActivatesAndReads) {
  DramBench Bench(smallDram());
  Bench.read(0, 1, 0, 0);
  Bench.run(100);
  EXPECT_EQ(Bench.Trace, "ACT0@0 RD0@10"); // tRCDRD = 10
  EXPECT_EQ(Bench.Ready[1], 10 + 9 + 2);   // CL + burst
  DramChannelStatistics Counts = Bench.Channel.statistics(100);
  EXPECT_EQ(Counts.RowMisses, 1);
  EXPECT_EQ(Counts.RowHits + Counts.RowConflicts, 0);
  EXPECT_EQ(Counts.ReadLatency[5], 1); // 16 <= 21 < 32
  EXPECT_EQ(Counts.Ticks, 100);
  EXPECT_EQ(Counts.BusBusyTicks, 2);
  EXPECT_EQ(Counts.ReadQueueTicks, 10); // in the queue in ticks 0 to 9
}

TEST(DramTiming, RowHitReadsAtOnce) {
  DramBench Bench(smallDram());
  openRows(Bench, 1);
  Bench.read(100, 1, 0, 0, 3);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "RD0@100");
  EXPECT_EQ(Bench.Ready[1], 100 + 9 + 2);
  EXPECT_EQ(Bench.Channel.statistics(200).RowHits, 1);
}

TEST(DramTiming, RowConflictPrechargesFirst) {
  DramBench Bench(smallDram());
  openRows(Bench, 1);
  Bench.read(100, 1, 0, 1);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "PRE0@100 ACT0@107 RD0@117"); // tRP = 7, tRCDRD
  EXPECT_EQ(Bench.Ready[1], 117 + 9 + 2);
  EXPECT_EQ(Bench.Channel.statistics(200).RowConflicts, 1);
}

TEST(DramTiming, RowStaysOpenForRas) {
  DramBench Bench(smallDram());
  Bench.read(0, 1, 0, 0);
  Bench.read(12, 2, 0, 1);
  Bench.run(100);
  // tRAS = 25 after the activate, later than tRTP = 6 after the read.
  EXPECT_EQ(Bench.Trace, "ACT0@0 RD0@10 PRE0@25 ACT0@32 RD0@42");
}

TEST(DramTiming, PrechargeWaitsForRead) {
  DramBench Bench(smallDram());
  openRows(Bench, 1);
  Bench.read(100, 1, 0, 0);
  Bench.read(101, 2, 0, 1);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "RD0@100 PRE0@106 ACT0@113 RD0@123"); // tRTP = 6
}

TEST(DramTiming, PrechargeWaitsForWriteRecovery) {
  DramBench Bench(smallDram());
  openRows(Bench, 1);
  Bench.write(100, 1, 0, 0);
  Bench.write(101, 2, 0, 1);
  Bench.run(200);
  // Data ends at 100 + CWL 4 + burst 2 = 106; tWR = 11; tRCDWR = 8.
  EXPECT_EQ(Bench.Trace, "WR0@100 PRE0@117 ACT0@124 WR0@132");
}

TEST(DramTiming, ActivatesKeepTheirDistance) {
  DramBench Bench(smallDram());
  Bench.read(0, 1, 0, 0);
  Bench.read(0, 2, 1, 0);
  Bench.read(0, 3, 2, 0);
  Bench.run(100);
  // Bank 2, in the other group, after tRRDS = 3; bank 1, of the same group,
  // would be allowed after tRRDL = 5, but must keep tRRDS from bank 2's.
  EXPECT_EQ(Bench.Trace, "ACT0@0 ACT2@3 ACT1@6 RD0@10 RD2@13 RD1@16");
}

TEST(DramTiming, ActivatesOfAGroupKeepTheLongDistance) {
  DramBench Bench(smallDram());
  Bench.read(0, 1, 0, 0);
  Bench.read(0, 2, 1, 0);
  Bench.run(100);
  EXPECT_EQ(Bench.Trace, "ACT0@0 ACT1@5 RD0@10 RD1@15"); // tRRDL = 5
}

TEST(DramTiming, FiveActivatesTakeFaw) {
  DramConfig Config = smallDram();
  Config.BankGroups = 4;
  Config.FawTicks = 40;
  DramBench Bench(Config);
  // Banks 0, 2, 4, 6 are in groups of their own; 1 is in group 0.
  unsigned Tag = 0;
  for (uint32_t Bank : {0, 2, 4, 6, 1})
    Bench.read(0, Tag++, Bank, 0);
  Bench.run(100);
  EXPECT_EQ(Bench.Trace, "ACT0@0 ACT2@3 ACT4@6 ACT6@9 RD0@10 RD2@13 RD4@16 "
                         "RD6@19 ACT1@40 RD1@50");
}

TEST(DramTiming, ReadAfterWriteOfTheGroup) {
  DramBench Bench(smallDram());
  openRows(Bench, 4);
  Bench.write(100, 1, 0, 0);
  Bench.read(101, 2, 1, 0);
  Bench.run(200);
  // Data ends at 100 + 4 + 2; tWTRL = 8.
  EXPECT_EQ(Bench.Trace, "WR0@100 RD1@114");
  EXPECT_EQ(Bench.Ready[2], 114 + 9 + 2);
}

TEST(DramTiming, ReadAfterWriteOfAnotherGroup) {
  DramBench Bench(smallDram());
  openRows(Bench, 4);
  Bench.write(100, 1, 0, 0);
  Bench.read(101, 2, 2, 0);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "WR0@100 RD2@112"); // tWTRS = 6
}

TEST(DramTiming, WriteAfterRead) {
  DramBench Bench(smallDram());
  openRows(Bench, 4);
  Bench.read(100, 1, 0, 0);
  Bench.write(101, 2, 3, 0);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "RD0@100 WR3@112"); // tRTW = 12
}

TEST(DramTiming, BurstsOfAGroupKeepTheLongDistance) {
  DramBench Bench(smallDram());
  openRows(Bench, 4);
  Bench.read(100, 1, 0, 0, 1);
  Bench.read(100, 2, 0, 0, 2);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "RD0@100 RD0@104"); // tCCDL = 4
  Bench.read(200, 3, 0, 0, 1);
  Bench.read(200, 4, 2, 0, 1);
  Bench.run(300);
  EXPECT_EQ(Bench.Trace, "RD0@200 RD2@202"); // tCCDS = 2
}

TEST(DramTiming, RefreshClosesAllRows) {
  DramConfig Config = smallDram();
  Config.RefiTicks = 200;
  DramBench Bench(Config);
  openRows(Bench, 2);
  Bench.read(200, 1, 0, 0);
  Bench.run(300);
  // tRP = 7 after the precharge, then tRFC = 50, tRCDRD = 10.
  EXPECT_EQ(Bench.Trace, "PREA@200 REF@207 ACT0@257 RD0@267");
  DramChannelStatistics Counts = Bench.Channel.statistics(300);
  EXPECT_EQ(Counts.Refreshes, 1);
  EXPECT_EQ(Counts.RefreshTicks, 50);
  EXPECT_EQ(Counts.Precharges, 2);
}

TEST(DramTiming, RefreshWaitsForRecovery) {
  DramConfig Config = smallDram();
  Config.RefiTicks = 200;
  DramBench Bench(Config);
  openRows(Bench, 1);
  Bench.write(199, 1, 0, 0);
  Bench.write(199, 2, 0, 0, 1);
  Bench.run(300);
  // The second write must wait until the refresh is over.
  EXPECT_EQ(Bench.Trace, "WR0@199 PREA@216 REF@223 ACT0@273 WR0@281");
}

TEST(DramTiming, IdleChannelCatchesUpWithRefreshes) {
  DramConfig Config = smallDram();
  Config.RefiTicks = 200;
  DramBench Bench(Config);
  openRows(Bench, 1);
  EXPECT_EQ(Bench.Channel.nextEvent(), ~uint64_t(0));
  EXPECT_EQ(Bench.Channel.statistics(900).Refreshes, 4);
  Bench.read(1000, 1, 0, 0);
  EXPECT_EQ(Bench.Channel.nextEvent(), 200); // the first of five refreshes
  Bench.run(1100);
  EXPECT_EQ(Bench.Trace, "PREA@200 REF@207 REF@400 REF@600 REF@800 REF@1000 "
                         "ACT0@1050 RD0@1060");
}

TEST(DramTiming, OneCommandATick) {
  DramBench Bench(smallDram());
  openRows(Bench, 1);
  Bench.read(100, 1, 0, 0);
  Bench.read(100, 2, 2, 0);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "RD0@100 ACT2@101 RD2@111");
}

TEST(DramTiming, ABusEachForRowsAndColumns) {
  DramConfig Config = smallDram();
  Config.CommandBuses = 2;
  DramBench Bench(Config);
  openRows(Bench, 1);
  Bench.read(100, 1, 0, 0);
  Bench.read(100, 2, 2, 0);
  Bench.run(200);
  EXPECT_EQ(Bench.Trace, "RD0@100 ACT2@100 RD2@110");
}

TEST(DramTiming, ClocksOfAnyRatio) {
  DramConfig Config = smallDram();
  Config.ClockKHz = 1'750'000;
  Config.ControllerCycles = 5;
  DramBench Bench(Config);
  Bench.read(3, 1, 0, 0);
  Bench.run(100);
  // Cycle 3 begins at tick 5.25. Data ends with tick 6 + 10 + 9 + 2 = 27, which
  // is in cycle 15.43.
  EXPECT_EQ(Bench.Trace, "ACT0@6 RD0@16");
  EXPECT_EQ(Bench.Ready[1], 16 + 5);
  // 11 ticks are 6.29 cycles.
  EXPECT_EQ(minimumDramReadCycles(Config, 1'000'000), 7 + 5);
  EXPECT_EQ(minimumDramWriteCycles(Config), 5);
}

} // namespace
