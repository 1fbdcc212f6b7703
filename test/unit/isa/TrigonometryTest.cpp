//===- TrigonometryTest.cpp - sin_s and cos_s over the floats -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/isa/Trigonometry.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>

using namespace tp;

namespace {

/// Distance in units of the last place of the float nearest to the truth.
long double ulpError(float Actual, long double Truth) {
  float Near = std::fabs(float(Truth));
  long double Ulp = std::nextafter(Near, 2.0f) - Near;
  return std::fabs(Actual - Truth) / Ulp;
}

TEST(Trigonometry, IsWithinOneUlpEverywhere) {
  // Every 997th float, from the subnormals to the largest.
  long double WorstSine = 0, WorstCosine = 0;
  for (uint64_t Bits = 1; Bits < 0x7F800000; Bits += 997) {
    float X = std::bit_cast<float>(uint32_t(Bits));
    long double Wide = X;
    WorstSine = std::max(WorstSine, ulpError(sine(X), std::sin(Wide)));
    WorstCosine = std::max(WorstCosine, ulpError(cosine(X), std::cos(Wide)));
  }
  EXPECT_LT(WorstSine, 0.51L);
  EXPECT_LT(WorstCosine, 0.51L);
}

TEST(Trigonometry, HardArgumentsAreReducedExactly) {
  // 16367173 * 2^72 is the float nearest to a multiple of pi/2.
  float X = std::ldexp(16367173.0f, 72);
  EXPECT_LT(ulpError(cosine(X), std::cos((long double)X)), 0.51L);
  EXPECT_LT(ulpError(sine(X), std::sin((long double)X)), 0.51L);
}

TEST(Trigonometry, IsOddAndEven) {
  for (float X : {0.0f, 1e-40f, 0.5f, 2.0f, 100.0f, 1e30f}) {
    EXPECT_EQ(std::bit_cast<uint32_t>(sine(-X)),
              std::bit_cast<uint32_t>(-sine(X)));
    EXPECT_EQ(cosine(-X), cosine(X));
  }
}

} // namespace
