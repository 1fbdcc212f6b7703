//===- SumCheckTest.cpp - Whether a run's counts add up -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/SumCheck.h"
#include "test/unit/stats/MemoryRun.h"
#include "test/unit/stats/SmallRun.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

using namespace tp;
using testing::HasSubstr;

static std::string sumError(const SmallRun &Small) {
  return llvm::toString(checkSums(Small.Chip, Small.Stats, Small.Opcodes));
}

TEST(CheckSums, AcceptsRightRuns) {
  EXPECT_EQ(sumError(SmallRun()), "");
  EXPECT_EQ(sumError(MemoryRun()), "");
}

TEST(CheckSums, SeesWrongThreads) {
  SmallRun LostCycle;
  --LostCycle.Stats.Threads[1].Lost[unsigned(Loss::Finished)];
  EXPECT_THAT(sumError(LostCycle),
              HasSubstr("losses of thread 1 add up to 99 instead of 100"));

  SmallRun MissingThread;
  MissingThread.Stats.Threads.pop_back();
  EXPECT_THAT(sumError(MissingThread), HasSubstr("threads with statistics"));
}

TEST(CheckSums, SeesWrongOpcodes) {
  SmallRun WrongExecuted;
  ++WrongExecuted.Stats.Executed[0];
  EXPECT_THAT(sumError(WrongExecuted), HasSubstr("instructions by opcode"));

  SmallRun WrongStall;
  ++WrongStall.Stats.DataStall[0];
  EXPECT_THAT(sumError(WrongStall), HasSubstr("data stalls by opcode"));

  SmallRun WrongConflict;
  ++WrongConflict.Stats.UnitConflict[0];
  EXPECT_THAT(sumError(WrongConflict), HasSubstr("unit conflicts by opcode"));
}

TEST(CheckSums, SeesWrongInstructions) {
  SmallRun Missing;
  Missing.Stats.Pcs.pop_back();
  EXPECT_THAT(sumError(Missing), HasSubstr("words with statistics"));

  SmallRun WrongExecuted;
  ++WrongExecuted.Stats.Pcs[1].Executed;
  EXPECT_THAT(sumError(WrongExecuted),
              HasSubstr("issues by instruction of lw add up to 11 instead of "
                        "10"));

  SmallRun WrongLoss;
  --WrongLoss.Stats.Pcs[0].Lost[unsigned(Loss::Memory)];
  EXPECT_THAT(sumError(WrongLoss),
              HasSubstr("losses by instruction to memory add up to 19 instead "
                        "of 20"));

  SmallRun Nothing;
  Nothing.Opcodes[0] = IllegalOpcode;
  EXPECT_THAT(sumError(Nothing), HasSubstr("issues of what is no instruction"));
}

TEST(CheckSums, SeesWrongLevelsOfMemory) {
  MemoryRun L1;
  ++L1.Stats.Memory->L1->Hits;
  EXPECT_THAT(sumError(L1), HasSubstr("requests of the L1"));

  MemoryRun Accesses;
  ++Accesses.Stats.GlobalAccesses;
  EXPECT_THAT(sumError(Accesses),
              HasSubstr("accesses at the L1s add up to 52 instead of 53"));

  MemoryRun L2;
  --L2.Stats.Memory->L2->Merged;
  EXPECT_THAT(sumError(L2), HasSubstr("requests of the L2"));

  MemoryRun Rows;
  ++Rows.Stats.Memory->DramChannels[1].RowConflicts;
  EXPECT_THAT(sumError(Rows), HasSubstr("conflicts of DRAM channel 1"));

  MemoryRun Latencies;
  ++Latencies.Stats.Memory->DramChannels[0].ReadLatency[3];
  EXPECT_THAT(sumError(Latencies),
              HasSubstr("latencies of reads from DRAM channel 0"));
}

TEST(CheckSums, SeesLossesBetweenLevels) {
  MemoryRun BehindTheL1;
  ++BehindTheL1.Stats.Memory->SentByTmsUnderWay;
  EXPECT_THAT(sumError(BehindTheL1),
              HasSubstr("from TMs at the L2s add up to 21 instead of 20"));

  MemoryRun BehindTheL2;
  ++BehindTheL2.Stats.Memory->SentByL2s;
  EXPECT_THAT(sumError(BehindTheL2),
              HasSubstr("from L2s at the DRAM add up to 10 instead of 11"));

  MemoryRun WithoutL2;
  WithoutL2.Stats.Memory->L2.reset();
  WithoutL2.Stats.Memory->SentByTms = 9;
  EXPECT_EQ(sumError(WithoutL2), "");
  WithoutL2.Stats.Memory->DramChannels[0].Pending = 1;
  EXPECT_THAT(sumError(WithoutL2),
              HasSubstr("from TMs at the DRAM add up to 10 instead of 9"));
}
