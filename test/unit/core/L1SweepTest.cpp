//===- L1SweepTest.cpp - TPs that share an L1 -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Windows of 16 cycles; the L1 serves one request a cycle.
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/ScriptedMemory.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint32_t DataHigh = DataBegin >> 16;
constexpr int64_t After20 = 2 * 256;
constexpr int ThreadRegister = int(SpecialRegister::thread);

Simulation simulate(const ChipConfig &Chip, const Assembly &A) {
  return Simulation(Chip, A, 1, ScriptedMemory::make(Chip));
}

TEST(L1Sweep, HitsComeBackWithinTheWindow) {
  // lui 0, lw 1, addi 1 + 3, lw 5, addi 8, halt 9.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, 0)("addi", 6, 5, 1)("lw", 7, 20, 4)(
      "addi", 8, 7, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1, 3), A);
  EXPECT_EQ(S.cycles(), 10u);
  EXPECT_EQ(S.lost(0, Loss::L1), 4u);
}

TEST(L1Sweep, AHitThatIsReadyInTimeCostsNothing) {
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, 0)("addi", 7, 0, 1)("addi", 7, 0, 1)(
      "addi", 6, 5, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1, 3), A);
  EXPECT_EQ(S.cycles(), 6u);
}

TEST(L1Sweep, RequestsOfACycleAreServedInTheOrderOfPriority) {
  // All four load in 1; the L1 serves them in 1, 2, 3, 4, results 2 later.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, 0)("addi", 6, 5, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 4, 2), A);
  S.cycles();
  for (uint32_t T = 0; T != 4; ++T)
    EXPECT_EQ(S.statistics().Threads[T].FinishCycle, 1 + T + 2 + 2) << T;
}

TEST(L1Sweep, EarlierRequestsOfLowerPriorityAreServedFirst) {
  // Thread 1 loads in 2 and 3, thread 0, after mfsr, bne and an addi, in 4; it
  // is served in 4 all the same. Without thread 0's addi both load in 3: thread
  // 0 first, thread 1's second load in 4.
  for (unsigned Delay : {0u, 1u}) {
    Assembly A;
    A("lui", 20, DataHigh)("mfsr", 4, ThreadRegister)("bne", 4, 0, "other")
        .repeat(Delay, "addi", 7, 0, 1);
    A("lw", 5, 20, 0)("addi", 6, 5, 1)("halt", 0);
    A.label("other")("lw", 5, 20, 0)("lw", 6, 20, 0)("lw", 7, 20, 0)(
        "addi", 8, 7, 1)("halt", 0);
    Simulation S = simulate(ScriptedMemory::chip(1, 2, 1), A);
    S.cycles();
    // No delay: thread 0 loads in 3, served in 3, addi 4, halt 5. Thread 1
    // loads in 3, 4, 5, served in 4, 5, 6: addi in 7, halt in 8.
    // Delay: thread 0 loads in 4. Thread 1's load of 3 is served in 3, thread
    // 0's in 4, before thread 1's of 4 in 5: addi in 5, halt in 6. Thread 1's
    // third is served in 6: addi 7, halt 8.
    EXPECT_EQ(S.statistics().Threads[0].FinishCycle, 6 + Delay);
    EXPECT_EQ(S.statistics().Threads[1].FinishCycle, 9u);
  }
}

TEST(L1Sweep, AHigherPriorityThatComesBackTakesItsUnitFirst) {
  // One multiplier. Thread 0 waits for its hit from 3 + 1 to 3 + 4 and then
  // multiplies in 7, 8, 9; thread 1 multiplies from 3 on, in 3, 4, 5, 6, then
  // only from 10 on.
  ChipConfig Chip = ScriptedMemory::chip(1, 2, 4);
  Chip.Units[unsigned(Unit::FPMUL)].Count = 1;
  Assembly A;
  A("lui", 20, DataHigh)("mfsr", 4, ThreadRegister)("bne", 4, 0, "other")(
      "lwc1", 5, 20, 0)("mul_s", 6, 5, 5)("mul_s", 7, 8, 8)("mul_s", 9, 10,
                                                            10)("halt", 0);
  A.label("other");
  A.repeat(6, "mul_s", 1, 2, 2)("halt", 0);
  Simulation S = simulate(Chip, A);
  S.cycles();
  EXPECT_EQ(S.statistics().Threads[0].FinishCycle, 11u);
  // 3 to 6, conflicts in 7, 8, 9, then 10 and 11, halt in 12.
  EXPECT_EQ(S.statistics().Threads[1].FinishCycle, 13u);
  EXPECT_EQ(S.lost(1, Loss::UnitConflict), 3u);
  EXPECT_EQ(S.lost(0, Loss::L1), 3u);
}

TEST(L1Sweep, MissesComeBackInALaterWindow) {
  // lui 0, lw 1 answered in 21, addi 21, lw 22 hits at 24, addi 24, halt 25.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After20)("addi", 6, 5, 1)("lw", 7, 20, 0)(
      "addi", 8, 7, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1, 2), A);
  EXPECT_EQ(S.cycles(), 26u);
  EXPECT_EQ(S.lost(0, Loss::L2), 19u);
  EXPECT_EQ(S.lost(0, Loss::L1), 1u);
}

TEST(L1Sweep, RequestsThatWaitAtTheWindowsEndAreServedInTheNext) {
  // Eight TPs load in 14 of window [0, 16): served in 14 to 21 in the order of
  // priority, results 2 later, each halts 2 after that.
  Assembly A;
  A("lui", 20, DataHigh).repeat(13, "addi", 7, 0, 1);
  A("lw", 5, 20, 0)("addi", 6, 5, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 8, 2), A);
  S.cycles();
  for (uint32_t T = 0; T != 8; ++T)
    EXPECT_EQ(S.statistics().Threads[T].FinishCycle, 14 + T + 2 + 2) << T;
}

TEST(L1Sweep, StoresThatTheL1TakesFreeTheirEntryWithinTheWindow) {
  // Two entries. sw 1, 2 are taken in 4, 5; the third store waits from 3 to 4,
  // the fourth issues in 5, halt 6.
  Assembly A;
  A("lui", 20, DataHigh).repeat(4, "sw", 0, 20, 0)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1, 3), A);
  EXPECT_EQ(S.cycles(), 7u);
  EXPECT_EQ(S.lost(0, Loss::StoreBuffer), 1u);
}

TEST(L1Sweep, OwnStoresAreForwardedAcrossSweeps) {
  // Both store, wait for a hit and load what they stored: a TP sees its own
  // store, not that of the other, in between.
  Assembly A;
  A("lui", 20, DataHigh)("mfsr", 4, ThreadRegister)("addi", 4, 4, 100)(
      "sw", 4, 20, 16)("lw", 5, 20, 0)("add", 6, 5, 4)("lw", 7, 20, 16)(
      "addi", 8, 7, 0)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 2, 2), A);
  S.cycles();
  EXPECT_EQ(S.registerOf(0, 8), 100u);
  EXPECT_EQ(S.registerOf(1, 8), 101u);
  EXPECT_EQ(S.word(DataBegin + 16), 101u);
}

} // namespace
