//===- PcStatisticsTest.cpp - Where in the text the cycles go -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

uint64_t lostAt(const Simulation &S, unsigned Word, Loss Reason) {
  return S.statistics().Pcs[Word].Lost[unsigned(Reason)];
}

TEST(PcStatistics, CountsAtTheInstructionThatWaits) {
  // Branches take 3 cycles. lui 0, lw 1; word 2 waits to 21, loops twice: bne
  // in 22, two cycles lost behind it, addi 25, bne 26, addi 27; sleep 28 for
  // the 7 cycles to 36, sync in 36 to 48, halt 48.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("lw", 5, 20, 0);
  A.label("loop")("addi", 5, 5, -1)("bne", 5, 0, "loop")("addi", 6, 0, 7);
  A("sleep", 6)("sync")("halt", 0);
  ChipConfig Chip = quietChip(1, 1);
  Chip.Latency[unsigned(LatencyClass::Branch)] = 3;
  Simulation S(Chip, A);
  S.setWord(DataBegin, 2);
  S.cycles();
  const uint64_t Executed[] = {1, 1, 2, 2, 1, 1, 1, 1};
  ASSERT_EQ(S.statistics().Pcs.size(), std::size(Executed));
  for (unsigned Word = 0; Word != std::size(Executed); ++Word)
    EXPECT_EQ(S.statistics().Pcs[Word].Executed, Executed[Word]) << Word;
  EXPECT_EQ(lostAt(S, 2, Loss::Memory), 19u);
  EXPECT_EQ(lostAt(S, 3, Loss::Branch), 2u);
  EXPECT_EQ(lostAt(S, 5, Loss::Sleep), 7u);
  EXPECT_EQ(lostAt(S, 6, Loss::Sync), 11u);
}

TEST(PcStatistics, ConflictsAreAtTheInstructionThatMissedItsSlot) {
  // Four TPs, one multiplier: 0 + 1 + 2 + 3 cycles lost at word 0.
  ChipConfig Chip = quietChip(1, 4);
  Chip.Units[unsigned(Unit::FPMUL)].Count = 1;
  Assembly A;
  A("mul_s", 1, 2, 3)("halt", 0);
  Simulation S(Chip, A);
  S.cycles();
  EXPECT_EQ(lostAt(S, 0, Loss::UnitConflict), 6u);
}

TEST(PcStatistics, AWaitIsCutWhereTheRunEnds) {
  Assembly A;
  A("lui", 20, DataBegin >> 16)("lw", 5, 20, 0)("addi", 5, 5, -1)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.run(10);
  EXPECT_EQ(lostAt(S, 2, Loss::Memory), 8u);
}

TEST(PcStatistics, WhoStillWaitsAtABarrierIsChargedForIt) {
  // Thread 0 arrives in 2 and waits to the end of the window; thread 1 sleeps.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("bne", 4, 0,
                                             "other")("barrier")("halt", 0);
  A.label("other")("addi", 5, 0, 100)("sleep", 5)("barrier")("halt", 0);
  Simulation S(quietChip(1, 2), A);
  S.run(50);
  EXPECT_EQ(lostAt(S, 2, Loss::Barrier), 47u);
}

} // namespace
