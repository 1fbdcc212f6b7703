//===- RequestOriginsTest.cpp - Whose accesses were served where ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/ScriptedMemory.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static constexpr int DataHigh = DataBegin >> 16;
static constexpr int After20 = 2 * 256, After50 = 5 * 256, After200 = 20 * 256;

/// Runs on a chip with the scripted memory.
static ExecutionRecord record(const Assembly &A, uint32_t L1Latency = 0) {
  ChipConfig Chip = ScriptedMemory::chip(1, 1, L1Latency);
  Simulation S(Chip, A, 1, ScriptedMemory::make(Chip));
  S.record();
  S.cycles();
  return S.recorded();
}

static ServedAccesses served(const ExecutionRecord &Record, unsigned Word,
                             ServedBy Level) {
  return Record.Pcs[Word].Served[unsigned(Level)];
}

TEST(RequestOrigins, AnswersCountAtTheirInstructions) {
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After20)("lw", 6, 20, After200)(
      "sw", 0, 20, After50)("add", 5, 5, 6)("halt", 0);
  ExecutionRecord Record = record(A);
  EXPECT_EQ(served(Record, 1, ServedBy::L2), (ServedAccesses{1, 20}));
  EXPECT_EQ(served(Record, 2, ServedBy::DramRowConflict),
            (ServedAccesses{1, 200}));
  EXPECT_EQ(served(Record, 3, ServedBy::Memory), (ServedAccesses{1, 50}));
  EXPECT_EQ(served(Record, 4, ServedBy::L2), ServedAccesses());
}

TEST(RequestOrigins, HitsOfTheL1) {
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, 0)("addi", 5, 5, 1)("halt", 0);
  ExecutionRecord Record = record(A, 3);
  EXPECT_EQ(served(Record, 1, ServedBy::L1), (ServedAccesses{1, 3}));
}

TEST(RequestOrigins, OfTwoLoadsToARegisterBothCount) {
  // The second answer comes long before the first.
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After200)("lw", 5, 20, After20)(
      "lw", 5, 20, After50)("lw", 6, 20, After200)("addi", 6, 6, 1)("halt", 0);
  ExecutionRecord Record = record(A);
  EXPECT_EQ(served(Record, 1, ServedBy::DramRowConflict),
            (ServedAccesses{1, 200}));
  EXPECT_EQ(served(Record, 2, ServedBy::L2), (ServedAccesses{1, 20}));
  EXPECT_EQ(served(Record, 3, ServedBy::Memory), (ServedAccesses{1, 50}));
  EXPECT_EQ(served(Record, 4, ServedBy::DramRowConflict),
            (ServedAccesses{1, 200}));
}

TEST(RequestOrigins, WhatIsUnderWayAtTheEndIsNotThere) {
  Assembly A;
  A("lui", 20, DataHigh)("lw", 5, 20, After200)("halt", 0);
  ExecutionRecord Record = record(A);
  EXPECT_EQ(Record.Pcs[1].Global, 1u);
  EXPECT_EQ(served(Record, 1, ServedBy::DramRowConflict), ServedAccesses());
}
