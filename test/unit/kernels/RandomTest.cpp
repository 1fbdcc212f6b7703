//===- RandomTest.cpp - Uniformity and independence -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/Random.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

using namespace tp;

/// The published algorithm, written as published, on the four inputs.
static RandomWords pcg4d(uint32_t X, uint32_t Y, uint32_t Z, uint32_t W) {
  uint32_t V[4] = {X, Y, Z, W};
  for (uint32_t &Word : V)
    Word = Word * 1664525u + 1013904223u;
  auto Mix = [&] {
    V[0] += V[1] * V[3];
    V[1] += V[2] * V[0];
    V[2] += V[0] * V[1];
    V[3] += V[1] * V[2];
  };
  Mix();
  for (uint32_t &Word : V)
    Word ^= Word >> 16;
  Mix();
  return {V[0], V[1], V[2], V[3]};
}

TEST(Random, IsThePublishedHash) {
  for (uint32_t I = 0; I != 1000; ++I) {
    const RandomWords Ours = randomWords(I, I * 3, I * 7919, ~I);
    const RandomWords Published = pcg4d(I, I * 3, I * 7919, ~I);
    EXPECT_EQ(Ours.X, Published.X);
    EXPECT_EQ(Ours.Y, Published.Y);
    EXPECT_EQ(Ours.Z, Published.Z);
    EXPECT_EQ(Ours.W, Published.W);
  }
}

TEST(Random, UnitFloatCoversItsRange) {
  EXPECT_EQ(unitFloat(0), 0.0f);
  EXPECT_EQ(unitFloat(0x80000000), 0.5f);
  EXPECT_EQ(unitFloat(0xFFFFFFFF), 1.0f - 0x1p-24f);
}

/// Chi-squared of \p Counts against equal shares, in standard deviations from
/// its mean.
static double deviation(const std::vector<uint32_t> &Counts) {
  double Total = 0;
  for (uint32_t Count : Counts)
    Total += Count;
  const double Expected = Total / double(Counts.size());
  double ChiSquared = 0;
  for (uint32_t Count : Counts)
    ChiSquared += (Count - Expected) * (Count - Expected) / Expected;
  const double Freedom = double(Counts.size()) - 1;
  return (ChiSquared - Freedom) / std::sqrt(2 * Freedom);
}

TEST(Random, WordsAreUniformOverPixelsSamplesAndDimensions) {
  std::vector<uint32_t> Single[4], Pairs(1024);
  for (auto &Counts : Single)
    Counts.resize(256);
  for (uint32_t Pixel = 0; Pixel != 4096; ++Pixel)
    for (uint32_t Sample = 0; Sample != 16; ++Sample)
      for (uint32_t Dimension = 0; Dimension != 4; ++Dimension) {
        const RandomWords R = randomWords(Pixel, Sample, Dimension, 1);
        ++Single[0][R.X >> 24];
        ++Single[1][R.Y >> 24];
        ++Single[2][R.Z >> 24];
        ++Single[3][R.W >> 24];
        ++Pairs[R.X >> 27 << 5 | R.Y >> 27];
      }
  for (const auto &Counts : Single)
    EXPECT_LT(std::abs(deviation(Counts)), 5);
  EXPECT_LT(std::abs(deviation(Pairs)), 5);
}

/// Flipping one bit of an input should flip half of the upper bits, which are
/// what the floats are made of.
TEST(Random, EveryInputBitMatters) {
  uint32_t Flipped = 0, Compared = 0;
  for (uint32_t Pixel = 0; Pixel != 500; ++Pixel)
    for (unsigned Bit = 0; Bit != 16; ++Bit) {
      const RandomWords A = randomWords(Pixel, 3, 2, 1);
      const RandomWords Others[] = {randomWords(Pixel ^ 1u << Bit, 3, 2, 1),
                                    randomWords(Pixel, 3 ^ 1u << Bit, 2, 1),
                                    randomWords(Pixel, 3, 2 ^ 1u << Bit, 1),
                                    randomWords(Pixel, 3, 2, 1 ^ 1u << Bit)};
      for (const RandomWords &B : Others) {
        Flipped +=
            std::popcount((A.X ^ B.X) >> 16) + std::popcount((A.Y ^ B.Y) >> 16);
        Compared += 32;
      }
    }
  EXPECT_NEAR(double(Flipped) / Compared, 0.5, 0.01);
}

TEST(Random, NeighbouringPixelsAreUncorrelated) {
  double Sum = 0;
  constexpr uint32_t Count = 1 << 16;
  for (uint32_t Pixel = 0; Pixel != Count; ++Pixel)
    Sum += (unitFloat(randomWords(Pixel, 0, 0, 1).X) - 0.5) *
           (unitFloat(randomWords(Pixel + 1, 0, 0, 1).X) - 0.5);
  // The product of two independent ones has variance 1 / 144.
  EXPECT_LT(std::abs(Sum / Count), 5.0 / 12 / std::sqrt(Count));
}

TEST(Random, ChoiceIsUniformAndLeavesARandomRemainder) {
  std::vector<uint32_t> Indices(7), Remainders(16);
  for (uint32_t I = 0; I != 70000; ++I) {
    const RandomChoice Choice = chooseIndex(randomWords(I, 0, 0, 1).X, 7);
    ASSERT_LT(Choice.Index, 7u);
    ++Indices[Choice.Index];
    ++Remainders[Choice.Remainder >> 28];
  }
  EXPECT_LT(std::abs(deviation(Indices)), 5);
  EXPECT_LT(std::abs(deviation(Remainders)), 5);
  EXPECT_EQ(chooseIndex(0xFFFFFFFF, 7).Index, 6u);
}
