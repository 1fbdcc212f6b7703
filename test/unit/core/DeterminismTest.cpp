//===- DeterminismTest.cpp - Results do not depend on the host ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

#include <cstring>

using namespace tp;
using namespace tp::test;

/// A program in which all threads disturb each other: they take tickets from a
/// counter, sleep, store and branch by what they get, race on words, use one
/// stream, meet at barriers and print.
static Assembly contendedProgram() {
  Assembly A;
  A("lui", 20, DataBegin >> 16)("addi", 21, 20, 0x100)("addi", 8, 0,
                                                       40)("addi", 23, 0, -256);
  A.label("round");
  A("addi", 5, 0, 1)("atom_add", 4, 5, 20)("andi", 6, 4, 7)("sleep", 6);
  A("sll", 7, 6, 2)("add", 7, 7, 20)("lw", 9, 7, 64)("add", 9, 9, 4)(
      "sw", 9, 7, 64)("sb", 4, 7, 65)("addi", 17, 7, 192)("atom_swap", 10, 9,
                                                          17);
  A("andi", 11, 10, 3)("beq", 11, 0, "divide")("stream_push", 12, 4, 21)(
      "cvt_s_w", 1, 9)("mul_s", 2, 1, 1)("add_s", 3, 2, 1)("j", "next");
  A.label("divide")("stream_pop", 12, 21)("cvt_s_w", 1,
                                          10)("rcp_s", 2, 1)("div_s", 3, 2, 1);
  A.label("next")("swc1", 3, 7, 128)("xor", 13, 12, 9)("sw", 13, 23, 0)(
      "andi", 14, 4, 31)("bne", 14, 0, "quiet");
  A("addi", 15, 4, 0)("andi", 16, 15, 63)("addi", 16, 16, 48)("sb", 16, 23, 4)(
      "addi", 4, 0, 1)("addi", 5, 23, 4)("addi", 6, 0, 1)("hostcall", 0);
  A.label("quiet")("prof", 5)("addi", 8, 8, -1)("andi", 14, 8, 7)(
      "bne", 14, 0, "on")("barrier");
  A.label("on")("bne", 8, 0, "round")("halt", 0);
  return A;
}

static ChipConfig contendedChip(uint32_t Tms, uint32_t Tps) {
  ChipConfig Chip = quietChip(Tms, Tps);
  for (UnitConfig &Type : Chip.Units)
    Type.Count = std::max(1u, Tps / 2);
  Chip.Units[unsigned(Unit::FPINV)] = {1, 4};
  Chip.IcacheBanks = 4;
  Chip.IcachePorts = 1;
  return Chip;
}

static bool operator==(const ThreadStatistics &A, const ThreadStatistics &B) {
  return A.Instructions == B.Instructions && A.FinishCycle == B.FinishCycle &&
         A.Lost == B.Lost;
}

static void expectSame(const Statistics &A, const Statistics &B) {
  EXPECT_EQ(A.Cycles, B.Cycles);
  EXPECT_EQ(A.Executed, B.Executed);
  EXPECT_EQ(A.DataStall, B.DataStall);
  EXPECT_EQ(A.UnitConflict, B.UnitConflict);
  EXPECT_EQ(A.Markers, B.Markers);
  ASSERT_EQ(A.Threads.size(), B.Threads.size());
  for (size_t I = 0; I != A.Threads.size(); ++I)
    EXPECT_TRUE(A.Threads[I] == B.Threads[I]) << "thread " << I;
}

namespace {

class Determinism
    : public testing::TestWithParam<std::pair<uint32_t, uint32_t>> {};

TEST_P(Determinism, AnyNumberOfHostThreadsGivesTheSame) {
  ChipConfig Chip = contendedChip(GetParam().first, GetParam().second);
  Assembly Program = contendedProgram();
  Simulation Reference(Chip, Program);
  Reference.setWord(DataBegin + 0x108, 64);
  Reference.cycles();
  EXPECT_EQ(Reference.word(DataBegin), Chip.threadCount() * 40);
  EXPECT_FALSE(Reference.output().empty());
  for (unsigned HostThreads : {1u, 2u, 3u, 7u}) {
    Simulation S(Chip, Program, HostThreads);
    S.setWord(DataBegin + 0x108, 64);
    S.cycles();
    expectSame(S.statistics(), Reference.statistics());
    EXPECT_EQ(S.output(), Reference.output());
    EXPECT_EQ(std::memcmp(S.memory().data() + DataBegin,
                          Reference.memory().data() + DataBegin, 0x10000),
              0);
    for (uint32_t Thread = 0; Thread != Chip.threadCount(); ++Thread)
      for (unsigned Register = 0; Register != 64; ++Register)
        EXPECT_EQ(S.registerOf(Thread, Register),
                  Reference.registerOf(Thread, Register));
  }
}

TEST_P(Determinism, AlsoWhenCutAtACycle) {
  ChipConfig Chip = contendedChip(GetParam().first, GetParam().second);
  Assembly Program = contendedProgram();
  for (uint64_t Limit : {1u, 77u, 400u, 401u}) {
    Simulation Reference(Chip, Program), S(Chip, Program, 3);
    for (Simulation *Each : {&Reference, &S}) {
      Each->setWord(DataBegin + 0x108, 64);
      EXPECT_EQ(Each->run(Limit).End, RunResult::CycleLimit);
    }
    expectSame(S.statistics(), Reference.statistics());
  }
}

TEST_P(Determinism, PausesAndOtherHostThreadsInBetweenChangeNothing) {
  ChipConfig Chip = contendedChip(GetParam().first, GetParam().second);
  Assembly Program = contendedProgram();
  Simulation Reference(Chip, Program), S(Chip, Program);
  for (Simulation *Each : {&Reference, &S})
    Each->setWord(DataBegin + 0x108, 64);
  Reference.cycles();
  RunLimits Limits;
  do {
    Limits.PauseCycle += 200;
    S.setHostThreads(1 + Limits.PauseCycle / 200 % 3);
  } while (S.run(Limits).End == RunResult::Paused);
  expectSame(S.statistics(), Reference.statistics());
  EXPECT_EQ(S.output(), Reference.output());
}

INSTANTIATE_TEST_SUITE_P(Chips, Determinism,
                         testing::Values(std::pair(1, 4), std::pair(4, 4),
                                         std::pair(7, 3), std::pair(16, 8)));

} // namespace
