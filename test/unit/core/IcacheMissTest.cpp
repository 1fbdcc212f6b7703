//===- IcacheMissTest.cpp - Instruction caches that miss -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Windows of 16 cycles. Lines of 16 bytes are four instructions; the text
// begins with a line. A line comes 20 cycles after it was missed, or 30 from a
// memory system. Every figure is derived by hand.
//
//===----------------------------------------------------------------------===//

#include "simulator/core/InstructionCache.h"
#include "test/unit/core/ScriptedMemory.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

/// Two lines, by default direct-mapped: lines of even and of odd numbers.
ChipConfig missingChip(uint32_t Tps, uint32_t Ways = 1) {
  ChipConfig Chip = quietChip(1, Tps);
  Chip.IcacheMissKind = IcacheMisses::Fixed;
  Chip.IcacheMissLatency = 20;
  Chip.IcacheLineBytes = 16;
  Chip.IcacheBytes = 32;
  Chip.IcacheWays = Ways;
  return Chip;
}

void expectFetches(const Simulation &S, uint64_t Lookups, uint64_t Misses,
                   uint64_t Merged) {
  IcacheStatistics Counts = S.statistics().Icache;
  EXPECT_EQ(Counts.Lookups, Lookups);
  EXPECT_EQ(Counts.Misses, Misses);
  EXPECT_EQ(Counts.Merged, Merged);
}

TEST(IcacheMiss, EachNewLineIsWaitedFor) {
  // Line 0 comes in 20: 20 to 23. Line 1, missed in 24, in 44: 44 to 47. Line
  // 2, missed in 48, in 68: halt.
  Assembly A;
  A.repeat(8, "addi", 4, 4, 1)("halt", 0);
  Simulation S(missingChip(1), A);
  EXPECT_EQ(S.cycles(), 69u);
  EXPECT_EQ(S.lost(0, Loss::IcacheMiss), 60u);
  expectFetches(S, 3, 3, 0);
  EXPECT_EQ(S.statistics().Pcs[4].Lost[unsigned(Loss::IcacheMiss)], 20u);
}

TEST(IcacheMiss, NeverIfNotAskedFor) {
  Assembly A;
  A.repeat(8, "addi", 4, 4, 1)("halt", 0);
  ChipConfig Chip = missingChip(1);
  Chip.IcacheMissKind = IcacheMisses::Never;
  Simulation S(Chip, A);
  EXPECT_EQ(S.cycles(), 9u);
  expectFetches(S, 0, 0, 0);
}

TEST(IcacheMiss, LoopThatFitsMissesOnce) {
  // 20 to 23; line 1 missed in 24: bne in 44. Then 45 to 47, 48, 49 to 51, 52
  // without a miss; halt in 53. Each change of line is a lookup.
  Assembly A;
  A("addi", 4, 0, 3)
      .label("loop")("addi", 5, 5, 1)("addi", 6, 6, 1)("addi", 4, 4, -1)(
          "bne", 4, 0, "loop")("halt", 0);
  Simulation S(missingChip(1), A);
  EXPECT_EQ(S.cycles(), 54u);
  EXPECT_EQ(S.lost(0, Loss::IcacheMiss), 40u);
  expectFetches(S, 6, 2, 0);
}

/// A loop of two rounds whose parts are in lines 0 and 2.
Assembly farLoop() {
  Assembly A;
  A("addi", 4, 0, 2).label("loop")("addi", 4, 4, -1)("beq", 0, 0, "far");
  A.repeat(5, "addi", 5, 5, 1).label("far");
  A("bne", 4, 0, "loop")("halt", 0);
  return A;
}

TEST(IcacheMiss, LinesOfASetReplaceEachOther) {
  // 20 to 22; line 2 missed in 23: bne in 43. Line 0 missed in 44: 64, 65. Line
  // 2 in 66: bne in 86, halt in 87.
  Simulation S(missingChip(1), farLoop());
  EXPECT_EQ(S.cycles(), 88u);
  expectFetches(S, 4, 4, 0);
}

TEST(IcacheMiss, WaysKeepThem) {
  // As before up to 43; then 44, 45, bne in 46, halt in 47.
  Simulation S(missingChip(1, 2), farLoop());
  EXPECT_EQ(S.cycles(), 48u);
  expectFetches(S, 4, 2, 0);
}

TEST(IcacheMiss, OfTwoTpsIsOneFetch) {
  Assembly A;
  A("halt", 0);
  Simulation S(missingChip(2), A);
  EXPECT_EQ(S.cycles(), 21u);
  EXPECT_EQ(S.lost(0, Loss::IcacheMiss), 20u);
  EXPECT_EQ(S.lost(1, Loss::IcacheMiss), 20u);
  expectFetches(S, 2, 1, 1);
}

TEST(IcacheMiss, EarliestAskerDecides) {
  // Thread 0 misses line 1 in 22, thread 1, which has priority in this window,
  // in 24. The line comes in 42 for both.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("beq", 4, 0, "end")(
      "addi", 5, 5, 1)("addi", 5, 5, 1);
  A.label("end")("halt", 0);
  Simulation S(missingChip(2), A);
  EXPECT_EQ(S.cycles(), 43u);
  EXPECT_EQ(S.lost(0, Loss::IcacheMiss), 20u + 20u);
  EXPECT_EQ(S.lost(1, Loss::IcacheMiss), 20u + 18u);
  expectFetches(S, 4, 2, 2);
}

TEST(IcacheMiss, LineOnItsWayIsWaitedForInItsWindow) {
  ChipConfig Chip = missingChip(2);
  Chip.IcacheLineBytes = 32;
  Chip.IcacheBytes = 64;
  // Thread 0 misses line 1 in 23: 43. Thread 1 sleeps from 24 to 33, needs the
  // line in 37, in the window of 32 to 47, and goes on in 43.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("addi", 5, 0,
                                             9)("beq", 4, 0, "end")("sleep", 5);
  A.repeat(4, "addi", 6, 6, 1).label("end")("halt", 0);
  Simulation S(Chip, A);
  EXPECT_EQ(S.cycles(), 44u);
  EXPECT_EQ(S.lost(1, Loss::IcacheMiss), 20u + 6u);
  expectFetches(S, 4, 2, 2);
}

TEST(IcacheMiss, MessagesAreNotFetched) {
  // The four instructions are one line.
  Assembly A;
  A("prof", 1).repeat(3, "addi", 4, 4, 1)("prof", 2)("halt", 0);
  Simulation S(missingChip(1), A);
  EXPECT_EQ(S.cycles(), 24u);
  expectFetches(S, 1, 1, 0);
}

TEST(IcacheMiss, IsCutByTheCycleLimit) {
  Assembly A;
  A("halt", 0);
  Simulation S(missingChip(1), A);
  EXPECT_EQ(S.run(10).End, RunResult::CycleLimit);
  EXPECT_EQ(S.lost(0, Loss::IcacheMiss), 10u);
}

TEST(IcacheMiss, LinesComeFromTheMemorySystem) {
  for (uint32_t L1Latency : {0, 3}) {
    ChipConfig Chip = ScriptedMemory::chip(1, 2, L1Latency);
    Chip.IcacheMissKind = IcacheMisses::Memory;
    Chip.IcacheLineBytes = 16;
    Chip.IcacheBytes = 32;
    // Line 0 comes in 30: 30 to 33 (thread 0: 30, 31, 34 to 37 at most: no
    // conflicts on this chip). Thread 0 misses line 1 in 32, thread 1 in 34:
    // both go on in 62.
    Assembly A;
    A("mfsr", 4, int(SpecialRegister::thread))("beq", 4, 0, "end")(
        "addi", 5, 5, 1)("addi", 5, 5, 1);
    A.label("end")("halt", 0);
    Simulation S(Chip, A, 1, ScriptedMemory::make(Chip));
    EXPECT_EQ(S.cycles(), 63u);
    EXPECT_EQ(S.lost(0, Loss::IcacheMiss), 30u + 30u);
    EXPECT_EQ(S.lost(1, Loss::IcacheMiss), 30u + 28u);
    expectFetches(S, 4, 2, 2);
  }
}

TEST(IcacheMiss, EndOfARunThatWaitsForALine) {
  ChipConfig Chip = ScriptedMemory::chip(1, 1);
  Chip.IcacheMissKind = IcacheMisses::Memory;
  Chip.IcacheLineBytes = 16;
  Chip.IcacheBytes = 32;
  Assembly A;
  A("halt", 0);
  for (uint64_t Limit : {10, 20}) {
    Simulation S(Chip, A, 1, ScriptedMemory::make(Chip));
    EXPECT_EQ(S.run(Limit).End, RunResult::CycleLimit);
    EXPECT_EQ(S.lost(0, Loss::IcacheMiss), Limit);
  }
}

TEST(InstructionCache, KnowsWhatItHoldsInEachCycle) {
  ChipConfig Chip = missingChip(1, 2); // one set of two lines
  InstructionCache Cache(Chip);
  Cache.arrives(1, 100);
  Cache.arrives(2, 110);
  Cache.arrives(3, 120);
  Cache.beginWindow(96);
  EXPECT_EQ(Cache.lookUp(1, 99), 100u); // on its way
  EXPECT_EQ(Cache.lookUp(1, 119), 119u);
  EXPECT_EQ(Cache.lookUp(1, 100), 100u); // any order of lookups
  // The first that came leaves first, though it was used last.
  EXPECT_EQ(Cache.lookUp(1, 120), InstructionCache::Unknown);
  EXPECT_EQ(Cache.lookUp(2, 125), 125u);
  EXPECT_EQ(Cache.lookUp(3, 96), 120u);
  Cache.beginWindow(128);
  EXPECT_EQ(Cache.lookUp(2, 128), 128u);
  EXPECT_EQ(Cache.lookUp(3, 130), 130u);
  EXPECT_EQ(Cache.lookUp(1, 130), InstructionCache::Unknown);
}

} // namespace
