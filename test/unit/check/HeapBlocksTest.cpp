//===- HeapBlocksTest.cpp - What the program has allocated ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/HeapBlocks.h"

#include "gtest/gtest.h"

using namespace tp;

static HeapBlock block(uint32_t Begin, uint32_t Bytes) {
  return {Begin, Bytes, {}, std::nullopt};
}

TEST(HeapBlocks, NearestIsTheBlockThatHoldsTheAddressOrTheCloserOne) {
  HeapBlocks Blocks;
  EXPECT_EQ(Blocks.nearest(100), nullptr);
  Blocks.add(block(100, 40));
  Blocks.add(block(200, 8));
  EXPECT_EQ(Blocks.nearest(0)->Begin, 100u);
  EXPECT_EQ(Blocks.nearest(139)->Begin, 100u);
  EXPECT_EQ(Blocks.nearest(170)->Begin, 100u);
  EXPECT_EQ(Blocks.nearest(171)->Begin, 200u);
  EXPECT_EQ(Blocks.nearest(1000)->Begin, 200u);
}

TEST(HeapBlocks, MemoryGivenAnewForgetsWhatItWas) {
  HeapBlocks Blocks;
  for (uint32_t Begin : {100, 120, 140, 160})
    Blocks.add(block(Begin, 20));
  // Takes the end of the first, all of the second, the start of the third.
  Blocks.add(block(110, 35));
  EXPECT_EQ(Blocks.at(100), nullptr);
  EXPECT_EQ(Blocks.at(120), nullptr);
  EXPECT_EQ(Blocks.at(140), nullptr);
  ASSERT_NE(Blocks.at(160), nullptr);
  ASSERT_NE(Blocks.at(110), nullptr);
  EXPECT_EQ(Blocks.at(110)->Bytes, 35u);
}

TEST(HeapBlocks, NeighboursAndEmptyBlocksStay) {
  HeapBlocks Blocks;
  Blocks.add(block(100, 20));
  Blocks.add(block(140, 20));
  Blocks.add(block(120, 20));
  Blocks.add(block(200, 0));
  Blocks.add(block(160, 40));
  for (uint32_t Begin : {100, 120, 140, 160, 200})
    EXPECT_NE(Blocks.at(Begin), nullptr) << Begin;
  Blocks.add(block(200, 8));
  EXPECT_EQ(Blocks.at(200)->Bytes, 8u);
}

TEST(HeapBlocks, Describe) {
  HeapBlock Block = block(100, 40);
  EXPECT_EQ(Block.describe(100), "at the start of a heap block of 40 bytes");
  EXPECT_EQ(Block.describe(101), "1 byte into a heap block of 40 bytes");
  EXPECT_EQ(Block.describe(140), "right behind a heap block of 40 bytes");
  EXPECT_EQ(Block.describe(142), "2 bytes behind a heap block of 40 bytes");
  Block.FreedAt = CodePlace();
  EXPECT_EQ(Block.describe(96),
            "4 bytes before a heap block of 40 bytes that was given back");
}
