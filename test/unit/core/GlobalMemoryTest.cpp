//===- GlobalMemoryTest.cpp - Order and visibility of accesses ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

constexpr int ThreadRegister = int(SpecialRegister::thread);
constexpr uint32_t DataHigh = DataBegin >> 16;

TEST(GlobalMemory, StoresBecomeVisibleAtTheEndOfTheWindow) {
  // Thread 0 stores 7 in cycle 4. Thread 1 loads in 4 (one per cycle) until
  // the end of the window and sees 0; its load in cycle 16 sees 7.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("lui", 20, DataHigh)("addi", 5, 0, 7)(
      "bne", 4, 0, "reader")("sw", 5, 20, 0)("halt", 0);
  A.label("reader").repeat(11, "lw", 6, 20, 0)("lw", 7, 20, 0)("lw", 8, 20,
                                                               0)("halt", 0);
  for (uint32_t Tms : {1u, 2u}) {
    Simulation S(quietChip(Tms, 2 / Tms), A);
    S.cycles();
    EXPECT_EQ(S.registerOf(1, 7), 0u);
    EXPECT_EQ(S.registerOf(1, 8), 7u);
  }
}

TEST(GlobalMemory, SyncMakesStoresVisible) {
  // Both threads store, sync, then read the other's word.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("lui", 20, DataHigh)("sll", 5, 4, 2)(
      "add", 21, 20, 5)("xori", 5, 5, 4)("add", 22, 20, 5)("addi", 6, 4, 100)(
      "sw", 6, 21, 0)("sync")("lw", 7, 22, 0)("halt", 0);
  Simulation S(quietChip(2, 1), A);
  S.cycles();
  EXPECT_EQ(S.registerOf(0, 7), 101u);
  EXPECT_EQ(S.registerOf(1, 7), 100u);
}

TEST(GlobalMemory, OfStoresInOneCycleThatOfTheLastPriorityStays) {
  // All store their number in the same cycle. In window w the first TP is
  // w mod 3, so TP (w + 2) mod 3 comes last; of two TMs the second.
  for (unsigned Window : {0u, 1u, 2u, 3u}) {
    Assembly A;
    A("mfsr", 4, ThreadRegister)("lui", 20, DataHigh);
    A.repeat(16 * Window, "addi", 5, 0, 1)("sw", 4, 20, 0)("halt", 0);
    Simulation S(quietChip(2, 3), A);
    S.cycles();
    EXPECT_EQ(S.word(DataBegin), 3 + (Window + 2) % 3) << Window;
  }
}

TEST(GlobalMemory, LaterCyclesComeAfterEarlierOnes) {
  // Thread t stores in cycle 4 + 4 - t: thread 0 last, whatever its priority.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("lui", 20, DataHigh)("addi", 5, 0, 4)(
      "sub", 5, 5, 4)("sleep", 5)("sw", 4, 20, 0)("halt", 0);
  Simulation S(quietChip(2, 2), A);
  S.setWord(DataBegin, 99);
  S.cycles();
  EXPECT_EQ(S.word(DataBegin), 0u);
}

TEST(GlobalMemory, AtomicsTakeEffectInTheOrderOfCyclePriorityTm) {
  // atom_add of 1 by all six threads in the same cycle of window 1, where TP 1
  // comes first: TP 1 of TM 0, of TM 1, TP 2 of TM 0, ..., TP 0 of TM 1.
  Assembly A;
  A("addi", 5, 0, 1)("lui", 20, DataHigh);
  A.repeat(16, "addi", 6, 0, 1)("atom_add", 4, 5, 20)("halt", 0);
  Simulation S(quietChip(2, 3), A);
  S.setWord(DataBegin, 10);
  S.cycles();
  EXPECT_EQ(S.word(DataBegin), 16u);
  const uint32_t Expected[] = {14, 10, 12, 15, 11, 13};
  for (uint32_t T = 0; T != 6; ++T)
    EXPECT_EQ(S.registerOf(T, 4), Expected[T]) << T;
}

TEST(GlobalMemory, AtomicsAndStoresShareOneOrder) {
  // Cycle 4: thread 0 stores 100, thread 1 swaps in 1: thread 1 gets 100.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("lui", 20, DataHigh)("addi", 5, 0, 100)(
      "bne", 4, 0, "second")("sw", 5, 20, 0)("halt", 0);
  A.label("second")("atom_swap", 6, 4, 20)("halt", 0);
  Simulation S(quietChip(1, 2), A);
  S.cycles();
  EXPECT_EQ(S.registerOf(1, 6), 100u);
  EXPECT_EQ(S.word(DataBegin), 1u);
}

TEST(GlobalMemory, AtomicTakesTheMemoryLatency) {
  // lui 0, atom_add 1, addi waits to 21, halt 22.
  Assembly A;
  A("lui", 20, DataHigh)("atom_add", 4, 20, 20)("addi", 5, 4, 1)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.setWord(DataBegin, 41);
  EXPECT_EQ(S.cycles(), 23u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 19u);
  EXPECT_EQ(S.registerOf(0, 5), 42u);
}

TEST(GlobalMemory, OwnStoresAreForwarded) {
  // All in one window: bytes, halves and words over each other.
  Assembly A;
  A("lui", 20, DataHigh).constant(4, 0x11223344).constant(5, 0xAABBCCDD);
  A("sw", 4, 20, 0)("lw", 6, 20, 0); // 11223344
  A("sb", 5, 20, 1)("lw", 7, 20, 0); // 1122DD44
  A("sh", 5, 20, 2)("lw", 8, 20, 0); // CCDDDD44
  A("lbu", 9, 20, 3)("lh", 10, 20, 2)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.cycles();
  EXPECT_EQ(S.registerOf(0, 6), 0x11223344u);
  EXPECT_EQ(S.registerOf(0, 7), 0x1122DD44u);
  EXPECT_EQ(S.registerOf(0, 8), 0xCCDDDD44u);
  EXPECT_EQ(S.registerOf(0, 9), 0xCCu);
  EXPECT_EQ(S.registerOf(0, 10), 0xFFFFCCDDu);
  EXPECT_EQ(S.word(DataBegin), 0xCCDDDD44u);
}

TEST(GlobalMemory, ForwardedBytesMixWithMemory) {
  // Only byte 2 is stored; the others come from memory. The word 64 bytes on,
  // which shares the bit of the filter, is not disturbed.
  Assembly A;
  A("lui", 20, DataHigh)("addi", 4, 0, 0x55)("sb", 4, 20, 2)("lw", 5, 20, 0)(
      "lw", 6, 20, 256)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.setWord(DataBegin, 0x01020304);
  S.setWord(DataBegin + 256, 0x0A0B0C0D);
  S.cycles();
  EXPECT_EQ(S.registerOf(0, 5), 0x01550304u);
  EXPECT_EQ(S.registerOf(0, 6), 0x0A0B0C0Du);
}

TEST(GlobalMemory, LoadOfOwnPendingAtomicWaitsForTheWindow) {
  // lui 0, atom_add 1, lw waits from 2 to 16 (14 lost to memory), addi waits
  // from 17 to 36 (19 lost), halt 37.
  Assembly A;
  A("lui", 20, DataHigh)("atom_add", 4, 20, 20)("lw", 5, 20, 0)("addi", 6, 5,
                                                                0)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.setWord(DataBegin, 5);
  EXPECT_EQ(S.cycles(), 38u);
  EXPECT_EQ(S.lost(0, Loss::Memory), 14u + 19u);
  EXPECT_EQ(S.statistics().DataStall[unsigned(Opcode::ATOM_ADD)], 14u);
  EXPECT_EQ(S.registerOf(0, 6), 5 + DataBegin);
}

TEST(GlobalMemory, StoreAfterOwnAtomicIsForwardedWithoutWaiting) {
  // lui 0, atom_add 1, sw 2, lw 3, halt 4.
  Assembly A;
  A("lui", 20, DataHigh)("atom_add", 4, 20, 20)("sw", 20, 20, 0)("lw", 5, 20,
                                                                 0)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  EXPECT_EQ(S.cycles(), 5u);
  EXPECT_EQ(S.registerOf(0, 5), DataBegin);
  EXPECT_EQ(S.word(DataBegin), DataBegin);
}

TEST(GlobalMemory, LoadElsewhereDoesNotWaitForAnAtomic) {
  // lui 0, atom_add 1, lw 2, halt 3; the second word shares the filter's bit.
  Assembly A;
  A("lui", 20, DataHigh)("atom_add", 4, 20, 20)("lw", 5, 20, 256)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  EXPECT_EQ(S.cycles(), 4u);
}

TEST(GlobalMemory, LocalStoresArePrivate) {
  // Each thread keeps its number at the same local address.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("addi", 20, 0, -64)("sw", 4, 20, 0)("barrier")(
      "lw", 5, 20, 0)("halt", 0);
  Simulation S(quietChip(2, 4), A);
  S.cycles();
  for (uint32_t T = 0; T != 8; ++T)
    EXPECT_EQ(S.registerOf(T, 5), T);
}

TEST(GlobalMemory, StreamsHandOutEachWordOnce) {
  // A ring of four words: thread t pushes t + 10, all in one cycle; the fifth
  // and sixth find it full. Then each pops one; two find it empty.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("lui", 20, DataHigh)("addi", 5, 4, 10)(
      "stream_push", 6, 5, 20)("barrier")("stream_pop", 7, 20)("halt", 0);
  Simulation S(quietChip(2, 3), A);
  S.setWord(DataBegin + 8, 4);
  S.cycles();
  // Window 0, in the order of priority, then TM: threads 0 3 1 4 2 5. The
  // pops in window 1, where TP 1 comes first: threads 1 4 2 5 0 3.
  const uint32_t Pushed[] = {1, 1, 0, 1, 1, 0};
  const uint32_t Popped[] = {0xFFFFFFFF, 10, 11, 0xFFFFFFFF, 13, 14};
  for (uint32_t T = 0; T != 6; ++T) {
    EXPECT_EQ(S.registerOf(T, 6), Pushed[T]) << T;
    EXPECT_EQ(S.registerOf(T, 7), Popped[T]) << T;
  }
  EXPECT_EQ(S.word(DataBegin), 4u);
  EXPECT_EQ(S.word(DataBegin + 4), 4u);
}

TEST(GlobalMemory, LoadAfterOwnStreamOperationWaitsForTheWindow) {
  // lui 0, push 1, lw of anything global waits from 2 to 16, halt 17.
  Assembly A;
  A("lui", 20, DataHigh)("stream_push", 6, 20, 20)("lw", 5, 20, 16)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.setWord(DataBegin + 8, 1);
  EXPECT_EQ(S.cycles(), 18u);
  EXPECT_EQ(S.registerOf(0, 5), DataBegin);
}

TEST(GlobalMemory, HostCallsWriteInOrderAndWaitForTheWindow) {
  // Each thread writes its letter from its local store in the same cycle of
  // window 0: in the order of priority, then TM. It is then overwritten: what
  // counts is the contents at the call.
  Assembly A;
  A("mfsr", 4, ThreadRegister)("addi", 7, 4, 'a')("addi", 5, 0, -64)(
      "sb", 7, 5, 0)("addi", 4, 0, 1)("addi", 6, 0, 1)("hostcall", 0)(
      "sb", 0, 5, 0)("halt", 0);
  Simulation S(quietChip(2, 3), A);
  // hostcall in 6, sb in 16, halt 17.
  EXPECT_EQ(S.cycles(), 18u);
  EXPECT_EQ(S.output(), "adbecf");
  EXPECT_EQ(S.registerOf(0, 2), 1u);
  EXPECT_EQ(S.lost(0, Loss::Sync), 9u);
}

} // namespace
