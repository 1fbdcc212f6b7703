//===- MathTest.cpp - Errors of tp/math.h against double ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// TP_MATH_STRIDE=1 in the environment walks over every float instead of every
// 251st (minutes instead of seconds).
//
//===----------------------------------------------------------------------===//

#include "tp/math.h"
#include "gtest/gtest.h"
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Smallest = std::numeric_limits<float>::denorm_min();

static float fromBits(uint32_t Bits) { return std::bit_cast<float>(Bits); }

/// Distance of \p Value from \p Exact in units of a float's last place there.
static double ulpError(float Value, double Exact) {
  if (std::isnan(Exact) || std::isnan(Value))
    return std::isnan(Exact) == std::isnan(Value) ? 0 : Infinity;
  float Nearest = static_cast<float>(Exact);
  if (std::isinf(Nearest) || std::isinf(Value)) {
    if (Nearest == Value)
      return 0;
    // The largest float stands beside infinity.
    if (std::fabs(Exact) < 0x1.000001p128 &&
        std::signbit(Value) == std::signbit(Nearest) &&
        std::fabs(Value) >= 0x1.fffffep127f)
      return std::fabs(std::ldexp(Exact, -104) - std::copysign(0x1p24, Exact)) +
             0.5;
    return Infinity;
  }
  int Exponent = Exact == 0 ? -126 : std::ilogb(Exact);
  if (Exponent < -126)
    Exponent = -126;
  return std::fabs(static_cast<double>(Value) - Exact) *
         std::ldexp(1.0, 23 - Exponent);
}

namespace {

struct Worst {
  double Error = 0;
  float X = 0;
  float Y = 0;

  void take(double NewError, float NewX, float NewY = 0) {
    if (NewError > Error)
      *this = {NewError, NewX, NewY};
  }

  void expectAtMost(const char *Name, double Normal, const Worst &Subnormal,
                    double SubnormalLimit) const {
    printf("%-6s %.3f ulp at (%a, %a); subnormal results %.3f at (%a, %a)\n",
           Name, Error, X, Y, Subnormal.Error, Subnormal.X, Subnormal.Y);
    EXPECT_LE(Error, Normal) << Name << std::hexfloat << " " << X << " " << Y;
    EXPECT_LE(Subnormal.Error, SubnormalLimit)
        << Name << std::hexfloat << " " << Subnormal.X << " " << Subnormal.Y;
  }
};

} // namespace

/// Walks over the floats; \p Normal and \p Subnormal are the greatest errors
/// allowed for results of either kind.
static void sweep(const char *Name, float (*Ours)(float),
                  double (*Reference)(double), double Normal,
                  double Subnormal = 0.5) {
  const char *Setting = getenv("TP_MATH_STRIDE");
  uint32_t Stride =
      Setting ? static_cast<uint32_t>(strtoul(Setting, nullptr, 10)) : 251;
  ASSERT_NE(Stride, 0u) << "TP_MATH_STRIDE is not a positive number";
  Worst Normals, Subnormals;
  for (uint64_t Bits = 0; Bits < uint64_t(1) << 32; Bits += Stride) {
    float X = fromBits(static_cast<uint32_t>(Bits));
    double Exact = Reference(X);
    double Error = ulpError(Ours(X), Exact);
    (std::fabs(Exact) < 0x1p-126 ? Subnormals : Normals).take(Error, X);
  }
  Normals.expectAtMost(Name, Normal, Subnormals, Subnormal);
}

/// The same over random pairs of every magnitude and over pairs near \p Near.
static void sweepPairs(const char *Name, float (*Ours)(float, float),
                       double (*Reference)(double, double), double Normal,
                       double Subnormal) {
  std::mt19937 Random(20260101);
  Worst Normals, Subnormals;
  for (int I = 0; I != 20'000'000; ++I) {
    uint32_t A = Random(), B = Random();
    // Exponents near 1 every second time.
    if (I & 1) {
      A = (A & 0x87FFFFFF) | 0x38000000;
      B = (B & 0x83FFFFFF) | 0x40000000;
    }
    if (I & 2)
      A &= 0x7FFFFFFF;
    float X = fromBits(A), Y = fromBits(B);
    double Exact = Reference(X, Y);
    double Error = ulpError(Ours(X, Y), Exact);
    (std::fabs(Exact) < 0x1p-126 ? Subnormals : Normals).take(Error, X, Y);
  }
  Normals.expectAtMost(Name, Normal, Subnormals, Subnormal);
}

static bool sameBits(float A, float B) {
  return (std::isnan(A) && std::isnan(B)) ||
         std::bit_cast<uint32_t>(A) == std::bit_cast<uint32_t>(B);
}

static std::vector<float> edges() {
  std::vector<float> Values = {0.0f,          Smallest,
                               0x1p-149f,     0x1.fffffcp-127f,
                               0x1p-126f,     0x1p-60f,
                               0x1p-24f,      0x1p-12f,
                               0.25f,         0.49999997f,
                               0.5f,          0.70710677f,
                               0.70710683f,   0.99999994f,
                               1.0f,          1.0000001f,
                               1.5f,          2.0f,
                               2.5f,          3.0f,
                               4.0f,          7.0f,
                               8388607.5f,    8388608.0f,
                               16777215.0f,   16777216.0f,
                               2147483648.0f, 0x1p60f,
                               0x1p100f,      0x1.fffffep127f,
                               Infinity,      NaN};
  size_t Count = Values.size();
  for (size_t I = 0; I != Count; ++I)
    Values.push_back(-Values[I]);
  return Values;
}

TEST(Math, Sin) { sweep("sin", tp::sin, std::sin, 0.84); }
TEST(Math, Cos) { sweep("cos", tp::cos, std::cos, 0.83); }
TEST(Math, Tan) { sweep("tan", tp::tan, std::tan, 1.51); }
TEST(Math, Asin) { sweep("asin", tp::asin, std::asin, 0.66); }
TEST(Math, Acos) { sweep("acos", tp::acos, std::acos, 0.65); }
TEST(Math, Atan) { sweep("atan", tp::atan, std::atan, 0.65); }
TEST(Math, Exp) { sweep("exp", tp::exp, std::exp, 0.80, 0.81); }
TEST(Math, Exp2) { sweep("exp2", tp::exp2, std::exp2, 0.65, 0.80); }
TEST(Math, Log) { sweep("log", tp::log, std::log, 0.66); }
TEST(Math, Log2) { sweep("log2", tp::log2, std::log2, 0.51); }
TEST(Math, Log10) { sweep("log10", tp::log10, std::log10, 0.51); }

TEST(Math, HyperbolicFunctionsAndRoots) {
  sweep("expm1", tp::expm1, std::expm1, 1.5);
  sweep("log1p", tp::log1p, std::log1p, 0.7);
  sweep("sinh", tp::sinh, std::sinh, 1.25);
  sweep("cosh", tp::cosh, std::cosh, 0.8);
  sweep("tanh", tp::tanh, std::tanh, 1.25);
  sweep("asinh", tp::asinh, std::asinh, 0.51);
  sweep("acosh", tp::acosh, std::acosh, 0.51);
  sweep("atanh", tp::atanh, std::atanh, 0.51);
  sweep("cbrt", tp::cbrt, std::cbrt, 0.53);
}
TEST(Math, Pow) { sweepPairs("pow", tp::pow, std::pow, 0.75, 0.80); }
TEST(Math, Atan2) { sweepPairs("atan2", tp::atan2, std::atan2, 0.70, 0.70); }
TEST(Math, FastSin) { sweep("fastSin", tp::fastSin, std::sin, 1.0, 1.0); }
TEST(Math, FastCos) { sweep("fastCos", tp::fastCos, std::cos, 1.0, 1.0); }

TEST(Math, NearMultiplesOfHalfPi) {
  Worst Sine, Cosine, Tangent;
  for (int Multiple = 1; Multiple != 200'000; ++Multiple) {
    float Start = static_cast<float>(Multiple * 0x1.921fb54442d18p+0);
    for (int Step = -2; Step <= 2; ++Step) {
      float X = fromBits(std::bit_cast<uint32_t>(Start) + Step);
      Sine.take(ulpError(tp::sin(X), std::sin(double(X))), X);
      Cosine.take(ulpError(tp::cos(X), std::cos(double(X))), X);
      Tangent.take(ulpError(tp::tan(X), std::tan(double(X))), X);
    }
  }
  Sine.expectAtMost("sin", 0.84, {}, 0);
  Cosine.expectAtMost("cos", 0.83, {}, 0);
  Tangent.expectAtMost("tan", 1.51, {}, 0);
}

TEST(Math, LogarithmsNearOne) {
  Worst Natural, Binary, Decimal;
  for (int Step = -100'000; Step <= 100'000; ++Step) {
    float X = fromBits(0x3F800000 + Step);
    Natural.take(ulpError(tp::log(X), std::log(double(X))), X);
    Binary.take(ulpError(tp::log2(X), std::log2(double(X))), X);
    Decimal.take(ulpError(tp::log10(X), std::log10(double(X))), X);
  }
  Natural.expectAtMost("log", 0.66, {}, 0);
  Binary.expectAtMost("log2", 0.51, {}, 0);
  Decimal.expectAtMost("log10", 0.51, {}, 0);
}

TEST(Math, PowersOfNumbersNearOne) {
  std::mt19937 Random(7);
  Worst Normals, Subnormals;
  for (int I = 0; I != 5'000'000; ++I) {
    float X =
        fromBits(0x3F800000 + static_cast<int>(Random() % 2000001) - 1000000);
    double Limit = 150.0 / std::fabs(std::log2(double(X)));
    float Y =
        static_cast<float>(Limit * (static_cast<int32_t>(Random()) * 0x1p-31));
    double Exact = std::pow(double(X), double(Y));
    (std::fabs(Exact) < 0x1p-126 ? Subnormals : Normals)
        .take(ulpError(tp::pow(X, Y), Exact), X, Y);
  }
  Normals.expectAtMost("pow", 0.75, Subnormals, 0.80);
}

/// Zeros, infinities and NaNs, and the signs of zeros.
TEST(Math, SpecialValues) {
  struct Function {
    const char *Name;
    float (*Ours)(float);
    float (*Reference)(float);
  };
  const Function Functions[] = {
      {"sin", tp::sin, std::sin},       {"cos", tp::cos, std::cos},
      {"tan", tp::tan, std::tan},       {"asin", tp::asin, std::asin},
      {"acos", tp::acos, std::acos},    {"atan", tp::atan, std::atan},
      {"exp", tp::exp, std::exp},       {"exp2", tp::exp2, std::exp2},
      {"log", tp::log, std::log},       {"log2", tp::log2, std::log2},
      {"log10", tp::log10, std::log10},
  };
  for (const Function &F : Functions)
    for (float X : {0.0f, -0.0f, 1.0f, -1.0f, Infinity, -Infinity, NaN, -2.0f})
      if (float Expected = F.Reference(X);
          Expected == 0 || std::isnan(Expected) || std::isinf(Expected))
        EXPECT_TRUE(sameBits(F.Ours(X), Expected)) << F.Name << " " << X;
  for (float X : edges())
    for (float Y : edges()) {
      float Expected = std::pow(X, Y);
      if (Expected == 0 || !std::isfinite(Expected) || Expected == 1)
        EXPECT_TRUE(sameBits(tp::pow(X, Y), Expected))
            << "pow " << X << " " << Y << " is " << tp::pow(X, Y);
      EXPECT_LE(ulpError(tp::pow(X, Y), std::pow(double(X), double(Y))), 0.80)
          << std::hexfloat << "pow " << X << " " << Y;
      Expected = std::atan2(X, Y);
      if (Expected == 0 || !std::isfinite(Expected))
        EXPECT_TRUE(sameBits(tp::atan2(X, Y), Expected))
            << "atan2 " << X << " " << Y;
      EXPECT_LE(ulpError(tp::atan2(X, Y), std::atan2(double(X), double(Y))),
                0.70)
          << std::hexfloat << "atan2 " << X << " " << Y;
    }
}

TEST(Math, RoundingIsExact) {
  auto Check = [](float X) {
    ASSERT_TRUE(sameBits(tp::floor(X), std::floor(X))) << X;
    ASSERT_TRUE(sameBits(tp::ceil(X), std::ceil(X))) << X;
    ASSERT_TRUE(sameBits(tp::trunc(X), std::trunc(X))) << X;
    ASSERT_TRUE(sameBits(tp::round(X), std::round(X))) << X;
    ASSERT_TRUE(sameBits(tp::rint(X), std::rint(X))) << X;
    ASSERT_TRUE(sameBits(tp::sqrt(X), std::sqrt(X))) << X;
  };
  for (float X : edges())
    Check(X);
  for (uint64_t Bits = 0; Bits < uint64_t(1) << 32 && !HasFatalFailure();
       Bits += 251)
    Check(fromBits(static_cast<uint32_t>(Bits)));
  for (int Eighth = -4096; Eighth <= 4096 && !HasFatalFailure(); ++Eighth)
    Check(static_cast<float>(Eighth) * 0.125f);
}

TEST(Math, RemaindersAndScalingAreExact) {
  auto Check = [](float X, float Y) {
    ASSERT_TRUE(sameBits(tp::fmod(X, Y), std::fmod(X, Y)))
        << std::hexfloat << X << " " << Y;
    ASSERT_TRUE(sameBits(tp::copysign(X, Y), std::copysign(X, Y)));
  };
  std::mt19937 Random(1);
  for (float X : edges()) {
    for (float Y : edges())
      Check(X, Y);
    for (int Exponent = -300; Exponent <= 300; ++Exponent)
      ASSERT_TRUE(sameBits(tp::ldexp(X, Exponent), std::ldexp(X, Exponent)))
          << std::hexfloat << X << " " << Exponent;
  }
  for (int I = 0; I != 2'000'000 && !HasFatalFailure(); ++I) {
    float X = fromBits(Random()), Y = fromBits(Random());
    Check(X, Y);
    int Exponent = static_cast<int>(Random() % 600) - 300;
    ASSERT_TRUE(sameBits(tp::ldexp(X, Exponent), std::ldexp(X, Exponent)))
        << std::hexfloat << X << " " << Exponent;
  }
}

TEST(Math, MinimaAndMaxima) {
  EXPECT_TRUE(sameBits(tp::fmin(0.0f, -0.0f), -0.0f));
  EXPECT_TRUE(sameBits(tp::fmin(-0.0f, 0.0f), -0.0f));
  EXPECT_TRUE(sameBits(tp::fmax(0.0f, -0.0f), 0.0f));
  EXPECT_TRUE(sameBits(tp::fmax(-0.0f, 0.0f), 0.0f));
  EXPECT_EQ(tp::fmin(NaN, 1.0f), 1.0f);
  EXPECT_EQ(tp::fmax(1.0f, NaN), 1.0f);
  EXPECT_TRUE(std::isnan(tp::fmax(NaN, NaN)));
  EXPECT_EQ(tp::clamp(7.0f, -1.0f, 2.0f), 2.0f);
  EXPECT_EQ(tp::saturate(NaN), 0.0f);
}
