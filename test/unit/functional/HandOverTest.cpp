//===- HandOverTest.cpp - From the functional mode to the engine ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/functional/FunctionalSimulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static constexpr int ThreadNumber = int(SpecialRegister::thread);

namespace {

TEST(HandOver, ThreadsStopBehindTheMarker) {
  // Thread 0 halts before the marker, 1 waits at a barrier, 2 and 3 pass the
  // marker and then the barrier.
  Assembly A;
  A("mfsr", 4, ThreadNumber)("beq", 4, 0, "end")("addi", 5, 4, -1)(
      "beq", 5, 0, "barrier")("prof", 6)("addi", 6, 0, 1)
      .label("barrier")("barrier")("addi", 7, 0, 2)
      .label("end")("halt", 0);
  FunctionalSimulation S(quietChip(1, 4), A);
  FunctionalLimits Limits;
  Limits.StopMarker = 6;
  EXPECT_EQ(S.Machine.run(Limits).End, RunResult::Paused);
  std::vector<ArchitecturalState> States = S.Machine.threads();
  ASSERT_EQ(States.size(), 4u);
  EXPECT_EQ(States[0].State, ThreadState::Halted);
  EXPECT_EQ(States[1].State, ThreadState::AtBarrier);
  for (unsigned Thread : {2, 3}) {
    EXPECT_EQ(States[Thread].State, ThreadState::Running);
    EXPECT_EQ(States[Thread].Pc, TextBegin + 5 * 4);
    EXPECT_EQ(States[Thread].Registers[6], 0u);
  }

  // Cycle mode: threads 2 and 3 issue addi in 0, barrier in 1; all three go on
  // in 16 with addi, halt in 17.
  Engine Machine(S.Chip, S.Text, S.Global);
  Machine.setInitialState(States);
  EXPECT_EQ(Machine.run().End, RunResult::Halted);
  Statistics Counts = Machine.statistics();
  EXPECT_EQ(Counts.Cycles, 18u);
  EXPECT_EQ(Counts.Threads[0].Lost[unsigned(Loss::Finished)], 18u);
  EXPECT_EQ(Counts.Threads[1].Lost[unsigned(Loss::Barrier)], 16u);
  EXPECT_EQ(Counts.Threads[2].Lost[unsigned(Loss::Barrier)], 14u);
  EXPECT_EQ(Counts.instructions(), 2 * 4 + 2u);
  EXPECT_EQ(Machine.registerOf(1, 7), 2u);
  EXPECT_EQ(Machine.registerOf(3, 6), 1u);

  // The functional mode can go on as well.
  EXPECT_EQ(S.Machine.run().End, RunResult::Halted);
  EXPECT_EQ(S.Machine.registerOf(1, 7), 2u);
  EXPECT_EQ(S.Machine.statistics().Markers[6], 2u);
}

TEST(HandOver, LocalStoresAndStatus) {
  // The status of thread 1 is from before the marker, that of 0 from a value
  // that its local store has kept.
  Assembly A;
  A.constant(4, LocalBegin)("mfsr", 5, ThreadNumber)("addi", 6, 5, 40)(
       "sw", 6, 4, 8)("beq", 5, 0, "main")("halt", 5)
      .label("main")("prof", 1)("lw", 7, 4, 8)("halt", 7);
  FunctionalSimulation S(quietChip(1, 2), A);
  FunctionalLimits Limits;
  Limits.StopMarker = 1;
  S.Machine.run(Limits);
  Engine Machine(S.Chip, S.Text, S.Global);
  Machine.setInitialState(S.Machine.threads());
  EXPECT_EQ(Machine.run().ExitStatus, 40);
  EXPECT_EQ(Machine.statusOf(1), 1);
}

TEST(HandOver, EndsWithoutTheMarker) {
  Assembly A;
  A("halt", 0);
  FunctionalSimulation S(quietChip(1, 2), A);
  FunctionalLimits Limits;
  Limits.StopMarker = 1;
  EXPECT_EQ(S.Machine.run(Limits).End, RunResult::Halted);
}

} // namespace
