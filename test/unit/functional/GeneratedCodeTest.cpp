//===- GeneratedCodeTest.cpp - Generated code and the interpreter ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Programs run with all code generated as soon as it has been executed once,
// and interpreted: registers, memory, counts and traps must be the same.
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/FunctionalJit.h"
#include "test/unit/functional/FunctionalSimulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static constexpr int ThreadNumber = int(SpecialRegister::thread);
static constexpr int Instret = int(SpecialRegister::instret);

namespace {

/// One run of a program, with or without generated code.
struct Run {
  FunctionalSimulation Simulated;
  FunctionalMachine Machine;
  RunResult Result;
  Statistics Counts;

  template <class Function>
  Run(const ChipConfig &Chip, const Assembly &Source, bool GenerateCode,
      Function Prepare)
      : Simulated(Chip, Source),
        Machine(Simulated.Chip, prepared(Prepare), Simulated.Global) {
    if (GenerateCode)
      Machine.setCodeGenerator(cantFail(makeFunctionalJit(
          {.TurnsBetweenLooks = 1, .HotCount = 1, .Waits = true})));
    Result = Machine.run();
    Counts = Machine.statistics();
  }

private:
  template <class Function> const Program &prepared(Function Prepare) {
    Prepare(Simulated.Text);
    return Simulated.Text;
  }
};

} // namespace

/// Runs the program in both ways, expects the same of both, and gives the end.
template <class Function>
static RunResult expectAgreement(const ChipConfig &Chip, const Assembly &Source,
                                 Function Prepare) {
  Run Interpreted(Chip, Source, false, Prepare);
  Run Generated(Chip, Source, true, Prepare);
  const RunResult &Expected = Interpreted.Result, &Actual = Generated.Result;
  EXPECT_EQ(Actual.End, Expected.End);
  EXPECT_EQ(Actual.ExitStatus, Expected.ExitStatus);
  EXPECT_EQ(Actual.TrapInfo.has_value(), Expected.TrapInfo.has_value());
  if (Actual.TrapInfo && Expected.TrapInfo) {
    EXPECT_EQ(Actual.TrapInfo->Kind, Expected.TrapInfo->Kind);
    EXPECT_EQ(Actual.TrapInfo->Thread, Expected.TrapInfo->Thread);
    EXPECT_EQ(Actual.TrapInfo->Pc, Expected.TrapInfo->Pc);
    EXPECT_EQ(Actual.TrapInfo->Address, Expected.TrapInfo->Address);
    EXPECT_EQ(Actual.TrapInfo->Cycle, Expected.TrapInfo->Cycle);
  }
  for (uint32_t Thread = 0; Thread != Chip.threadCount(); ++Thread) {
    EXPECT_EQ(Generated.Counts.Threads[Thread].Instructions,
              Interpreted.Counts.Threads[Thread].Instructions);
    for (unsigned Register = 0; Register != NumRegisters; ++Register)
      EXPECT_EQ(Generated.Machine.registerOf(Thread, Register),
                Interpreted.Machine.registerOf(Thread, Register))
          << "thread " << Thread << " register " << Register;
  }
  for (size_t Word = 0; Word != Interpreted.Counts.Pcs.size(); ++Word)
    EXPECT_EQ(Generated.Counts.Pcs[Word].Executed,
              Interpreted.Counts.Pcs[Word].Executed)
        << "word " << Word;
  for (uint32_t At = DataBegin; At != DataBegin + 256; At += 4)
    EXPECT_EQ(Generated.Simulated.word(At), Interpreted.Simulated.word(At));
  EXPECT_EQ(Generated.Counts.Markers, Interpreted.Counts.Markers);
  return Actual;
}

static void asItIs(Program &) {}

namespace {

TEST(GeneratedCode, TurnsEndAtTheSameInstructions) {
  // Two functions, one called directly and one through a register, in a loop
  // with an inner loop. Threads swap words through one address all the time:
  // what each of them gets depends on where every turn ends.
  Assembly A;
  A("j", "start")
      .label("first")("xor", 10, 10, 11)("addi", 12, 12, 3)("jr", 31)
      .label("second")("lw", 14, 4, 4)("add", 14, 14, 10)("sw", 14, 4, 4)(
          "bne", 15, 0, "odd")("addi", 16, 16, 1)("jr", 31)
      .label("odd")("addi", 16, 16, 2)("jr", 31)
      .label("start")
      .constant(4, DataBegin)
      .constant(20, TextBegin + 4 * 4)
      .constant(5, 20000)("mfsr", 11, ThreadNumber)("addi", 11, 11, 77)
      .label("loop")("andi", 15, 5, 1)("jal", "first")("jalr", 20)("andi", 17,
                                                                   5, 7)
      .label("inner")("addi", 17, 17, -1)("add", 18, 18, 17)(
          "bge", 17, 0, "inner")("sw", 10, 4, 0)("lw", 11, 4, 0)(
          "andi", 19, 5, 63)("bne", 19, 0, "next")("prof", 3)(
          "atom_swap", 11, 10, 4)("mfsr", 21, Instret)
      .label("next")("addi", 5, 5, -1)("bne", 5, 0, "loop")("barrier")(
          "lw", 22, 4, 4)("halt", 0);
  RunResult Result = expectAgreement(quietChip(1, 5), A, asItIs);
  EXPECT_EQ(Result.End, RunResult::Halted);
}

TEST(GeneratedCode, TrapAfterManyTurns) {
  // Stores downwards until it reaches the text, which is read-only.
  Assembly A;
  A.constant(4, TextBegin + (1 << 18))
      .label("loop")("sw", 5, 4, 0)("addi", 5, 5, 3)("addi", 4, 4, -4)("j",
                                                                       "loop");
  RunResult Result = expectAgreement(quietChip(1, 1), A, asItIs);
  ASSERT_EQ(Result.End, RunResult::Trapped);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::StoreToReadOnly);
}

TEST(GeneratedCode, StackLimitAfterManyCalls) {
  // The stack goes down and up in each pass, and once it goes too far.
  Assembly A;
  A.constant(29, LocalBegin + 512)
      .constant(5, 30000)
      .label("loop")("addi", 29, 29, -32)("sw", 5, 29, 0)("addi", 29, 29, 32)(
          "addi", 5, 5, -1)("bne", 5, 0, "loop")("addi", 5, 5, 1)(
          "addi", 29, 29, -480)("j", "loop");
  RunResult Result = expectAgreement(quietChip(1, 2), A, [](Program &Text) {
    Text.setStackLimit(LocalBegin + 24);
  });
  ASSERT_EQ(Result.End, RunResult::Trapped);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::StackOverflow);
}

TEST(GeneratedCode, CheckedFloats) {
  // f2 is multiplied by a little less than one until it is subnormal.
  Assembly A;
  A.constant(4, 0x3f7ff000)("mtc1", 1, 4)("mtc1", 2, 4)
      .label("loop")("mul_s", 2, 2, 1)("addi", 5, 5, 1)("j", "loop");
  ChipConfig Chip = quietChip(1, 1);
  Chip.FlushToZero = true;
  RunResult Result = expectAgreement(Chip, A, [](Program &Text) {
    Text.addFloatChecked(TextBegin, TextBegin + 28);
  });
  ASSERT_EQ(Result.End, RunResult::Trapped);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::SubnormalResult);
}

} // namespace
