//===- AgreementTest.cpp - Generated code against the reference -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

#include <utility>

using namespace tp;
using namespace tp::test;

namespace {

/// Runs a program with generated code and without and compares everything.
void expectAgreement(const ChipConfig &Chip, const Assembly &Program,
                     uint64_t MaxCycles = 1000000, unsigned HostThreads = 1) {
  Simulation Generated(Chip, Program, HostThreads);
  auto Generator = std::exchange(Simulation::DefaultGenerator, nullptr);
  Simulation Reference(Chip, Program);
  Simulation::DefaultGenerator = Generator;
  EXPECT_EQ(Generated.run(MaxCycles).End, Reference.run(MaxCycles).End);

  const Statistics &A = Generated.statistics(), &B = Reference.statistics();
  EXPECT_EQ(A.Cycles, B.Cycles);
  EXPECT_EQ(A.Executed, B.Executed);
  EXPECT_EQ(A.DataStall, B.DataStall);
  EXPECT_EQ(A.UnitConflict, B.UnitConflict);
  EXPECT_EQ(A.Markers, B.Markers);
  EXPECT_EQ(A.GlobalAccesses, B.GlobalAccesses);
  ASSERT_EQ(A.Pcs.size(), B.Pcs.size());
  for (size_t I = 0; I != A.Pcs.size(); ++I) {
    EXPECT_EQ(A.Pcs[I].Executed, B.Pcs[I].Executed) << "word " << I;
    EXPECT_EQ(A.Pcs[I].Lost, B.Pcs[I].Lost) << "word " << I;
    EXPECT_EQ(A.Pcs[I].Global, B.Pcs[I].Global) << "word " << I;
  }
  for (uint32_t Thread = 0; Thread != Chip.threadCount(); ++Thread) {
    EXPECT_EQ(A.Threads[Thread].Instructions, B.Threads[Thread].Instructions);
    EXPECT_EQ(A.Threads[Thread].Lost, B.Threads[Thread].Lost);
    for (unsigned Register = 0; Register != 64; ++Register)
      EXPECT_EQ(Generated.registerOf(Thread, Register),
                Reference.registerOf(Thread, Register))
          << "thread " << Thread << ", register " << Register;
  }
}

/// Few units and icache ports: threads disturb each other.
ChipConfig crowdedChip(uint32_t Tms, uint32_t Tps) {
  ChipConfig Chip = quietChip(Tms, Tps);
  for (UnitConfig &Type : Chip.Units)
    Type.Count = 1;
  Chip.Units[unsigned(Unit::FPINV)].Interval = 4;
  Chip.IcacheBanks = 4;
  Chip.IcachePorts = 1;
  return Chip;
}

/// Loops over arithmetic of all latencies, branches both ways, and memory.
Assembly mixedProgram() {
  Assembly A;
  A("mfsr", 8, 0)("addi", 9, 0, 50)("lui", 20, DataBegin >> 16)(
      "addi", 23, 0, -512)("sll", 10, 8, 2)("add", 20, 20, 10);
  A.label("loop");
  A("mul", 11, 9, 8)("addi", 11, 11, 3)("cvt_s_wu", 1, 11)("mul_s", 2, 1, 1)(
      "add_s", 3, 2, 1)("div_s", 4, 3, 2)("add_s", 4, 4, 1)("sqrt_s", 5, 4);
  A("sw", 11, 20, 0)("lw", 12, 20, 0)("lw", 13, 20, 256)("add", 13, 13, 12)(
      "sw", 13, 20, 256)("sw", 13, 23, 0)("lw", 14, 23, 0)("addi", 14, 14, 1)(
      "swc1", 5, 23, 4)("lwc1", 6, 23, 4)("lbu", 15, 23, 5);
  A("andi", 16, 9, 3)("beq", 16, 0, "rare")("j", "next");
  A.label("rare")("divu", 17, 13, 9)("prof", 3)("jal", "function");
  A.label("next")("addi", 9, 9, -1)("bne", 9, 0, "loop")("halt", 0);
  A.label("function")("addi", 18, 18, 1)("rsqrt_s", 7, 5)("jr", 31);
  return A;
}

TEST(Agreement, OfOneThread) {
  expectAgreement(quietChip(1, 1), mixedProgram());
}

TEST(Agreement, OfThreadsThatDisturbEachOther) {
  expectAgreement(crowdedChip(3, 4), mixedProgram());
}

TEST(Agreement, OnSeveralHostThreads) {
  expectAgreement(crowdedChip(5, 2), mixedProgram(), 1000000, 3);
}

TEST(Agreement, OfWideResourceWords) {
  ChipConfig Chip = crowdedChip(2, 8);
  Chip.IcacheBanks = 32;
  expectAgreement(Chip, mixedProgram());
  Chip.IcacheBanks = 128;
  expectAgreement(Chip, mixedProgram());
}

TEST(Agreement, WithSlowBranches) {
  ChipConfig Chip = crowdedChip(2, 3);
  Chip.Latency[unsigned(LatencyClass::Branch)] = 3;
  expectAgreement(Chip, mixedProgram());
}

TEST(Agreement, WithSubnormalsFlushed) {
  ChipConfig Chip = crowdedChip(2, 3);
  Chip.FlushToZero = true;
  expectAgreement(Chip, mixedProgram());
}

TEST(Agreement, WhenCutAtAnyCycle) {
  for (uint64_t Cycles : {1, 41, 42, 90})
    expectAgreement(crowdedChip(1, 2), mixedProgram(), Cycles);
}

} // namespace
