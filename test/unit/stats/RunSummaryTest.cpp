//===- RunSummaryTest.cpp - What follows from a run's counts --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/stats/SmallRun.h"

#include "gtest/gtest.h"

#include <set>

using namespace tp;

TEST(RunSummary, DerivesRates) {
  SmallRun Small;
  RunSummary Run = Small.summary();
  EXPECT_EQ(Run.threadCycles(), 200u);
  EXPECT_EQ(Small.Stats.instructions(), 110u);
  EXPECT_DOUBLE_EQ(Run.issueRate(), 0.55);
  EXPECT_DOUBLE_EQ(Run.instructionsPerCycleAndTm(), 0.55);
  EXPECT_DOUBLE_EQ(Run.seconds(), 50e-9);
  EXPECT_DOUBLE_EQ(Run.icacheUtilisation(), 0.55);
}

// INTADD: 100 operations in 2 x 100 slots. MEMORY starts every second cycle:
// 10 operations in 2 x 50 slots.
TEST(RunSummary, DerivesUtilisationFromCountAndInterval) {
  SmallRun Small;
  EXPECT_EQ(Small.summary().operations(Unit::INTADD), 100u);
  EXPECT_DOUBLE_EQ(Small.summary().utilisation(Unit::INTADD), 0.5);
  EXPECT_DOUBLE_EQ(Small.summary().utilisation(Unit::MEMORY), 0.1);
  EXPECT_EQ(Small.summary().utilisation(Unit::FPADD), 0);
  Small.Chip.Units[unsigned(Unit::INTADD)].Count = 4;
  EXPECT_DOUBLE_EQ(Small.summary().utilisation(Unit::INTADD), 0.125);
}

TEST(RunSummary, DividesNothingByNothing) {
  ChipConfig Chip;
  Statistics Stats;
  RunSummary Run{Chip, Stats, "finished", 0, {}, std::nullopt};
  EXPECT_EQ(Run.issueRate(), 0);
  EXPECT_EQ(Run.utilisation(Unit::FPADD), 0);
  EXPECT_FALSE(rayRates(Run).has_value());
}

TEST(RunSummary, NamesEveryLossOnce) {
  std::set<std::string> Names;
  for (unsigned I = 0; I != NumLosses; ++I)
    Names.insert(lossName(Loss(I)));
  EXPECT_EQ(Names.size(), NumLosses);
}

// 100 cycles at 2 GHz are 50 ns, thread 1 finished after 20 ns.
TEST(RayRates, UseEachThreadsOwnTime) {
  SmallRun Small;
  RunSummary Run = Small.summary();
  Run.Rays = {5, 10};
  std::optional<RayRates> Rates = rayRates(Run);
  ASSERT_TRUE(Rates);
  EXPECT_EQ(Rates->Rays, 15u);
  EXPECT_DOUBLE_EQ(Rates->Chip, 15 / 50e-9);
  EXPECT_DOUBLE_EQ(Rates->SlowestThread, 5 / 50e-9);
  EXPECT_DOUBLE_EQ(Rates->FastestThread, 10 / 20e-9);
  EXPECT_EQ(Rates->ThreadsWithoutRays, 0u);
}

// Thread 0 waits 60 of its 100 cycles at the barrier: 20 ns are its own.
TEST(RayRates, DoNotCountWaitsAtBarriers) {
  SmallRun Small;
  Small.Stats.Threads[0].Lost[unsigned(Loss::Barrier)] = 60;
  RunSummary Run = Small.summary();
  Run.Rays = {5, 10};
  std::optional<RayRates> Rates = rayRates(Run);
  EXPECT_DOUBLE_EQ(Rates->SlowestThread, 5 / 50e-9);
  EXPECT_DOUBLE_EQ(Rates->PerThread.Minimum, 5 / 20e-9);
  EXPECT_DOUBLE_EQ(Rates->PerThread.Mean, 7.5 / 20e-9);
  EXPECT_DOUBLE_EQ(Rates->PerThread.Median, 7.5 / 20e-9);
  EXPECT_DOUBLE_EQ(Rates->PerThread.Maximum, 10 / 20e-9);
}

TEST(RayRates, MedianOfThreeIsTheMiddleOne) {
  SmallRun Small;
  Small.Chip.TmCount = 3;
  Small.Stats.Threads.push_back(Small.Stats.Threads[1]);
  RunSummary Run = Small.summary();
  Run.Rays = {5, 10, 40};
  EXPECT_DOUBLE_EQ(rayRates(Run)->PerThread.Median, 10 / 20e-9);
}

TEST(RayRates, LeaveOutThreadsWithoutRays) {
  SmallRun Small;
  RunSummary Run = Small.summary();
  Run.Rays = {0, 10};
  EXPECT_DOUBLE_EQ(rayRates(Run)->SlowestThread, 10 / 20e-9);
  EXPECT_EQ(rayRates(Run)->ThreadsWithoutRays, 1u);
  Run.Rays = {0, 0};
  EXPECT_FALSE(rayRates(Run).has_value());
}

TEST(LargestFirst, SortsAndDropsZeros) {
  SmallRun Small;
  std::vector<OpcodeCount> Sorted = largestFirst(Small.Stats.Executed);
  ASSERT_EQ(Sorted.size(), 2u);
  EXPECT_EQ(mnemonic(Sorted[0].Op), "add");
  EXPECT_EQ(Sorted[1].Count, 10u);
}
