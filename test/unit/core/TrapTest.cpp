//===- TrapTest.cpp - What stops a program --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

constexpr int ThreadRegister = int(SpecialRegister::thread);

/// Runs on one TP and gives the trap; where it happened is for the test to say.
static Trap trapOf(const Assembly &A) {
  Simulation S(quietChip(1, 1), A);
  RunResult Result = S.run();
  EXPECT_EQ(Result.End, RunResult::Trapped);
  EXPECT_EQ(Result.ExitStatus, 1);
  return Result.TrapInfo.value_or(Trap());
}

namespace {

TEST(Traps, IllegalInstruction) {
  Assembly A;
  A("addi", 4, 0, 1).word(0);
  Trap T = trapOf(A);
  EXPECT_EQ(T.Kind, TrapKind::IllegalInstruction);
  EXPECT_EQ(T.Pc, TextBegin + 4);
  EXPECT_EQ(T.Cycle, 1u);
  EXPECT_EQ(T.what(), "illegal instruction");
}

TEST(Traps, EndOfText) {
  Assembly A;
  Trap T = trapOf(A("addi", 4, 0, 1));
  EXPECT_EQ(T.Kind, TrapKind::FetchOutsideText);
  EXPECT_EQ(T.Address, TextBegin + 4);
}

TEST(Traps, JumpOutsideText) {
  for (uint32_t Target : {0u, TextBegin + 2, TextBegin + 64, TextBegin - 4}) {
    Assembly A;
    A.constant(4, Target)("jr", 4);
    Trap T = trapOf(A);
    EXPECT_EQ(T.Kind, TrapKind::FetchOutsideText);
    EXPECT_EQ(T.Pc, TextBegin + 8);
    EXPECT_EQ(T.Address, Target);
  }
}

struct BadAccess {
  uint32_t Address;
  const char *Mnemonic;
  TrapKind Kind;
};

TEST(Traps, BadDataAddresses) {
  const uint32_t MemoryEnd = 1 << 20;
  const BadAccess Accesses[] = {
      {0, "lw", TrapKind::NullAccess},
      {4, "sw", TrapKind::NullAccess},
      {0xFFFF, "lb", TrapKind::NullAccess},
      {DataBegin + 1, "lh", TrapKind::MisalignedAccess},
      {DataBegin + 1, "sh", TrapKind::MisalignedAccess},
      {DataBegin + 2, "lw", TrapKind::MisalignedAccess},
      {DataBegin + 2, "sw", TrapKind::MisalignedAccess},
      {DataBegin + 3, "lwc1", TrapKind::MisalignedAccess},
      {DataBegin + 3, "swc1", TrapKind::MisalignedAccess},
      {MemoryEnd, "lw", TrapKind::AddressOutOfRange},
      {MemoryEnd, "sb", TrapKind::AddressOutOfRange},
      {0x80000000, "lbu", TrapKind::AddressOutOfRange},
      {LocalBegin - 1, "sb", TrapKind::AddressOutOfRange},
      {LocalBegin - 4, "lw", TrapKind::AddressOutOfRange},
      {0xFFFFFFF0, "lw", TrapKind::AddressOutOfRange},
      {0xFFFFFFFF, "sb", TrapKind::AddressOutOfRange},
      {TextBegin, "sw", TrapKind::StoreToReadOnly},
      {TextBegin + 8, "sb", TrapKind::StoreToReadOnly},
  };
  for (const BadAccess &Access : Accesses) {
    Assembly A;
    A.constant(20, Access.Address)(Access.Mnemonic, 5, 20, 0)("halt", 0);
    Trap T = trapOf(A);
    EXPECT_EQ(T.Kind, Access.Kind) << Access.Mnemonic << ' ' << T.what();
    EXPECT_EQ(T.Pc, TextBegin + 8);
    EXPECT_EQ(T.Address, Access.Address);
    EXPECT_EQ(T.Cycle, 2u);
  }
}

TEST(Traps, LastGoodAddressesAreGood) {
  Assembly A;
  A.constant(20, (1 << 20) - 4).constant(21, 0xFFFFFFEC);
  A.constant(22, LocalBegin)("sw", 20, 20, 0)("sw", 20, 21, 0)("sw", 20, 22, 0)(
      "sb", 20, 21, 3)("lw", 4, 20, 0)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.cycles();
}

TEST(Traps, AtomicsOnBadAddresses) {
  const BadAccess Accesses[] = {
      {0, "", TrapKind::NullAccess},
      {DataBegin + 2, "", TrapKind::MisalignedAccess},
      {TextBegin, "", TrapKind::StoreToReadOnly},
      {0xFFFFFFF0, "", TrapKind::AddressOutOfRange},
  };
  for (const BadAccess &Access : Accesses) {
    Assembly A;
    A.constant(20, Access.Address)("atom_add", 4, 0, 20)("halt", 0);
    EXPECT_EQ(trapOf(A).Kind, Access.Kind);
    Assembly B;
    B.constant(20, Access.Address)("stream_pop", 4, 20)("halt", 0);
    EXPECT_EQ(trapOf(B).Kind, Access.Kind);
  }
}

TEST(Traps, StreamWithoutCapacity) {
  // The operation is done at the end of the window, the trap is that of its
  // cycle, 1.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("stream_pop", 4, 20)("halt", 0);
  Trap T = trapOf(A);
  EXPECT_EQ(T.Kind, TrapKind::BadStream);
  EXPECT_EQ(T.Cycle, 1u);
  EXPECT_EQ(T.Pc, TextBegin + 4);
}

TEST(Traps, BadHostCalls) {
  Assembly Service;
  Service("addi", 4, 0, 1)("hostcall", 77)("halt", 0);
  Trap T = trapOf(Service);
  EXPECT_EQ(T.Kind, TrapKind::BadHostCall);
  EXPECT_EQ(T.Address, 77u);
  Assembly Fd;
  Fd("addi", 4, 0, 3)("addi", 6, 0, 1)("hostcall", 0)("halt", 0);
  EXPECT_EQ(trapOf(Fd).Kind, TrapKind::BadHostCall);
  Assembly Address;
  Address("addi", 4, 0, 1)("addi", 6, 0, 1)("hostcall", 0)("halt", 0);
  EXPECT_EQ(trapOf(Address).Kind, TrapKind::NullAccess);
}

TEST(Traps, TheFirstByCycleWins) {
  // Thread t breaks in cycle 3 + (3 - t): thread 3 is first.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("addi", 5, 0, 3)("sub", 5, 5, 4)("sleep",
                                                                5)("break", 9);
  Simulation S(quietChip(2, 2), A);
  RunResult Result = S.run();
  ASSERT_TRUE(Result.TrapInfo);
  EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::Break);
  EXPECT_EQ(Result.TrapInfo->Thread, 3u);
  EXPECT_EQ(Result.TrapInfo->Address, 9u);
  EXPECT_EQ(Result.TrapInfo->Cycle, 4u);
}

TEST(Traps, InOneCycleTheFirstByPriorityThenTmWins) {
  // In window 1 TP 1 comes first: thread 1 (TM 0).
  Assembly A;
  A.repeat(16, "addi", 4, 0, 1)("break", 0);
  Simulation S(quietChip(2, 3), A);
  RunResult Result = S.run();
  ASSERT_TRUE(Result.TrapInfo);
  EXPECT_EQ(Result.TrapInfo->Thread, 1u);
  EXPECT_EQ(Result.TrapInfo->Cycle, 16u);
}

TEST(Traps, EndTheRunAtTheEndOfTheWindow) {
  // The other thread goes on to the end of the window: 16 instructions. The
  // trapping one has issued one and counts as finished from cycle 2 on.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("beq", 4, 0, "trap");
  A.label("forever")("j", "forever").label("trap")("break", 1);
  Simulation S(quietChip(1, 2), A);
  EXPECT_EQ(S.run().End, RunResult::Trapped);
  EXPECT_EQ(S.statistics().Cycles, 16u);
  EXPECT_EQ(S.statistics().Threads[1].Instructions, 16u);
  EXPECT_EQ(S.statistics().Threads[0].Instructions, 2u);
  EXPECT_EQ(S.lost(0, Loss::Finished), 14u);
}

TEST(Traps, OutputBeforeTheTrapIsWritten) {
  Assembly A;
  A("lui", 5, DataBegin >> 16)("addi", 7, 0, 'x')("sb", 7, 5, 0)(
      "addi", 4, 0, 1)("addi", 6, 0, 1)("hostcall", 0)("break", 1);
  Simulation S(quietChip(1, 1), A);
  EXPECT_EQ(S.run().End, RunResult::Trapped);
  EXPECT_EQ(S.output(), "x");
}

} // namespace
