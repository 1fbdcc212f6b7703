//===- FunctionalTest.cpp - Execution without timing ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/functional/FunctionalSimulation.h"

#include "gtest/gtest.h"

#include <limits>

using namespace tp;
using namespace tp::test;

static constexpr int ThreadNumber = int(SpecialRegister::thread);
static constexpr int Cycle = int(SpecialRegister::cycle);
static constexpr int Instret = int(SpecialRegister::instret);

static uint64_t executed(const Statistics &Counts, std::string_view Mnemonic) {
  return Counts.Executed[unsigned(*findOpcode(Mnemonic))];
}

namespace {

TEST(Functional, CountsByOpcodeAddressAndThread) {
  // r4 counts 5, 4, 3, 2, 1: five passes of the loop, four of them branch.
  // Markers are counted as markers only.
  Assembly A;
  A("addi", 4, 0, 5)
      .label("loop")("prof", 3)("addi", 4, 4, -1)("prof", 1)("bne", 4, 0,
                                                             "loop")("halt", 0);
  FunctionalSimulation S(quietChip(1, 2), A);
  EXPECT_EQ(S.Machine.run().End, RunResult::Halted);
  Statistics Counts = S.Machine.statistics();
  EXPECT_EQ(executed(Counts, "addi"), 2 * 6u);
  EXPECT_EQ(executed(Counts, "bne"), 2 * 5u);
  EXPECT_EQ(executed(Counts, "halt"), 2u);
  EXPECT_EQ(Counts.instructions(), 2 * 12u);
  std::vector<uint64_t> AtWord;
  for (const PcStatistics &Word : Counts.Pcs)
    AtWord.push_back(Word.Executed);
  EXPECT_EQ(AtWord, (std::vector<uint64_t>{2, 0, 10, 0, 10, 2}));
  EXPECT_EQ(Counts.Markers, (std::vector<uint64_t>{0, 10, 0, 10}));
  for (const ThreadStatistics &Thread : Counts.Threads)
    EXPECT_EQ(Thread.Instructions, 12u);
  EXPECT_EQ(Counts.Cycles, 0u);
}

TEST(Functional, CountersOfAThread) {
  // Before each mfsr so many instructions; a sleep counts only as cycles.
  Assembly A;
  A("addi", 4, 0, 100)("prof", 7)("sleep", 4)("mfsr", 5, Instret)(
      "mfsr", 6, Cycle)("j", "next")
      .label("next")("mfsr", 7, Instret)("mfsr", 8, Cycle)("halt", 0);
  FunctionalSimulation S(quietChip(1, 1), A);
  S.Machine.run();
  EXPECT_EQ(S.Machine.registerOf(0, 5), 2u);
  EXPECT_EQ(S.Machine.registerOf(0, 6), 3 + 100u);
  EXPECT_EQ(S.Machine.registerOf(0, 7), 5u);
  EXPECT_EQ(S.Machine.registerOf(0, 8), 6 + 100u);
}

TEST(Functional, AtomicsAndStatusInTheOrderOfTurns) {
  // Thread t gets ticket t, stores it in its own word and halts with it.
  Assembly A;
  A.constant(4, DataBegin)("addi", 5, 0, 1)("atom_add", 6, 5, 4)(
      "mfsr", 7, ThreadNumber)("sll", 8, 7, 2)("add", 8, 8, 4)("sw", 6, 8,
                                                               4)("halt", 6);
  FunctionalSimulation S(quietChip(2, 4), A);
  RunResult Result = S.Machine.run();
  EXPECT_EQ(Result.ExitStatus, 1);
  EXPECT_EQ(S.word(DataBegin), 8u);
  for (uint32_t Thread = 0; Thread != 8; ++Thread)
    EXPECT_EQ(S.word(DataBegin + 4 + 4 * Thread), Thread);
}

TEST(Functional, ThreadThatSpinsLetsOthersRun) {
  // Thread 0 spins until thread 1 has stored, without any hint to the machine.
  Assembly A;
  A.constant(4, DataBegin)("mfsr", 5, ThreadNumber)("bne", 5, 0, "other")
      .label("spin")("lw", 6, 4, 0)("beq", 6, 0, "spin")("halt", 6)
      .label("other")("addi", 6, 0, 9)("sw", 6, 4, 0)("halt", 0);
  FunctionalSimulation S(quietChip(1, 2), A);
  EXPECT_EQ(S.Machine.run().ExitStatus, 9);
}

TEST(Functional, BarrierWaitsForAllThatHaveNotHalted) {
  // Thread 0 halts; the others count before the barrier and read behind it.
  Assembly A;
  A.constant(4, DataBegin)("mfsr", 5, ThreadNumber)("beq", 5, 0, "end")(
       "addi", 6, 0, 1)("atom_add", 7, 6, 4)("barrier")("lw", 7, 4, 0)
      .label("end")("halt", 0);
  FunctionalSimulation S(quietChip(1, 4), A);
  EXPECT_EQ(S.Machine.run().End, RunResult::Halted);
  for (uint32_t Thread = 1; Thread != 4; ++Thread)
    EXPECT_EQ(S.Machine.registerOf(Thread, 7), 3u);
}

TEST(Functional, TrapStopsBeforeTheInstruction) {
  // lui, ori, addi and j have been issued.
  Assembly A;
  A.constant(4, TextBegin)("addi", 5, 0, 7)("j", "next")
      .label("next")("sw", 5, 4, 0)("halt", 0);
  FunctionalSimulation S(quietChip(1, 1), A);
  RunResult Result = S.Machine.run();
  ASSERT_EQ(Result.End, RunResult::Trapped);
  EXPECT_EQ(Result.ExitStatus, 1);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::StoreToReadOnly);
  EXPECT_EQ(Result.TrapInfo->Pc, TextBegin + 16);
  EXPECT_EQ(Result.TrapInfo->Address, TextBegin);
  EXPECT_EQ(Result.TrapInfo->Cycle, 4u);
  EXPECT_EQ(S.Machine.statistics().instructions(), 4u);
}

TEST(Functional, TrapsOfFetch) {
  Assembly End, Illegal;
  End("addi", 4, 0, 1);
  Illegal("addi", 4, 0, 1).word(0);
  FunctionalSimulation First(quietChip(1, 1), End);
  EXPECT_EQ(First.Machine.run().TrapInfo->Kind, TrapKind::FetchOutsideText);
  FunctionalSimulation Second(quietChip(1, 1), Illegal);
  EXPECT_EQ(Second.Machine.run().TrapInfo->Kind, TrapKind::IllegalInstruction);
}

TEST(Functional, StackLimit) {
  Assembly A;
  A.constant(29, LocalBegin + 64)("addi", 29, 29, -32)("addi", 29, 29,
                                                       -16)("halt", 0);
  FunctionalSimulation S(quietChip(1, 1), A);
  S.Text.setStackLimit(LocalBegin + 24);
  FunctionalMachine Machine(S.Chip, S.Text, S.Global);
  RunResult Result = Machine.run();
  ASSERT_EQ(Result.End, RunResult::Trapped);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::StackOverflow);
  EXPECT_EQ(Result.TrapInfo->Pc, TextBegin + 12);
  EXPECT_EQ(Result.TrapInfo->Address, LocalBegin + 16);
}

TEST(Functional, CheckedFloatsTrapOnlyWhereTheyAreChecked) {
  Assembly A;
  A.constant(4, 1)("mtc1", 1, 4)("add_s", 2, 1, 1)("add_s", 3, 1, 1)("halt", 0);
  ChipConfig Chip = quietChip(1, 1);
  Chip.FlushToZero = true;
  FunctionalSimulation S(Chip, A);
  EXPECT_EQ(S.Machine.run().End, RunResult::Halted);
  EXPECT_EQ(S.Machine.registerOf(0, 32 + 2), 0u);
  S.Text.addFloatChecked(TextBegin + 16, TextBegin + 20);
  FunctionalMachine Machine(Chip, S.Text, S.Global);
  RunResult Result = Machine.run();
  ASSERT_EQ(Result.End, RunResult::Trapped);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::SubnormalOperand);
  EXPECT_EQ(Result.TrapInfo->Pc, TextBegin + 16);
}

TEST(Functional, StreamsAndOutput) {
  // A stream of capacity 2 takes two of three words and gives them back.
  Assembly A;
  A.constant(4, DataBegin)("addi", 5, 0, 2)("sw", 5, 4, 8)("addi", 6, 0, 'a')(
       "stream_push", 7, 6, 4)("stream_push", 8, 5, 4)("stream_push", 9, 5, 4)(
       "stream_pop", 10, 4)("sw", 10, 4, 64)("addi", 4, 0, 1)
      .constant(5, DataBegin + 64)("addi", 6, 0, 1)("hostcall", 0)("halt", 0);
  FunctionalSimulation S(quietChip(1, 1), A);
  EXPECT_EQ(S.Machine.run().End, RunResult::Halted);
  EXPECT_EQ(S.Machine.registerOf(0, 7), 1u);
  EXPECT_EQ(S.Machine.registerOf(0, 8), 1u);
  EXPECT_EQ(S.Machine.registerOf(0, 9), 0u);
  EXPECT_EQ(S.Output, "a");
}

} // namespace
