//===- PendingResultTest.cpp - Results whose time memory tells ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Windows of 16 cycles; an answer comes as many cycles after the request as the
// address says.
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/ScriptedMemory.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint32_t DataHigh = DataBegin >> 16;
constexpr int64_t After20 = 2 * 256;
constexpr int64_t After30 = 3 * 256;
constexpr int64_t After50 = 5 * 256;
constexpr int64_t After200 = 20 * 256;

Simulation simulate(const ChipConfig &Chip, const Assembly &A) {
  return Simulation(Chip, A, 1, ScriptedMemory::make(Chip));
}

TEST(PendingResult, IsWaitedForAndChargedToItsLevel) {
  // lui 0, lw 1; the addi waits from 2 until 1 + latency, then halt.
  for (auto [Offset, Latency, Level] : {std::tuple(After20, 20u, Loss::L2),
                                        {After50, 50u, Loss::Memory},
                                        {After200, 200u, Loss::Dram}}) {
    Assembly A;
    A("lui", 20, DataHigh)("lw", 5, 20, Offset)("addi", 6, 5, 1)("halt", 0);
    Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
    S.setWord(DataBegin + uint32_t(Offset), 41);
    EXPECT_EQ(S.cycles(), 1 + Latency + 2);
    EXPECT_EQ(S.lost(0, Level), Latency - 1);
    EXPECT_EQ(S.registerOf(0, 6), 42u);
  }
}

TEST(PendingResult, NobodyWaitsForWhatIsSuperseded) {
  // The lui in 2 takes the register over; the answer in 201 must not.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After200)("lui", 5, 1)("addi", 6, 5,
                                                             1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 5u);
  EXPECT_EQ(S.registerOf(0, 6), 0x10001u);
}

TEST(PendingResult, OfTwoLoadsToARegisterTheLaterCounts) {
  // The first answer comes in 201, the second in 2 + 20: addi in 22, halt 23.
  // The other way round the first comes in 21, the second in 202.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After200)("lw", 5, 20, After20)(
      "addi", 6, 5, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 24u);
  Assembly B;
  B("lui", 20, DataHigh)("lw", 5, 20, After20)("lw", 5, 20, After200)(
      "addi", 6, 5, 1)("halt", 0);
  Simulation T = simulate(ScriptedMemory::chip(1, 1), B);
  EXPECT_EQ(T.cycles(), 204u);
}

TEST(PendingResult, TheLatestSourceIsCharged) {
  // lw 1 and 2, answered in 201 and 22: the add waits from 3 to 201.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After200)("lw", 6, 20, After20)(
      "add", 7, 5, 6)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 203u);
  EXPECT_EQ(S.lost(0, Loss::Dram), 198u);
  EXPECT_EQ(S.lost(0, Loss::L2), 0u);
}

TEST(PendingResult, OfLevelsInOneCycleTheFarthestIsCharged) {
  // lw in 1 from DRAM and in 151 from fixed-latency memory: both ready in 201.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After200).repeat(149, "addi", 7, 0, 0);
  A("lw", 6, 20, After50)("add", 7, 6, 5)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 203u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 49u);
}

TEST(PendingResult, CutsAndPausesChargeWhatIsUnderWayToMemory) {
  // The addi waits from 2 on for an answer in 201.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After200)("addi", 6, 5, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  RunLimits Limits;
  Limits.PauseCycle = 16;
  EXPECT_EQ(S.run(Limits).End, RunResult::Paused);
  // At the end of the window the answer has come.
  EXPECT_EQ(S.lost(0, Loss::Memory) + S.lost(0, Loss::Dram), 14u);
  EXPECT_EQ(S.cycles(), 203u);
  EXPECT_EQ(S.lost(0, Loss::Dram), 199u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 0u);
}

TEST(PendingResult, AtomicsGiveTheOldValueWhenTheyAreAnswered) {
  // lui 0, addi 1, atom_add 2, answered in 202.
  Assembly A;
  A("lui", 20, DataHigh)("addi", 20, 20, After200)("atom_add", 5, 20, 20)(
      "addi", 6, 5, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  S.setWord(DataBegin + uint32_t(After200), 41);
  EXPECT_EQ(S.cycles(), 204u);
  EXPECT_EQ(S.lost(0, Loss::Dram), 199u);
  EXPECT_EQ(S.registerOf(0, 6), 42u);
}

TEST(PendingResult, OfTwoAtomicsToARegisterTheLaterStays) {
  Assembly A;
  A("lui", 20, DataHigh)("addi", 20, 20, After20)("addi", 4, 0, 7)(
      "atom_add", 5, 4, 20)("atom_add", 5, 4, 20)("addi", 6, 5, 0)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  S.setWord(DataBegin + uint32_t(After20), 100);
  S.cycles();
  EXPECT_EQ(S.registerOf(0, 6), 107u);
}

TEST(PendingResult, AFullStoreBufferStallsTheNextStore) {
  // Two entries. sw 1 and 2 are answered in 201 and 22; the third store takes
  // the first entry, the older one, in 201; the fourth in 202 the second.
  // halt 203.
  Assembly A;
  A("lui", 20, DataHigh)("sw", 0, 20, After200)("sw", 0, 20, After20)(
      "sw", 0, 20, After20)("sw", 0, 20, After20)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 204u);
  EXPECT_EQ(S.lost(0, Loss::StoreBuffer), 198u);
  EXPECT_EQ(S.statistics().DataStall[unsigned(Opcode::SW)], 198u);
}

TEST(PendingResult, LocalStoresNeedNoStoreBuffer) {
  Assembly A;
  A("lui", 20, DataHigh)("sw", 0, 20, After200)("sw", 0, 20, After200)(
      "addi", 21, 0, -64)("sw", 0, 21, 0)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 6u);
}

TEST(PendingResult, SyncWaitsForTheAnswersToItsStores) {
  // sw 1 is answered in 31, after the window's end in 16; sync 2, halt 31.
  Assembly A;
  A("lui", 20, DataHigh)("sw", 0, 20, After30)("sync")("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 32u);
  EXPECT_EQ(S.lost(0, Loss::Sync), 28u);
}

TEST(PendingResult, SyncWaitsForAnswersThatAreKnownButStillToCome) {
  // sw 1 is answered in 201, which is known in 16; sync in 17, halt 201.
  Assembly A;
  A("lui", 20, DataHigh)("sw", 0, 20, After200).repeat(15, "addi", 5, 0, 0);
  A("sync")("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 202u);
  EXPECT_EQ(S.lost(0, Loss::Sync), 183u);
}

TEST(PendingResult, SyncAfterAnsweredStoresTakesTheWindow) {
  // sw 1 is answered in 21; sync in 32 lasts to the end of its window, 48.
  Assembly A;
  A("lui", 20, DataHigh)("sw", 0, 20, After20).repeat(30, "addi", 5, 0, 0);
  A("sync")("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 1), A);
  EXPECT_EQ(S.cycles(), 49u);
}

TEST(PendingResult, OthersWorkOnWhileOneWaits) {
  // Thread 0 waits for 200 cycles; thread 1, of lower priority at first, goes
  // on and ends in cycle 2 + 102.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("bne", 4, 0, "other")(
      "lui", 20, DataHigh)("lw", 5, 20, After200)("addi", 6, 5, 1)("halt", 0);
  A.label("other").repeat(101, "addi", 6, 0, 1)("halt", 0);
  Simulation S = simulate(ScriptedMemory::chip(1, 2), A);
  EXPECT_EQ(S.cycles(), 3 + 200 + 2u);
  EXPECT_EQ(S.statistics().Threads[1].FinishCycle, 104u);
}

} // namespace
