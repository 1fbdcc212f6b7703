//===- ArbitrationTest.cpp - TPs that compete, cycles derived by hand -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static ChipConfig chipWith(uint32_t TpsPerTm, Unit Type, uint32_t Count,
                           uint32_t Interval = 1) {
  ChipConfig Chip = quietChip(1, TpsPerTm);
  Chip.Units[unsigned(Type)].Count = Count;
  Chip.Units[unsigned(Type)].Interval = Interval;
  return Chip;
}

namespace {

class UnitConflicts : public testing::TestWithParam<uint32_t> {};

TEST_P(UnitConflicts, OneUnitServesOneTpPerCycleInOrderOfPriority) {
  // One multiplier, all TPs want it in cycle 0: TP k gets it in cycle k, after
  // k lost cycles, and halts in cycle k + 1. n TPs: n + 1 cycles.
  uint32_t Tps = GetParam();
  Assembly A;
  A("mul_s", 4, 1, 2)("halt", 0);
  Simulation S(chipWith(Tps, Unit::FPMUL, 1), A);
  EXPECT_EQ(S.cycles(), Tps + 1);
  for (uint32_t Tp = 0; Tp != Tps; ++Tp) {
    EXPECT_EQ(S.lost(Tp, Loss::UnitConflict), Tp);
    EXPECT_EQ(S.statistics().Threads[Tp].FinishCycle, Tp + 2);
    EXPECT_EQ(S.lost(Tp, Loss::Finished), Tps + 1 - (Tp + 2));
  }
  EXPECT_EQ(S.statistics().UnitConflict[unsigned(Opcode::MUL_S)],
            Tps * (Tps - 1) / 2);
}

TEST_P(UnitConflicts, TwoUnitsServeTwoTpsPerCycle) {
  // TP k gets a unit in cycle k / 2.
  uint32_t Tps = GetParam();
  Assembly A;
  A("mul_s", 4, 1, 2)("halt", 0);
  Simulation S(chipWith(Tps, Unit::FPMUL, 2), A);
  EXPECT_EQ(S.cycles(), (Tps - 1) / 2 + 2);
  for (uint32_t Tp = 0; Tp != Tps; ++Tp)
    EXPECT_EQ(S.lost(Tp, Loss::UnitConflict), Tp / 2);
}

INSTANTIATE_TEST_SUITE_P(Tps, UnitConflicts, testing::Values(1, 4, 8));

TEST(Arbitration, PriorityIsFixedWithinAWindow) {
  // Four multiplications each, one unit, three TPs: TP 0 has it in cycles
  // 0..3, TP 1 in 4..7, TP 2 in 8..11 and halts in 12.
  Assembly A;
  A.repeat(4, "mul_s", 4, 1, 2)("halt", 0);
  Simulation S(chipWith(3, Unit::FPMUL, 1), A);
  EXPECT_EQ(S.cycles(), 13u);
  EXPECT_EQ(S.lost(0, Loss::UnitConflict), 0u);
  EXPECT_EQ(S.lost(1, Loss::UnitConflict), 4u);
  EXPECT_EQ(S.lost(2, Loss::UnitConflict), 8u);
}

TEST(Arbitration, PriorityRotatesByOneFromWindowToWindow) {
  // The multiplication is due in cycle 16 w, the first of window w, where TP
  // w mod 4 comes first. TP t waits (t - w) mod 4 cycles.
  for (uint32_t Window : {0u, 1u, 2u, 3u, 4u, 5u, 7u}) {
    Assembly A;
    A.repeat(16 * Window, "addi", 5, 0, 1)("mul_s", 4, 1, 2)("halt", 0);
    Simulation S(chipWith(4, Unit::FPMUL, 1), A);
    EXPECT_EQ(S.cycles(), 16 * Window + 5);
    for (uint32_t Tp = 0; Tp != 4; ++Tp)
      EXPECT_EQ(S.lost(Tp, Loss::UnitConflict), (Tp + 28 - Window) % 4)
          << "window " << Window << " TP " << Tp;
  }
}

TEST(Arbitration, RotationReachesAcrossAWaitingTp) {
  // Two TPs, one multiplier, 16 multiplications each. Window 0 (TP 0 first):
  // TP 0 issues all its 16 in 0..15. Window 1 (TP 1 first): TP 0 halts in 16,
  // TP 1 multiplies in 16..31 and halts in 32.
  Assembly A;
  A.repeat(16, "mul_s", 4, 1, 2)("halt", 0);
  Simulation S(chipWith(2, Unit::FPMUL, 1), A);
  EXPECT_EQ(S.cycles(), 33u);
  EXPECT_EQ(S.statistics().Threads[0].FinishCycle, 17u);
  EXPECT_EQ(S.lost(1, Loss::UnitConflict), 16u);
}

TEST(Arbitration, TmsDoNotShareUnits) {
  Assembly A;
  A("mul_s", 4, 1, 2)("halt", 0);
  ChipConfig Chip = chipWith(1, Unit::FPMUL, 1);
  Chip.TmCount = 5;
  Simulation S(Chip, A);
  EXPECT_EQ(S.cycles(), 2u);
}

TEST(Arbitration, IcacheBankServesItsPorts) {
  // Two banks with one port, three instructions and halt in banks 0 1 0 1.
  //   TP 0: cycles 0 1 2 3
  //   TP 1: bank 0 is TP 0's in cycle 0; then 1 2 3 4, always the other bank
  //   TP 2: bank 0 is taken in 0 (TP 0), 1 (TP 1), 2 (TP 0), 3 (TP 1); 4 5 6 7
  //   TP 3: in 4 too (TP 2); 5 6 7 8
  Assembly A;
  A.repeat(3, "addi", 4, 0, 1)("halt", 0);
  ChipConfig Chip = quietChip(1, 4);
  Chip.IcacheBanks = 2;
  Chip.IcachePorts = 1;
  Simulation S(Chip, A);
  EXPECT_EQ(S.cycles(), 9u);
  const uint64_t Expected[] = {0, 1, 4, 5};
  for (uint32_t Tp = 0; Tp != 4; ++Tp)
    EXPECT_EQ(S.lost(Tp, Loss::IcacheConflict), Expected[Tp]);
}

TEST(Arbitration, IcacheConflictComesBeforeUnitConflict) {
  // One port and one multiplier: TP 1 lacks both in cycle 0.
  Assembly A;
  A("mul_s", 4, 1, 2)("halt", 0);
  ChipConfig Chip = chipWith(2, Unit::FPMUL, 1);
  Chip.IcachePorts = 1;
  Simulation S(Chip, A);
  // TP 0: mul 0, halt 1. TP 1: icache in 0 and 1, mul 2, halt 3.
  EXPECT_EQ(S.cycles(), 4u);
  EXPECT_EQ(S.lost(1, Loss::IcacheConflict), 2u);
  EXPECT_EQ(S.lost(1, Loss::UnitConflict), 0u);
}

TEST(Arbitration, WaitingForDataComesBeforeConflicts) {
  // One divider. TP 0 starts in 0, TP 1 in 1 (after one conflict). Both wait
  // for their result until 16 and 17; then they do not meet.
  Assembly A;
  A("rcp_s", 4, 1)("rcp_s", 5, 4)("halt", 0);
  Simulation S(chipWith(2, Unit::FPINV, 1), A);
  EXPECT_EQ(S.cycles(), 19u);
  EXPECT_EQ(S.lost(0, Loss::Data), 15u);
  EXPECT_EQ(S.lost(1, Loss::Data), 15u);
  EXPECT_EQ(S.lost(1, Loss::UnitConflict), 1u);
}

TEST(Arbitration, RefusedInstructionTakesNothing) {
  // Four banks of two ports, one multiplier, three TPs.
  //   cycle 0: TP 0, 1 at word 0; TP 2 finds no port (1 lost)
  //   cycle 3: TP 0, 1 at word 3, TP 2 at word 2 branches to word 8
  //   cycle 4: TP 0 multiplies (word 4, bank 0); TP 1 finds no multiplier and
  //            must leave the port of bank 0 to TP 2 (word 8)
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::tp))("addi", 5, 0, 2)("beq", 4, 5, "third")(
      "addi", 6, 0, 1)("mul_s", 4, 1, 2)("halt", 0);
  A.repeat(2, "addi", 0, 0, 0).label("third")("halt", 0);
  ChipConfig Chip = chipWith(3, Unit::FPMUL, 1);
  Chip.IcacheBanks = 4;
  Chip.IcachePorts = 2;
  Simulation S(Chip, A);
  // TP 1 multiplies in 5 and halts in 6.
  EXPECT_EQ(S.cycles(), 7u);
  EXPECT_EQ(S.lost(1, Loss::UnitConflict), 1u);
  EXPECT_EQ(S.lost(2, Loss::IcacheConflict), 1u);
  EXPECT_EQ(S.statistics().Threads[2].FinishCycle, 5u);
}

TEST(Arbitration, IntervalUnitStartsInMultiplesOfItsInterval) {
  // Interval 4: three independent reciprocals start in 0, 4, 8; halt 9.
  Assembly A;
  A("rcp_s", 4, 1)("rcp_s", 5, 1)("rcp_s", 6, 1)("halt", 0);
  Simulation S(chipWith(1, Unit::FPINV, 1, 4), A);
  EXPECT_EQ(S.cycles(), 10u);
  EXPECT_EQ(S.lost(0, Loss::UnitConflict), 6u);
}

TEST(Arbitration, IntervalNeedNotDivideTheWindow) {
  // Interval 3, windows of 16: due in cycle 16, starts in 18; then 21; halt 22.
  Assembly A;
  A.repeat(16, "addi", 4, 0, 1)("rcp_s", 4, 1)("rcp_s", 5, 1)("halt", 0);
  Simulation S(chipWith(1, Unit::FPINV, 1, 3), A);
  EXPECT_EQ(S.cycles(), 23u);
  EXPECT_EQ(S.lost(0, Loss::UnitConflict), 4u);
}

TEST(Arbitration, IntervalUnitsStartCountOperationsTogether) {
  // Two units of interval 8, three TPs: TP 0 and 1 in cycle 0, TP 2 in 8.
  Assembly A;
  A("rcp_s", 4, 1)("halt", 0);
  Simulation S(chipWith(3, Unit::FPINV, 2, 8), A);
  EXPECT_EQ(S.cycles(), 10u);
  EXPECT_EQ(S.lost(1, Loss::UnitConflict), 0u);
  EXPECT_EQ(S.lost(2, Loss::UnitConflict), 8u);
}

TEST(Arbitration, ChipsWithManyLimitsFollowTheSameRules) {
  // All limits bind on these chips; their words need 64, 128 and more bits.
  // One port per bank and one multiplier: with one bank, TP k multiplies in
  // cycle 2k and halts in 2k + 1 (TP 0's halt takes the port in cycle 1).
  for (uint32_t Banks : {1u, 20u, 60u}) {
    ChipConfig Chip = quietChip(1, 32);
    for (UnitConfig &Type : Chip.Units)
      Type.Count = 16;
    Chip.IcacheBanks = Banks;
    Chip.IcachePorts = 1;
    Assembly A;
    A("mul_s", 4, 1, 2)("halt", 0);
    Simulation S(Chip, A);
    uint64_t Cycles = S.cycles();
    if (Banks == 1) {
      EXPECT_EQ(Cycles, 64u);
    } else {
      // Two banks are in use: TP k fetches in k and k + 1.
      EXPECT_EQ(Cycles, 33u);
    }
  }
}

TEST(Arbitration, LongRunsKeepTheirTiming) {
  // More than 2^24 cycles: 2^19 rounds of a chain of 16 + 16 + 1 + 1 cycles:
  // rcp_s, rcp_s (16 later), addi (waits for nothing), bne. The next rcp_s
  // waits for the last: each round takes 32 cycles.
  Assembly A;
  A("lui", 4, 8)
      .label("loop")("rcp_s", 5, 5)("rcp_s", 5, 5)("addi", 4, 4, -1)(
          "bne", 4, 0, "loop")("halt", 0);
  Simulation S(quietChip(1, 1), A);
  uint64_t Rounds = 8 << 16;
  // lui 0; round r starts in 1 + 32 r; its bne is in 1 + 32 r + 18.
  EXPECT_EQ(S.run(0).End, RunResult::Halted);
  EXPECT_EQ(S.statistics().Cycles, 1 + 32 * (Rounds - 1) + 18 + 2);
}

} // namespace
