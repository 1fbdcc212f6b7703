//===- Integer128Test.cpp - 128-bit integers against the host's -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "test/unit/runtime/EdgeValues.h"
#include "gtest/gtest.h"
#include <cmath>

using Unsigned = unsigned __int128;
using Signed = __int128;
using tp::wide::Integer128;

constexpr int RandomPairs = 1'000'000;

static uint64_t low(Unsigned A) { return static_cast<uint64_t>(A); }
static uint64_t high(Unsigned A) { return static_cast<uint64_t>(A >> 64); }
static Unsigned make(uint64_t High, uint64_t Low) {
  return static_cast<Unsigned>(High) << 64 | Low;
}
static Unsigned join(Integer128 A) { return make(A.High, A.Low); }
static Unsigned bits(Signed A) { return static_cast<Unsigned>(A); }

/// As one function of two numbers, which come in halves.
template <typename Function, typename... Rest>
static Unsigned call(Function Callee, Unsigned A, Unsigned B, Rest... Others) {
  return join(Callee(low(A), high(A), low(B), high(B), Others...));
}

static void checkPair(Unsigned A, Unsigned B) {
  auto SA = static_cast<Signed>(A), SB = static_cast<Signed>(B);
  ASSERT_TRUE(call(tpSoft___multi3, A, B) == A * B);
  Signed Product;
  int Overflow;
  bool HostOverflow = __builtin_mul_overflow(SA, SB, &Product);
  ASSERT_TRUE(call(tpSoft___muloti4, A, B, &Overflow) == bits(Product));
  ASSERT_EQ(Overflow != 0, HostOverflow)
      << high(A) << ':' << low(A) << " * " << high(B) << ':' << low(B);
  if (B == 0)
    return;
  Integer128 Remainder;
  ASSERT_TRUE(call(tpSoft___udivti3, A, B) == A / B)
      << high(A) << ':' << low(A) << " / " << high(B) << ':' << low(B);
  ASSERT_TRUE(call(tpSoft___umodti3, A, B) == A % B);
  ASSERT_TRUE(call(tpSoft___udivmodti4, A, B, &Remainder) == A / B);
  ASSERT_TRUE(join(Remainder) == A % B);
  if (A == Unsigned(1) << 127 && SB == -1) {
    ASSERT_TRUE(call(tpSoft___divti3, A, B) == A);
    ASSERT_TRUE(call(tpSoft___modti3, A, B) == 0);
    return;
  }
  ASSERT_TRUE(call(tpSoft___divti3, A, B) == bits(SA / SB));
  ASSERT_TRUE(call(tpSoft___modti3, A, B) == bits(SA % SB));
  ASSERT_TRUE(call(tpSoft___divmodti4, A, B, &Remainder) == bits(SA / SB));
  ASSERT_TRUE(join(Remainder) == bits(SA % SB));
}

static void checkOne(Unsigned A) {
  auto S = static_cast<Signed>(A);
  uint64_t Low = low(A), High = high(A);
  for (int Shift = 0; Shift != 128; ++Shift) {
    ASSERT_TRUE(join(tpSoft___ashlti3(Low, High, Shift)) == A << Shift);
    ASSERT_TRUE(join(tpSoft___lshrti3(Low, High, Shift)) == A >> Shift);
    ASSERT_TRUE(join(tpSoft___ashrti3(Low, High, Shift)) == bits(S >> Shift));
  }
  ASSERT_EQ(tpSoft___floattidf(Low, High), static_cast<double>(S));
  ASSERT_EQ(tpSoft___floatuntidf(Low, High), static_cast<double>(A));
  ASSERT_EQ(tpSoft___floattisf(Low, High), static_cast<float>(S));
  ASSERT_EQ(tpSoft___floatuntisf(Low, High), static_cast<float>(A));
}

static std::vector<Unsigned> edges() {
  const uint64_t Halves[] = {0,
                             1,
                             2,
                             3,
                             10,
                             0x7FFFFFFF,
                             0x80000000,
                             0xFFFFFFFF,
                             0x100000000,
                             0x7FFFFFFFFFFFFFFF,
                             0x8000000000000000,
                             0x8000000000000001,
                             0x8000000080000000,
                             0xFFFFFFFEFFFFFFFF,
                             0xFFFFFFFF00000000,
                             0xFFFFFFFFFFFFFFFF,
                             0xFFFFFFFFFFFFFC00,
                             0xFFFFFFFFFFFFF7FF,
                             0x0000008000000000,
                             0x123456789ABCDEF0};
  std::vector<Unsigned> Values;
  for (uint64_t High : Halves)
    for (uint64_t Low : Halves)
      Values.push_back(make(High, Low));
  return Values;
}

TEST(Integer128, EdgePairs) {
  std::vector<Unsigned> Values = edges();
  for (Unsigned A : Values) {
    checkOne(A);
    for (Unsigned B : Values) {
      checkPair(A, B);
      if (HasFatalFailure())
        return;
    }
  }
}

TEST(Integer128, RandomPairs) {
  tp::test::RandomDoubles Random;
  auto Next = [&] {
    Unsigned Value = make(Random.integer(), Random.integer());
    return Value >> (Random.integer() % 128);
  };
  for (int I = 0; I != RandomPairs && !HasFatalFailure(); ++I)
    checkPair(Next(), Next());
}

template <typename Integer> static Integer saturate(double Value) {
  constexpr Integer Max = static_cast<Integer>(
      ~Unsigned(0) >> (static_cast<Integer>(-1) < 0 ? 1 : 0));
  constexpr Integer Min = static_cast<Integer>(-1) < 0 ? -Max - 1 : 0;
  if (std::isnan(Value))
    return 0;
  if (Value >= static_cast<double>(Max))
    return Max;
  if (Value <= static_cast<double>(Min))
    return Min;
  return static_cast<Integer>(Value);
}

static void checkDouble(double Value) {
  ASSERT_TRUE(join(tpSoft___fixdfti(Value)) == bits(saturate<Signed>(Value)))
      << Value;
  ASSERT_TRUE(join(tpSoft___fixunsdfti(Value)) == saturate<Unsigned>(Value))
      << Value;
  auto Float = static_cast<float>(Value);
  ASSERT_TRUE(join(tpSoft___fixsfti(Float)) == bits(saturate<Signed>(Float)))
      << Float;
  ASSERT_TRUE(join(tpSoft___fixunssfti(Float)) == saturate<Unsigned>(Float))
      << Float;
}

TEST(Integer128, FromFloatingPoint) {
  for (double Value : tp::test::edgeDoubles())
    checkDouble(Value);
  for (int Exponent = -3; Exponent != 131; ++Exponent)
    for (double Sign : {1.0, -1.0})
      for (double Toward : {0.0, 1.0, 4.0})
        checkDouble(std::ldexp(std::nextafter(Sign, Sign * Toward), Exponent));
}

TEST(BrainFloat, Rounds) {
  // The nearest of the two neighbours, by exact arithmetic.
  auto Expected = [](double Value) -> uint16_t {
    uint16_t Sign = std::signbit(Value) ? 0x8000 : 0;
    double Magnitude = std::fabs(Value);
    uint16_t Below = 0;
    auto ToDouble = [](uint16_t Bits) -> double {
      if (Bits == 0x7F80)
        return 0x1p128;
      return std::bit_cast<float>(static_cast<uint32_t>(Bits) << 16);
    };
    for (uint16_t Step = 0x4000; Step != 0; Step >>= 1)
      if (Below + Step <= 0x7F80 &&
          ToDouble(static_cast<uint16_t>(Below + Step)) <= Magnitude)
        Below = static_cast<uint16_t>(Below + Step);
    if (Below == 0x7F80)
      return Sign | Below;
    double Lower = Magnitude - ToDouble(Below);
    double Upper = ToDouble(Below + 1) - Magnitude;
    bool Up = Lower > Upper || (Lower == Upper && (Below & 1));
    return static_cast<uint16_t>(Sign | (Below + Up));
  };
  auto Check = [&](double Value) {
    if (std::isnan(Value))
      return;
    EXPECT_EQ(tpSoft___truncdfbf2(Value), Expected(Value)) << Value;
    auto Float = static_cast<float>(Value);
    EXPECT_EQ(tpSoft___truncsfbf2(Float), Expected(Float)) << Float;
  };
  for (double Value : tp::test::edgeDoubles())
    Check(Value);
  tp::test::RandomDoubles Random;
  for (int I = 0; I != 200'000; ++I)
    Check(std::ldexp(1.0 + static_cast<double>(Random.integer()) * 0x1p-64,
                     static_cast<int>(Random.integer() % 300) - 160));
  // Halfway between neighbours, and as little as a double can say off it.
  for (uint32_t Bits = 0; Bits < 0x7F80; Bits += 7) {
    double Tie = std::bit_cast<float>((Bits << 16) + 0x8000);
    for (double Value :
         {Tie, std::nextafter(Tie, 0.0), std::nextafter(Tie, 1e300)}) {
      Check(Value);
      Check(-Value);
    }
  }
  EXPECT_EQ(tpSoft___truncsfbf2(std::nanf("")) & 0x7FC0, 0x7FC0);
  EXPECT_EQ(tpSoft___truncdfbf2(-std::nan("")) & 0x7FC0, 0x7FC0);
}
