//===- VectorClockTest.cpp - What a thread knows of the others ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/VectorClock.h"

#include "gtest/gtest.h"

#include <random>

using namespace tp;

namespace {

TEST(VectorClock, IsZeroAtFirst) {
  VectorClock C;
  EXPECT_EQ(C.of(0), 0u);
  EXPECT_EQ(C.of(1000000), 0u);
}

TEST(VectorClock, NeverFalls) {
  VectorClock C;
  C.raise(70, 5);
  C.raise(70, 3);
  EXPECT_EQ(C.of(70), 5u);
  EXPECT_EQ(C.of(71), 0u);
}

TEST(VectorClock, CopiesAreIndependent) {
  VectorClock A;
  A.raise(1, 4);
  VectorClock B = A;
  B.raise(2, 6);
  A.raise(1, 9);
  EXPECT_EQ(A.of(1), 9u);
  EXPECT_EQ(A.of(2), 0u);
  EXPECT_EQ(B.of(1), 4u);
  EXPECT_EQ(B.of(2), 6u);
}

TEST(VectorClock, CopiesAndJoinsShareChunks) {
  const size_t Before = VectorClock::chunks();
  VectorClock A;
  for (uint32_t Thread = 0; Thread != 4096; ++Thread)
    A.raise(Thread, Thread + 1);
  std::vector<VectorClock> Knowing(1000, A);
  VectorClock Later;
  Later.raise(17, 3);
  Later.join(A);
  EXPECT_EQ(Later.of(4095), 4096u);
  EXPECT_EQ(VectorClock::chunks() - Before, 4096 / VectorClock::ChunkThreads);
}

TEST(VectorClock, JoinIsTheMaximum) {
  std::mt19937 Random(1);
  for (int Round = 0; Round != 200; ++Round) {
    std::array<std::array<Clock, 150>, 2> Expected{};
    std::array<VectorClock, 2> Clocks;
    for (int Step = 0; Step != 100; ++Step) {
      const unsigned Which = Random() % 2;
      if (Random() % 16 == 0) {
        Clocks[Which].join(Clocks[1 - Which]);
        for (size_t I = 0; I != 150; ++I)
          Expected[Which][I] =
              std::max(Expected[Which][I], Expected[1 - Which][I]);
        continue;
      }
      const uint32_t Thread = Random() % 150;
      const Clock To = Random() % 50;
      Clocks[Which].raise(Thread, To);
      Expected[Which][Thread] = std::max(Expected[Which][Thread], To);
    }
    for (unsigned Which = 0; Which != 2; ++Which)
      for (uint32_t I = 0; I != 150; ++I)
        ASSERT_EQ(Clocks[Which].of(I), Expected[Which][I]);
  }
}

} // namespace
