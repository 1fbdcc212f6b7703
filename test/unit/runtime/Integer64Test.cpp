//===- Integer64Test.cpp - 64-bit integer functions against the host's ----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "test/unit/runtime/EdgeValues.h"
#include "gtest/gtest.h"

constexpr int RandomPairs = 2'000'000;

static void checkPair(uint64_t A, uint64_t B) {
  int64_t SA = static_cast<int64_t>(A), SB = static_cast<int64_t>(B);
  ASSERT_EQ(static_cast<uint64_t>(tpSoft___muldi3(SA, SB)), A * B);
  int64_t Product;
  int Overflow;
  bool HostOverflow = __builtin_mul_overflow(SA, SB, &Product);
  ASSERT_EQ(tpSoft___mulodi4(SA, SB, &Overflow), Product);
  ASSERT_EQ(Overflow != 0, HostOverflow) << SA << " * " << SB;
  ASSERT_EQ(tpSoft___cmpdi2(SA, SB), SA < SB ? 0 : SA == SB ? 1 : 2);
  ASSERT_EQ(tpSoft___ucmpdi2(A, B), A < B ? 0 : A == B ? 1 : 2);
  if (B == 0)
    return;
  uint64_t Remainder;
  ASSERT_EQ(tpSoft___udivdi3(A, B), A / B) << A << " / " << B;
  ASSERT_EQ(tpSoft___umoddi3(A, B), A % B) << A << " % " << B;
  ASSERT_EQ(tpSoft___udivmoddi4(A, B, &Remainder), A / B);
  ASSERT_EQ(Remainder, A % B);
  if (SA == INT64_MIN && SB == -1) {
    ASSERT_EQ(tpSoft___divdi3(SA, SB), INT64_MIN);
    ASSERT_EQ(tpSoft___moddi3(SA, SB), 0);
    return;
  }
  int64_t SignedRemainder;
  ASSERT_EQ(tpSoft___divdi3(SA, SB), SA / SB) << SA << " / " << SB;
  ASSERT_EQ(tpSoft___moddi3(SA, SB), SA % SB) << SA << " % " << SB;
  ASSERT_EQ(tpSoft___divmoddi4(SA, SB, &SignedRemainder), SA / SB);
  ASSERT_EQ(SignedRemainder, SA % SB);
}

static void checkOne(uint64_t A) {
  int64_t S = static_cast<int64_t>(A);
  uint32_t Low = static_cast<uint32_t>(A);
  for (int Shift = 0; Shift != 64; ++Shift) {
    ASSERT_EQ(static_cast<uint64_t>(tpSoft___ashldi3(S, Shift)), A << Shift);
    ASSERT_EQ(static_cast<uint64_t>(tpSoft___lshrdi3(S, Shift)), A >> Shift);
    ASSERT_EQ(tpSoft___ashrdi3(S, Shift), S >> Shift);
  }
  ASSERT_EQ(tpSoft___popcountsi2(Low), __builtin_popcount(Low));
  ASSERT_EQ(tpSoft___popcountdi2(A), __builtin_popcountll(A));
  ASSERT_EQ(tpSoft___paritysi2(Low), __builtin_parity(Low));
  ASSERT_EQ(tpSoft___paritydi2(A), __builtin_parityll(A));
  ASSERT_EQ(tpSoft___ffssi2(Low), __builtin_ffs(static_cast<int>(Low)));
  ASSERT_EQ(tpSoft___ffsdi2(A), __builtin_ffsll(S));
  ASSERT_EQ(tpSoft___bswapsi2(Low), __builtin_bswap32(Low));
  ASSERT_EQ(tpSoft___bswapdi2(A), __builtin_bswap64(A));
  if (Low != 0) {
    ASSERT_EQ(tpSoft___clzsi2(Low), __builtin_clz(Low));
    ASSERT_EQ(tpSoft___ctzsi2(Low), __builtin_ctz(Low));
  }
  if (A != 0) {
    ASSERT_EQ(tpSoft___clzdi2(A), __builtin_clzll(A));
    ASSERT_EQ(tpSoft___ctzdi2(A), __builtin_ctzll(A));
  }
}

TEST(Integer64, EdgePairs) {
  std::vector<uint64_t> Values = tp::test::edgeIntegers();
  for (uint64_t A : Values) {
    checkOne(A);
    for (uint64_t B : Values) {
      checkPair(A, B);
      if (HasFatalFailure())
        return;
    }
  }
}

TEST(Integer64, RandomPairs) {
  tp::test::RandomDoubles Random;
  for (int I = 0; I != RandomPairs && !HasFatalFailure(); ++I)
    checkPair(Random.integer(), Random.integer());
}
