//===- SoftDoubleTest.cpp - Software doubles against the host's -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "test/unit/runtime/EdgeValues.h"
#include "gtest/gtest.h"
#include <cmath>
#include <limits>

constexpr int RandomPairs = 2'000'000;

static uint64_t bitsOf(double Value) {
  return std::isnan(Value) ? 0x7FF8000000000000
                           : std::bit_cast<uint64_t>(Value);
}

static uint32_t bitsOf(float Value) {
  return std::isnan(Value) ? 0x7FC00000 : std::bit_cast<uint32_t>(Value);
}

static int signOf(int Value) { return (Value > 0) - (Value < 0); }

/// Ours must be these very bits: NaN is canonical.
#define EXPECT_SAME(Ours, Host, ...)                                           \
  do {                                                                         \
    if (std::bit_cast<decltype(bitsOf(Host))>(Ours) != bitsOf(Host))           \
      FAIL() << std::hexfloat << "ours " << (Ours) << " host " << (Host)       \
             << " for " << __VA_ARGS__;                                        \
  } while (false)

static void checkPair(double A, double B) {
  EXPECT_SAME(tpSoft___adddf3(A, B), A + B, A << " + " << B);
  EXPECT_SAME(tpSoft___subdf3(A, B), A - B, A << " - " << B);
  EXPECT_SAME(tpSoft___muldf3(A, B), A * B, A << " * " << B);
  EXPECT_SAME(tpSoft___divdf3(A, B), A / B, A << " / " << B);
  bool Unordered = std::isunordered(A, B);
  int Order = A < B ? -1 : A > B ? 1 : 0;
  int Less = Unordered ? 1 : Order, Greater = Unordered ? -1 : Order;
  if (signOf(tpSoft___ltdf2(A, B)) != Less ||
      signOf(tpSoft___ledf2(A, B)) != Less ||
      signOf(tpSoft___gtdf2(A, B)) != Greater ||
      signOf(tpSoft___gedf2(A, B)) != Greater ||
      (tpSoft___eqdf2(A, B) == 0) != (A == B) ||
      (tpSoft___nedf2(A, B) != 0) != (A != B) ||
      (tpSoft___unorddf2(A, B) != 0) != Unordered)
    FAIL() << std::hexfloat << "compare " << A << " with " << B;
}

static void checkTriple(double A, double B, double C) {
  EXPECT_SAME(tpSoft___tp_fmadf(A, B, C), std::fma(A, B, C),
              A << " * " << B << " + " << C);
}

template <typename Integer> static Integer saturate(double Value) {
  using Limits = std::numeric_limits<Integer>;
  if (std::isnan(Value))
    return 0;
  if (Value <= static_cast<double>(Limits::min()))
    return Limits::min();
  if (Value >= static_cast<double>(Limits::max()))
    return Limits::max();
  return static_cast<Integer>(Value);
}

static void checkOne(double A) {
  EXPECT_SAME(tpSoft___tp_sqrtdf(A), std::sqrt(A), "sqrt " << A);
  float F = static_cast<float>(A);
  EXPECT_SAME(tpSoft___truncdfsf2(A), F, "float " << A);
  EXPECT_SAME(tpSoft___extendsfdf2(F), static_cast<double>(F), "double " << F);
  ASSERT_EQ(std::bit_cast<uint64_t>(tpSoft___negdf2(A)),
            std::bit_cast<uint64_t>(A) ^ 1ull << 63);
  ASSERT_EQ(tpSoft___fixdfsi(A), saturate<int32_t>(A)) << A;
  ASSERT_EQ(tpSoft___fixunsdfsi(A), saturate<uint32_t>(A)) << A;
  ASSERT_EQ(tpSoft___fixdfdi(A), saturate<int64_t>(A)) << A;
  ASSERT_EQ(tpSoft___fixunsdfdi(A), saturate<uint64_t>(A)) << A;
  ASSERT_EQ(tpSoft___fixsfdi(F), saturate<int64_t>(F)) << F;
  ASSERT_EQ(tpSoft___fixunssfdi(F), saturate<uint64_t>(F)) << F;
}

static void checkInteger(uint64_t A) {
  int64_t S = static_cast<int64_t>(A);
  int32_t S32 = static_cast<int32_t>(A);
  uint32_t U32 = static_cast<uint32_t>(A);
  EXPECT_SAME(tpSoft___floatsidf(S32), static_cast<double>(S32), S32);
  EXPECT_SAME(tpSoft___floatunsidf(U32), static_cast<double>(U32), U32);
  EXPECT_SAME(tpSoft___floatdidf(S), static_cast<double>(S), S);
  EXPECT_SAME(tpSoft___floatundidf(A), static_cast<double>(A), A);
  EXPECT_SAME(tpSoft___floatdisf(S), static_cast<float>(S), S);
  EXPECT_SAME(tpSoft___floatundisf(A), static_cast<float>(A), A);
}

TEST(SoftDouble, EdgePairs) {
  for (double A : tp::test::edgeDoubles())
    for (double B : tp::test::edgeDoubles()) {
      checkPair(A, B);
      if (HasFatalFailure())
        return;
    }
}

TEST(SoftDouble, RandomPairs) {
  tp::test::RandomDoubles Random;
  for (int I = 0; I != RandomPairs && !HasFatalFailure(); ++I) {
    double A = Random.next();
    checkPair(A, Random.near(A));
  }
}

TEST(SoftDouble, FusedMultiplyAddEdges) {
  for (double A : tp::test::edgeDoubles())
    for (double B : tp::test::edgeDoubles())
      for (double C : tp::test::edgeDoubles()) {
        checkTriple(A, B, C);
        if (HasFatalFailure())
          return;
      }
}

TEST(SoftDouble, FusedMultiplyAddRandom) {
  tp::test::RandomDoubles Random;
  for (int I = 0; I != RandomPairs && !HasFatalFailure(); ++I) {
    double A = Random.next(), B = Random.near(1.0);
    checkTriple(A, B, Random.near(A * B));
  }
}

TEST(SoftDouble, RootsAndConversions) {
  for (double A : tp::test::edgeDoubles()) {
    checkOne(A);
    if (HasFatalFailure())
      return;
  }
  tp::test::RandomDoubles Random;
  for (int I = 0; I != RandomPairs && !HasFatalFailure(); ++I) {
    checkOne(Random.next());
    checkOne(Random.near(65536.0));
  }
}

TEST(SoftDouble, FromIntegers) {
  for (uint64_t A : tp::test::edgeIntegers()) {
    checkInteger(A);
    if (HasFatalFailure())
      return;
  }
  tp::test::RandomDoubles Random;
  for (int I = 0; I != RandomPairs && !HasFatalFailure(); ++I)
    checkInteger(Random.integer());
}
