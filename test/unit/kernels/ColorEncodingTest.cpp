//===- ColorEncodingTest.cpp - The sRGB curve and pixels ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/ColorEncoding.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace tp;

TEST(ColorEncoding, IsCloseToSrgb) {
  double WorstError = 0;
  for (int I = 0; I <= 100000; ++I) {
    const double Linear = I / 100000.0;
    const double Exact = Linear <= 0.0031308
                             ? 12.92 * Linear
                             : 1.055 * std::pow(Linear, 1 / 2.4) - 0.055;
    const double Error = std::abs(encodeSrgb(float(Linear)) - Exact);
    WorstError = std::max(WorstError, Error);
  }
  EXPECT_LT(WorstError, 0.0004);
}

TEST(ColorEncoding, NeverDecreases) {
  uint32_t Last = 0;
  for (int I = 0; I <= 1000000; ++I) {
    const uint32_t Channel = encodeChannel(float(I) * 1e-6f);
    ASSERT_GE(Channel, Last);
    ASSERT_LE(Channel, Last + 1) << "no value is left out";
    Last = Channel;
  }
  EXPECT_EQ(Last, 255u);
}

TEST(ColorEncoding, ClampsEverything) {
  EXPECT_EQ(encodeChannel(0), 0u);
  EXPECT_EQ(encodeChannel(-1), 0u);
  EXPECT_EQ(encodeChannel(17), 255u);
  EXPECT_EQ(encodeChannel(std::numeric_limits<float>::infinity()), 255u);
  EXPECT_EQ(encodeChannel(-std::numeric_limits<float>::infinity()), 0u);
  EXPECT_EQ(encodeChannel(std::numeric_limits<float>::quiet_NaN()), 0u);
}

TEST(ColorEncoding, PixelsHaveRedLowestAndAreOpaque) {
  EXPECT_EQ(encodePixel({1, 0, 0}), 0xFF0000FFu);
  EXPECT_EQ(encodePixel({0, 1, 0}), 0xFF00FF00u);
  EXPECT_EQ(encodePixel({0, 0, 1}), 0xFFFF0000u);
}
