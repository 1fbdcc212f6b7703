//===- ProfileTest.cpp - Messages to the observer of a run ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

#include <map>

using namespace tp;
using namespace tp::test;

namespace {

/// Remembers all values; for one host thread.
struct ValueLog : ProfileObserver {
  void profileValue(uint32_t Thread, uint32_t Marker, uint32_t Value) override {
    Seen[Thread].push_back({Marker, Value});
  }

  using Values = std::vector<std::pair<uint32_t, uint32_t>>;
  std::map<uint32_t, Values> Seen;
};

/// Waits for memory, units, icache ports, others and itself.
Assembly busyProgram(bool WithMessages) {
  Assembly A;
  A("lui", 20, DataBegin >> 16)("addi", 8, 0, 30);
  A.label("round");
  auto Message = [&](unsigned Marker, unsigned Register) {
    if (WithMessages)
      A("profv", Marker, Register)("prof", Marker);
  };
  Message(1, 8);
  A("lw", 4, 20, 0)("cvt_s_w", 1, 4);
  Message(2, 4);
  A("mul_s", 2, 1, 1)("rcp_s", 3, 2)("andi", 5, 8, 3);
  Message(3, 5);
  A("bne", 5, 0, "on")("barrier")("sync");
  Message(4, 0);
  A.label("on")("addi", 8, 8, -1);
  Message(5, 8);
  return A("bne", 8, 0, "round")("mfsr", 10, 9)("halt", 0);
}

ChipConfig busyChip() {
  ChipConfig Chip = quietChip(2, 8);
  for (UnitConfig &Type : Chip.Units)
    Type.Count = 1;
  Chip.IcacheBanks = 4;
  Chip.IcachePorts = 1;
  return Chip;
}

} // namespace

TEST(Profile, MessagesTakeNothing) {
  Simulation Without(busyChip(), busyProgram(false));
  Simulation With(busyChip(), busyProgram(true));
  ValueLog Log;
  With.setObserver(Log);
  EXPECT_EQ(Without.cycles(), With.cycles());
  const Statistics &A = Without.statistics(), &B = With.statistics();
  EXPECT_EQ(A.Executed, B.Executed);
  EXPECT_EQ(A.DataStall, B.DataStall);
  EXPECT_EQ(A.UnitConflict, B.UnitConflict);
  EXPECT_GT(Without.lost(7, Loss::UnitConflict), 0u);
  EXPECT_GT(Without.lost(7, Loss::IcacheConflict), 0u);
  for (size_t I = 0; I != A.Threads.size(); ++I) {
    EXPECT_EQ(A.Threads[I].Lost, B.Threads[I].Lost) << "thread " << I;
    EXPECT_EQ(A.Threads[I].FinishCycle, B.Threads[I].FinishCycle);
  }
  EXPECT_EQ(B.Markers[1], 16u * 30);
  EXPECT_EQ(Log.Seen.size(), 16u);
  EXPECT_EQ(Log.Seen[9].size(), 30u * 4 + 30 / 4);
}

TEST(Profile, ValueOfALoadInFlightIsThereAtOnce) {
  // lui 0, lw 1, halt 2.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("lw", 4, 20, 0)("profv", 7, 4)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.setWord(DataBegin, 1234);
  ValueLog Log;
  S.setObserver(Log);
  EXPECT_EQ(S.cycles(), 3u);
  EXPECT_EQ(Log.Seen[0], (ValueLog::Values{{7, 1234}}));
}

TEST(Profile, ValueOfAnAtomicInFlightIsWaitedFor) {
  // lui 0, addi 1, atom_add 2, its result 22, halt 22.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("addi", 5, 0, 1)("atom_add", 4, 5,
                                                 20)("profv", 7, 4)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.setWord(DataBegin, 1234);
  ValueLog Log;
  S.setObserver(Log);
  EXPECT_EQ(S.cycles(), 23u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 19u);
  EXPECT_EQ(Log.Seen[0], (ValueLog::Values{{7, 1234}}));
}

TEST(Profile, OtherRegistersDoNotWaitForAnAtomic) {
  Assembly A;
  A("lui", 20, DataBegin >> 16)("addi", 5, 0, 1)("atom_add", 4, 5,
                                                 20)("profv", 7, 5)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  EXPECT_EQ(S.cycles(), 4u);
}

TEST(Profile, WithoutObserverValuesAreDropped) {
  Assembly A;
  Simulation S(quietChip(1, 1), A("profv", 7, 5)("halt", 0));
  EXPECT_EQ(S.cycles(), 1u);
  EXPECT_TRUE(S.statistics().Markers.empty());
}

TEST(Profile, MessagesBehindTheLastInstructionAreNotFetched) {
  Assembly A;
  Simulation S(quietChip(1, 1), A("halt", 0)("profv", 7, 5));
  ValueLog Log;
  S.setObserver(Log);
  EXPECT_EQ(S.cycles(), 1u);
  EXPECT_TRUE(Log.Seen.empty());
}

TEST(Profile, TextMustNotEndWithMessages) {
  Assembly A;
  Simulation S(quietChip(1, 1), A("addi", 4, 0, 1)("prof", 7));
  RunResult Result = S.run();
  ASSERT_TRUE(Result.TrapInfo);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::FetchOutsideText);
  EXPECT_EQ(Result.TrapInfo->Cycle, 1u);
}

TEST(Profile, AResultOfTheWindowIsWaitedForAlsoAtItsEnd) {
  // The atomic issues in the first cycle of window 1, [16, 32), its result is
  // ready in 32, and the thread is at the message when cycle 31 has issued.
  ChipConfig Chip = quietChip(1, 1);
  Chip.MemoryLatency = Chip.ArbitrationWindow;
  Assembly A;
  A("lui", 20, DataBegin >> 16).repeat(15, "addi", 5, 0, 7);
  A("atom_add", 4, 5, 20).repeat(15, "addi", 6, 0, 1);
  A("profv", 3, 4)("halt", 0);
  Simulation S(Chip, A);
  S.setWord(DataBegin, 1234);
  ValueLog Log;
  S.setObserver(Log);
  EXPECT_EQ(S.cycles(), 33u);
  EXPECT_EQ(Log.Seen[0], (ValueLog::Values{{3, 1234}}));
}
