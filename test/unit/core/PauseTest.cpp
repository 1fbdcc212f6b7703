//===- PauseTest.cpp - Runs in several parts ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

RunLimits pauseAt(uint64_t Cycle) {
  RunLimits Limits;
  Limits.PauseCycle = Cycle;
  return Limits;
}

/// Loads in cycle 1, waits for it to 21, passes marker 3, sleeps from 22 for 40
/// cycles, passes marker 4 and halts in 63.
Assembly loadAndSleep() {
  Assembly A;
  A("lui", 20, DataBegin >> 16)("lw", 5, 20, 0)("addi", 6, 5, 40)("prof", 3)(
      "sleep", 6)("prof", 4)("halt", 0);
  return A;
}

TEST(Pause, AtTheFirstBoundaryNotBeforeTheCycle) {
  // Windows have 16 cycles.
  for (auto [Cycle, Boundary] :
       {std::pair(1u, 16u), {15u, 16u}, {16u, 16u}, {17u, 32u}, {33u, 48u}}) {
    Simulation S(quietChip(1, 1), loadAndSleep());
    EXPECT_EQ(S.run(pauseAt(Cycle)).End, RunResult::Paused);
    EXPECT_EQ(S.statistics().Cycles, Boundary);
  }
}

TEST(Pause, StatisticsEndAtThePause) {
  Simulation S(quietChip(1, 1), loadAndSleep());
  S.run(pauseAt(16));
  // Two instructions, and waiting from 2 on.
  EXPECT_EQ(S.statistics().Threads[0].Instructions, 2u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 14u);
  S.run(pauseAt(48));
  // addi in 21, sleep in 22, asleep from 23 on.
  EXPECT_EQ(S.statistics().Threads[0].Instructions, 4u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 19u);
  EXPECT_EQ(S.lost(0, Loss::Sleep), 25u);
  EXPECT_EQ(S.cycles(), 64u);
  EXPECT_EQ(S.statistics().Threads[0].Instructions, 5u);
  EXPECT_EQ(S.lost(0, Loss::Sleep), 40u);
}

TEST(Pause, NothingIsRunIfTheCycleHasPassed) {
  Simulation S(quietChip(1, 1), loadAndSleep());
  S.run(pauseAt(32));
  EXPECT_EQ(S.run(pauseAt(20)).End, RunResult::Paused);
  EXPECT_EQ(S.statistics().Cycles, 32u);
}

TEST(Pause, AtTheEndOfAMarkersWindow) {
  Simulation S(quietChip(1, 1), loadAndSleep());
  RunLimits Limits;
  Limits.PauseMarkers = {3, 4};
  // sleep, which marker 3 precedes, is in window [16, 32); halt in [48, 64).
  for (uint64_t End : {32u, 64u}) {
    S.run(Limits);
    EXPECT_EQ(S.statistics().Cycles, End);
  }
  EXPECT_EQ(S.run(Limits).End, RunResult::Halted);
}

TEST(Pause, AStoppedRunGoesOn) {
  Simulation S(quietChip(1, 1), loadAndSleep());
  std::atomic<bool> Stop = true;
  RunLimits Limits;
  Limits.Stop = &Stop;
  EXPECT_EQ(S.run(Limits).End, RunResult::Stopped);
  EXPECT_EQ(S.run(Limits).End, RunResult::Stopped);
  Stop = false;
  EXPECT_EQ(S.run(Limits).End, RunResult::Halted);
  EXPECT_EQ(S.statistics().Cycles, 64u);
}

TEST(Pause, AnEndedRunStaysEnded) {
  Simulation S(quietChip(1, 1), loadAndSleep());
  EXPECT_EQ(S.run(30).End, RunResult::CycleLimit);
  EXPECT_EQ(S.run().End, RunResult::CycleLimit);
  EXPECT_EQ(S.statistics().Cycles, 30u);
}

} // namespace
