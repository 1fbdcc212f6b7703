//===- HalfConvertTest.cpp - Half-precision floats against the host's -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

bool isHalfNaN(uint16_t Half) { return (Half & 0x7FFF) > 0x7C00; }

// The host's conversion, by its own compiler.
template <typename T> uint16_t hostHalf(T Value) {
  return std::bit_cast<uint16_t>(static_cast<_Float16>(Value));
}

TEST(HalfConvert, EveryHalfExtends) {
  for (uint32_t Bits = 0; Bits != 0x10000; ++Bits) {
    float Ours = tpSoft___extendhfsf2(static_cast<uint16_t>(Bits));
    auto Host = static_cast<float>(
        std::bit_cast<_Float16>(static_cast<uint16_t>(Bits)));
    if (std::isnan(Host))
      EXPECT_TRUE(std::isnan(Ours)) << Bits;
    else
      EXPECT_EQ(std::bit_cast<uint32_t>(Ours), std::bit_cast<uint32_t>(Host))
          << Bits;
  }
}

TEST(HalfConvert, FloatsRound) {
  for (uint64_t Bits = 0; Bits < 0x100000000; Bits += 997) {
    float Value = std::bit_cast<float>(static_cast<uint32_t>(Bits));
    uint16_t Ours = tpSoft___truncsfhf2(Value);
    if (std::isnan(Value))
      ASSERT_TRUE(isHalfNaN(Ours)) << Bits;
    else
      ASSERT_EQ(Ours, hostHalf(Value)) << Bits;
  }
}

// Every half, the ties between neighbours, and the doubles next to both.
TEST(HalfConvert, DoublesRoundAtTies) {
  for (uint16_t Bits = 0; Bits != 0x7C00; ++Bits) {
    double Here = tpSoft___extendhfsf2(Bits);
    double Above = Bits == 0x7BFF ? 65536.0 : tpSoft___extendhfsf2(Bits + 1);
    for (double Value : {Here, (Here + Above) / 2})
      for (double Near :
           {std::nextafter(Value, -1.0), Value, std::nextafter(Value, 1e9)})
        for (double Signed : {Near, -Near})
          ASSERT_EQ(tpSoft___truncdfhf2(Signed), hostHalf(Signed)) << Signed;
  }
}

TEST(HalfConvert, RandomDoublesRound) {
  std::mt19937_64 Random(1);
  for (int I = 0; I != 1000000; ++I) {
    auto Value = std::bit_cast<double>(Random());
    uint16_t Ours = tpSoft___truncdfhf2(Value);
    if (std::isnan(Value))
      ASSERT_TRUE(isHalfNaN(Ours));
    else
      ASSERT_EQ(Ours, hostHalf(Value)) << Value;
  }
}

} // namespace
