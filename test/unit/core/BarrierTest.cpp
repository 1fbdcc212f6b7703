//===- BarrierTest.cpp - Barriers and halts, cycles derived by hand -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

/// Thread t sleeps 2^Shift t cycles before the barrier: mfsr 0, sll 1, sleep 2,
/// barrier in 3 + 2^Shift t.
static Assembly staggered(int Shift) {
  Assembly A;
  return A("mfsr", 4, int(SpecialRegister::thread))("sll", 4, 4, Shift)(
      "sleep", 4)("barrier");
}

namespace {

TEST(Barrier, AllContinueAfterTheWindowOfTheLast) {
  // Four threads in two TMs arrive in 3, 4, 5, 6: all continue in cycle 16.
  Assembly A = staggered(0);
  A("halt", 0);
  Simulation S(quietChip(2, 2), A);
  EXPECT_EQ(S.cycles(), 17u);
  for (uint32_t Thread = 0; Thread != 4; ++Thread)
    EXPECT_EQ(S.lost(Thread, Loss::Barrier), 16 - (4 + Thread));
}

TEST(Barrier, EarlyThreadsWaitThroughManyWindows) {
  // Thread t arrives in 3 + 32 t; the last, 3, in 99: window 96..111. All
  // continue in 112.
  Assembly A = staggered(5);
  A("halt", 0);
  Simulation S(quietChip(2, 2), A);
  EXPECT_EQ(S.cycles(), 113u);
  for (uint32_t Thread = 0; Thread != 4; ++Thread)
    EXPECT_EQ(S.lost(Thread, Loss::Barrier), 112 - (4 + 32 * Thread));
}

TEST(Barrier, ArrivalInTheLastCycleOfAWindowContinuesInTheNext) {
  // addi 0..14, barrier 15, halt 16: nothing lost.
  Assembly A;
  A.repeat(15, "addi", 4, 0, 1)("barrier")("halt", 0);
  Simulation S(quietChip(1, 2), A);
  EXPECT_EQ(S.cycles(), 17u);
  EXPECT_EQ(S.lost(0, Loss::Barrier), 0u);
}

TEST(Barrier, HaltedThreadsAreNotWaitedFor) {
  // Thread 0 halts in cycle 2; the others arrive in 2 and continue in 16.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("beq", 4, 0, "end")("barrier")
      .label("end")("halt", 0);
  Simulation S(quietChip(1, 4), A);
  EXPECT_EQ(S.cycles(), 17u);
  EXPECT_EQ(S.lost(0, Loss::Finished), 17u - 3);
  EXPECT_EQ(S.lost(1, Loss::Barrier), 16u - 3);
}

TEST(Barrier, LastRunningThreadReleasesItByHalting) {
  // Thread 0: sleep 2 for 50 cycles, halt in 53 (window 48..63). The other
  // waits from 3 on and continues in 64.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("bne", 4, 0, "wait")(
      "addi", 5, 0, 50)("sleep", 5)("halt", 0);
  A.label("wait")("barrier")("halt", 0);
  Simulation S(quietChip(1, 2), A);
  // Thread 0: mfsr 0, bne 1, addi 2, sleep 3, halt 54.
  EXPECT_EQ(S.cycles(), 65u);
  EXPECT_EQ(S.statistics().Threads[0].FinishCycle, 55u);
  EXPECT_EQ(S.lost(1, Loss::Barrier), 64u - 3);
}

TEST(Barrier, WorksAgainAndAgain) {
  // Barriers in 1, 16+1, ...: addi, barrier, in a loop of 5 by bne.
  Assembly A;
  A("addi", 4, 0, 5)
      .label("loop")("addi", 4, 4, -1)("barrier")("bne", 4, 0, "loop")("halt",
                                                                       0);
  Simulation S(quietChip(3, 3), A);
  // Round k continues with its bne in 16 (k + 1); the last halts in 81.
  EXPECT_EQ(S.cycles(), 82u);
}

TEST(Barrier, LossAtTheCycleLimitIsCut) {
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("bne", 4, 0, "wait");
  A.label("forever")("j", "forever").label("wait")("barrier")("halt", 0);
  Simulation S(quietChip(1, 2), A);
  EXPECT_EQ(S.run(40).End, RunResult::CycleLimit);
  EXPECT_EQ(S.lost(1, Loss::Barrier), 40u - 3);
  EXPECT_EQ(S.statistics().Threads[0].Instructions, 40u);
}

TEST(Halt, StatusIsTheFirstNonZeroInThreadOrder) {
  // Thread t halts with t > 1 ? t : 0, the highest first.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("slti", 5, 4, 2)("movn", 4, 0, 5)(
      "addi", 6, 0, 10)("sub", 6, 6, 4)("sleep", 6)("halt", 4);
  Simulation S(quietChip(2, 2), A);
  RunResult Result = S.run();
  EXPECT_EQ(Result.End, RunResult::Halted);
  EXPECT_EQ(Result.ExitStatus, 2);
}

TEST(Halt, FinishedCyclesAreCounted) {
  // Thread t sleeps t cycles: mfsr 0, sleep 1, halt in 2 + t.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("sleep", 4)("halt", 0);
  Simulation S(quietChip(3, 1), A);
  EXPECT_EQ(S.cycles(), 5u);
  for (uint32_t Thread = 0; Thread != 3; ++Thread)
    EXPECT_EQ(S.lost(Thread, Loss::Finished), 2u - Thread);
}

} // namespace
