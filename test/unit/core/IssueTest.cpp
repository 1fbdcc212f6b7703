//===- IssueTest.cpp - Cycle counts of one thread, derived by hand --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static Assembly halted(Assembly A) { return A("halt", 0); }

namespace {

TEST(Issue, IndependentInstructionsIssueEveryCycle) {
  // Cycles 0..9: addi; cycle 10: halt. The run ends after cycle 10.
  Assembly A;
  A.repeat(10, "addi", 4, 0, 1);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 11u);
  EXPECT_EQ(S.statistics().Threads[0].Instructions, 11u);
  EXPECT_EQ(S.statistics().Threads[0].FinishCycle, 11u);
}

TEST(Issue, DependentChainOfLatencyOneDoesNotStall) {
  // The result of cycle c is ready in cycle c + 1: full forwarding.
  Assembly A;
  A.repeat(10, "addi", 4, 4, 1);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 11u);
  EXPECT_EQ(S.registerOf(0, 4), 10u);
}

/// A chain of five instructions that each wait for the one before, then halt.
struct Chain {
  const char *Mnemonic;
  uint64_t Latency;
};

class DependentChain : public testing::TestWithParam<Chain> {};

TEST_P(DependentChain, WaitsForEachResult) {
  // Issues at 0, L, 2L, 3L, 4L; halt needs no result: cycle 4L + 1. The run
  // takes 4L + 2 cycles, of which 4 (L - 1) wait for data.
  auto [Mnemonic, Latency] = GetParam();
  Opcode Op = *findOpcode(Mnemonic);
  Assembly A;
  if (operandsOf(Op).size() == 3)
    A.repeat(5, Mnemonic, 4, 4, 4);
  else
    A.repeat(5, Mnemonic, 4, 4);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 4 * Latency + 2);
  EXPECT_EQ(S.lost(0, Loss::Data), 4 * (Latency - 1));
  EXPECT_EQ(S.statistics().DataStall[unsigned(Op)], 4 * (Latency - 1));
}

INSTANTIATE_TEST_SUITE_P(LatencyClasses, DependentChain,
                         testing::Values(Chain{"add", 1}, Chain{"mul", 1},
                                         Chain{"xor", 1}, Chain{"add_s", 2},
                                         Chain{"mul_s", 2}, Chain{"min_s", 1},
                                         Chain{"rcp_s", 16}, Chain{"sin_s", 16},
                                         Chain{"floor_s", 1}),
                         [](const auto &Info) {
                           return std::string(Info.param.Mnemonic);
                         });

TEST(Issue, IntegerDivisionTakesItsLatency) {
  // addi 0, div 1, div waits for r5: 17, halt 18: 19 cycles, 15 lost.
  Assembly A;
  A("addi", 4, 0, 1)("div", 5, 4, 4)("div", 6, 5, 4);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 19u);
  EXPECT_EQ(S.lost(0, Loss::Data), 15u);
}

TEST(Issue, CompareTakesItsLatency) {
  // c_eq_s at 0 (latency 1), addi on its result at 1, halt 2.
  Assembly A;
  A("c_eq_s", 4, 0, 0)("addi", 5, 4, 1);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 3u);
  EXPECT_EQ(S.registerOf(0, 5), 2u);
}

TEST(Issue, WorkBetweenHidesLatency) {
  // rcp_s at 0, ready at 16; fifteen addi in 1..15; add_s at 16; halt 17.
  Assembly A;
  A("rcp_s", 4, 1).repeat(15, "addi", 5, 0, 1)("add_s", 5, 4, 4);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 18u);
  EXPECT_EQ(S.lost(0, Loss::Data), 0u);
}

TEST(Issue, LaterWriteSupersedesOneInFlight) {
  // rcp_s f4 at 0 is ready at 16, but mtc1 writes f4 at 1; mfc1 at 2 reads the
  // new value without waiting; halt at 3.
  Assembly A;
  A("rcp_s", 4, 1)("mtc1", 4, 0)("mfc1", 5, 4);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 4u);
  EXPECT_EQ(S.registerOf(0, 5), 0u);
}

TEST(Issue, LaterWriteSupersedesAnAtomicInFlight) {
  // As above with an atomic, whose old value arrives at the window's end:
  // lui 0, atom_add 1, addi 2, addi 3 (r4 is ready), halt 4.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("atom_add", 4, 20, 20)("addi", 4, 0,
                                                       7)("addi", 5, 4, 1);
  Simulation S(quietChip(1, 1), halted(A));
  S.setWord(DataBegin, 99);
  EXPECT_EQ(S.cycles(), 5u);
  EXPECT_EQ(S.registerOf(0, 4), 7u);
  EXPECT_EQ(S.registerOf(0, 5), 8u);
  EXPECT_EQ(S.word(DataBegin), 99 + DataBegin);
}

TEST(Issue, RegisterZeroIsNeverWrittenNorWaitedFor) {
  // A load into r0 from global memory: its user does not wait.
  // lui 0, lw 1, addi 2, halt 3.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("lw", 0, 20, 0)("addi", 5, 0, 1);
  Simulation S(quietChip(1, 1), halted(A));
  S.setWord(DataBegin, 99);
  EXPECT_EQ(S.cycles(), 4u);
  EXPECT_EQ(S.registerOf(0, 0), 0u);
  EXPECT_EQ(S.registerOf(0, 5), 1u);
}

TEST(Issue, GlobalLoadTakesTheMemoryLatency) {
  // lui 0, lw 1, addi waits for 1 + 20 = 21, halt 22: 23 cycles, 19 of them
  // lost to memory.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("lw", 4, 20, 0)("addi", 5, 4, 1);
  Simulation S(quietChip(1, 1), halted(A));
  S.setWord(DataBegin, 99);
  EXPECT_EQ(S.cycles(), 23u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 19u);
  EXPECT_EQ(S.lost(0, Loss::Data), 0u);
  EXPECT_EQ(S.statistics().DataStall[unsigned(Opcode::LW)], 19u);
  EXPECT_EQ(S.registerOf(0, 5), 100u);
}

TEST(Issue, LocalLoadAndAtomicTakeOneCycle) {
  // addi 0 (r20 = start of the local store), sw 1, lw 2, addi 3,
  // atom_add 4, addi 5, halt 6.
  Assembly A;
  A("addi", 20, 0, -int(LocalStoreBytes))("sw", 20, 20, 8)("lw", 4, 20, 8)(
      "addi", 5, 4, 1)("atom_add", 6, 5, 20)("addi", 7, 6, 3);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 7u);
  EXPECT_EQ(S.registerOf(0, 5), LocalBegin + 1);
  EXPECT_EQ(S.registerOf(0, 7), 3u);
}

TEST(Issue, TakenBranchCostsItsLatency) {
  // Branch latency 3. addi 0; then twice: addi, bne. First bne at 2 is taken:
  // next issue at 5 (2 lost); addi 5, bne 6 falls through, halt 7.
  ChipConfig Chip = quietChip(1, 1);
  Chip.Latency[unsigned(LatencyClass::Branch)] = 3;
  Assembly A;
  A("addi", 4, 0, 2).label("loop")("addi", 4, 4, -1)("bne", 4, 0, "loop");
  Simulation S(Chip, halted(A));
  EXPECT_EQ(S.cycles(), 8u);
  EXPECT_EQ(S.lost(0, Loss::Branch), 2u);
}

TEST(Issue, TakenBranchOfLatencyOneCostsNothing) {
  // addi 0; addi 1, bne 2, addi 3, bne 4; halt 5.
  Assembly A;
  A("addi", 4, 0, 2).label("loop")("addi", 4, 4, -1)("bne", 4, 0, "loop");
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 6u);
}

TEST(Issue, SleepLosesItsCycles) {
  // addi 0, sleep 1 for 5 cycles: 2..6, halt 7. Once more beyond the window.
  for (unsigned Cycles : {0u, 5u, 100u, 100000u}) {
    Assembly A;
    A.constant(4, Cycles)("sleep", 4);
    Simulation S(quietChip(1, 1), halted(A));
    EXPECT_EQ(S.cycles(), 2 + 1 + Cycles + 1);
    EXPECT_EQ(S.lost(0, Loss::Sleep), Cycles);
  }
}

TEST(Issue, SleepCanTakeLongerThanReadyWordsReach) {
  // rcp_s 0, lui 1, sleep 2 for 0x10000000 cycles, then add_s finds f4 ready.
  Assembly A;
  A("rcp_s", 4, 1)("lui", 4, 0x1000)("sleep", 4)("add_s", 5, 4, 4);
  Simulation S(quietChip(1, 1), halted(A));
  RunResult Result = S.run(0);
  EXPECT_EQ(Result.End, RunResult::Halted);
  EXPECT_EQ(S.statistics().Cycles, 3 + 0x10000000u + 2);
}

TEST(Issue, SyncWaitsForTheEndOfTheWindow) {
  // addi 0, addi 1, sync 2: continues at 16 (13 lost), halt 16.
  Assembly A;
  A.repeat(2, "addi", 4, 0, 1)("sync");
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 17u);
  EXPECT_EQ(S.lost(0, Loss::Sync), 13u);
}

TEST(Issue, SyncInTheLastCycleOfAWindowCostsNothing) {
  // addi 0..14, sync 15, halt 16.
  Assembly A;
  A.repeat(15, "addi", 4, 0, 1)("sync");
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 17u);
  EXPECT_EQ(S.lost(0, Loss::Sync), 0u);
}

TEST(Issue, CountersCountCyclesAndInstructions) {
  // mfsr cycle at 0; rcp_s 1; mfc1 waits to 17; mfsr cycle 18, instret 19:
  // four instructions before it; halt 20.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::cycle))("rcp_s", 4, 1)("mfc1", 5, 4)(
      "mfsr", 6, int(SpecialRegister::cycle))("mfsr", 7,
                                              int(SpecialRegister::instret));
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.cycles(), 21u);
  EXPECT_EQ(S.registerOf(0, 4), 0u);
  EXPECT_EQ(S.registerOf(0, 6), 18u);
  EXPECT_EQ(S.registerOf(0, 7), 4u);
}

TEST(Issue, CycleLimitIsExactAndCutsLosses) {
  // lui 0, lw 1, addi would issue at 21. Cut at every cycle: the issues before
  // the limit and the losses up to it.
  for (uint64_t Limit = 1; Limit != 22; ++Limit) {
    Assembly A;
    A("lui", 20, DataBegin >> 16)("lw", 4, 20, 0)("addi", 5, 4, 1);
    Simulation S(quietChip(1, 1), halted(A));
    EXPECT_EQ(S.run(Limit).End, RunResult::CycleLimit);
    EXPECT_EQ(S.statistics().Cycles, Limit);
    uint64_t Issued = std::min<uint64_t>(Limit, 2);
    EXPECT_EQ(S.statistics().Threads[0].Instructions, Issued);
    EXPECT_EQ(S.lost(0, Loss::Memory), Limit - Issued);
  }
}

TEST(Issue, CycleLimitBeforeTheNextWindowWithWork) {
  // addi 0, sleep 1: the next issue would be in cycle 1002, windows later.
  Assembly A;
  A("addi", 4, 0, 1000)("sleep", 4);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.run(65).End, RunResult::CycleLimit);
  EXPECT_EQ(S.statistics().Cycles, 65u);
  EXPECT_EQ(S.lost(0, Loss::Sleep), 65u - 2);
}

TEST(Issue, CycleLimitDoesNotChangeACompletedRun) {
  Assembly A;
  A.repeat(10, "addi", 4, 0, 1);
  Simulation S(quietChip(1, 1), halted(A));
  EXPECT_EQ(S.run(11).End, RunResult::Halted);
  EXPECT_EQ(S.statistics().Cycles, 11u);
}

TEST(Issue, StopFlagEndsTheRun) {
  Assembly A;
  A.label("forever")("j", "forever");
  ChipConfig Chip = quietChip(1, 1);
  Memory Global(Chip.MemoryBytes);
  Program Text(TextBegin, A.words(), TextBegin);
  Engine E(Chip, Text, Global);
  std::atomic<bool> Stop = true;
  RunLimits Limits;
  Limits.Stop = &Stop;
  EXPECT_EQ(E.run(Limits).End, RunResult::Stopped);
}

} // namespace
