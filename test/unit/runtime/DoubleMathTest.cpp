//===- DoubleMathTest.cpp - Functions of doubles against long double ------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"
#include "test/unit/runtime/EdgeValues.h"
#include "gtest/gtest.h"
#include <cmath>
#include <cstdio>
#include <limits>

static_assert(std::numeric_limits<long double>::digits >= 64,
              "the reference needs a wider long double");

static double ulpError(double Value, long double Exact) {
  if (std::isnan(Exact) || std::isnan(Value))
    return std::isnan(Exact) == std::isnan(Value) ? 0 : HUGE_VAL;
  double Nearest = static_cast<double>(Exact);
  if (std::isinf(Nearest) || std::isinf(Value))
    return Nearest == Value ? 0 : HUGE_VAL;
  int Exponent = Exact == 0 ? -1022 : std::ilogb(Exact);
  if (Exponent < -1022)
    Exponent = -1022;
  return static_cast<double>(std::fabs(Value - Exact) *
                             std::ldexp(1.0L, 52 - Exponent));
}

/// Arguments of every magnitude, and twice as many between 2^-12 and 2^12.
template <typename Check> static void forArguments(Check CheckOne) {
  for (double X : tp::test::edgeDoubles())
    CheckOne(X);
  tp::test::RandomDoubles Random;
  for (int I = 0; I != 300'000; ++I) {
    double X = Random.next();
    CheckOne(X);
    uint64_t Bits = std::bit_cast<uint64_t>(X);
    uint64_t Exponent = 1023 - 12 + (Bits >> 52 & 0x7FF) % 24;
    CheckOne(
        std::bit_cast<double>((Bits & 0x800FFFFFFFFFFFFF) | Exponent << 52));
    CheckOne(std::bit_cast<double>((Bits & 0x000FFFFFFFFFFFFF) |
                                   (1022 + (Exponent & 1)) << 52));
  }
}

static void expectWithin(const char *Name, double (*Ours)(double),
                         long double (*Reference)(long double), double Limit) {
  double Worst = 0, WorstX = 0;
  forArguments([&](double X) {
    double Error = ulpError(Ours(X), Reference(X));
    if (Error > Worst) {
      Worst = Error;
      WorstX = X;
    }
  });
  printf("%-6s %.3f ulp at %a\n", Name, Worst, WorstX);
  EXPECT_LE(Worst, Limit) << Name << std::hexfloat << " " << WorstX;
}

namespace {

TEST(DoubleMath, Functions) {
  expectWithin("sin", tpSoft_sin, std::sin, 0.85);
  expectWithin("cos", tpSoft_cos, std::cos, 0.85);
  expectWithin("tan", tpSoft_tan, std::tan, 0.95);
  expectWithin("asin", tpSoft_asin, std::asin, 0.7);
  expectWithin("acos", tpSoft_acos, std::acos, 0.7);
  expectWithin("atan", tpSoft_atan, std::atan, 0.7);
  expectWithin("exp", tpSoft_exp, std::exp, 0.8);
  expectWithin("exp2", tpSoft_exp2, std::exp2, 0.8);
  expectWithin("log", tpSoft_log, std::log, 0.51);
  expectWithin("log2", tpSoft_log2, std::log2, 0.51);
  expectWithin("log10", tpSoft_log10, std::log10, 0.51);
}

TEST(DoubleMath, HyperbolicFunctionsAndRoots) {
  expectWithin("expm1", tpSoft_expm1, std::expm1, 1);
  expectWithin("log1p", tpSoft_log1p, std::log1p, 0.7);
  expectWithin("sinh", tpSoft_sinh, std::sinh, 0.8);
  expectWithin("cosh", tpSoft_cosh, std::cosh, 0.8);
  expectWithin("tanh", tpSoft_tanh, std::tanh, 0.8);
  expectWithin("asinh", tpSoft_asinh, std::asinh, 0.51);
  expectWithin("acosh", tpSoft_acosh, std::acosh, 0.51);
  expectWithin("atanh", tpSoft_atanh, std::atanh, 0.51);
  expectWithin("cbrt", tpSoft_cbrt, std::cbrt, 0.51);
}

TEST(DoubleMath, ErrorFunctions) {
  expectWithin("erf", tpSoft_erf, std::erf, 1.3);
  expectWithin("erfc", tpSoft_erfc, std::erfc, 4);
}

TEST(DoubleMath, GammaFunctions) {
  expectWithin(
      "gamma+", [](double X) { return X < 0 ? 0 : tpSoft_tgamma(X); },
      [](long double X) { return X < 0 ? 0 : std::tgamma(X); }, 2);
  expectWithin(
      "lgamma+", [](double X) { return X < 0 ? 0 : tpSoft_lgamma(X); },
      [](long double X) { return X < 0 ? 0 : std::lgamma(X); }, 2);
  expectWithin(
      "gamma-", [](double X) { return X > 0 ? 0 : tpSoft_tgamma(X); },
      [](long double X) { return X > 0 ? 0 : std::tgamma(X); }, 5);
  // Below 0 the logarithm has many zeros; there the error is absolute.
  double Worst = 0;
  forArguments([&](double X) {
    if (!(X < 0))
      return;
    double Ours = tpSoft_lgamma(X);
    long double Exact = std::lgamma(static_cast<long double>(X));
    if (std::isinf(Ours) || std::isinf(Exact))
      ASSERT_EQ(Ours, static_cast<double>(Exact)) << std::hexfloat << X;
    else
      Worst = std::max(Worst,
                       static_cast<double>(std::fabs(Ours - Exact) /
                                           (1 + std::fabs(Exact)) * 0x1p52L));
  });
  printf("lgamma- %.3f\n", Worst);
  EXPECT_LE(Worst, 2.5);
}

TEST(DoubleMath, FunctionsOfTwo) {
  double WorstPow = 0, WorstAtan2 = 0, WorstHypot = 0;
  auto Check = [&](double X, double Y) {
    double Pow = tpSoft_pow(X, Y), HostPow = std::pow(X, Y);
    double Error = ulpError(Pow, std::pow((long double)X, (long double)Y));
    if (std::isfinite(HostPow) && HostPow != 0)
      WorstPow = std::max(WorstPow, Error);
    else if (!std::isnan(HostPow) || !std::isnan(Pow))
      ASSERT_TRUE(std::bit_cast<uint64_t>(Pow) ==
                      std::bit_cast<uint64_t>(HostPow) ||
                  Error < 1)
          << std::hexfloat << X << " " << Y << " " << Pow;
    double Distance = tpSoft_hypot(X, Y);
    WorstHypot = std::max(
        WorstHypot,
        std::isinf(X) || std::isinf(Y)
            ? (Distance == HUGE_VAL ? 0 : HUGE_VAL)
            : ulpError(Distance, std::hypot((long double)X, (long double)Y)));
    double Angle = tpSoft_atan2(X, Y);
    WorstAtan2 =
        std::max(WorstAtan2,
                 ulpError(Angle, std::atan2((long double)X, (long double)Y)));
    ASSERT_EQ(std::signbit(Angle) && Angle == 0,
              std::signbit(std::atan2(X, Y)) && Angle == 0);
  };
  for (double X : tp::test::edgeDoubles())
    for (double Y : tp::test::edgeDoubles())
      Check(X, Y);
  tp::test::RandomDoubles Random;
  for (int I = 0; I != 500'000 && !HasFatalFailure(); ++I) {
    double X = Random.near(1.0);
    Check(X, Random.near(1.0));
    X = std::fabs(X);
    Check(X, 1000 / std::log2(X) * Random.near(0.01));
  }
  printf("pow %.3f ulp, atan2 %.3f ulp\n", WorstPow, WorstAtan2);
  EXPECT_LE(WorstPow, 0.8);
  EXPECT_LE(WorstAtan2, 0.75);
  printf("hypot %.3f ulp\n", WorstHypot);
  EXPECT_LE(WorstHypot, 1);
}

TEST(DoubleMath, ExactFunctions) {
  auto Same = [](double A, double B) {
    return (std::isnan(A) && std::isnan(B)) ||
           std::bit_cast<uint64_t>(A) == std::bit_cast<uint64_t>(B);
  };
  auto Check = [&](double X, double Y) {
    int OurExponent, HostExponent;
    double OurWhole, HostWhole;
    ASSERT_TRUE(Same(tpSoft_floor(X), std::floor(X))) << X;
    ASSERT_TRUE(Same(tpSoft_ceil(X), std::ceil(X))) << X;
    ASSERT_TRUE(Same(tpSoft_trunc(X), std::trunc(X))) << X;
    ASSERT_TRUE(Same(tpSoft_round(X), std::round(X))) << X;
    ASSERT_TRUE(Same(tpSoft_rint(X), std::rint(X))) << X;
    ASSERT_TRUE(Same(tpSoft_fmod(X, Y), std::fmod(X, Y))) << X << " " << Y;
    if (X != Y) {
      ASSERT_TRUE(Same(tpSoft_fmin(X, Y), std::fmin(X, Y))) << X << " " << Y;
      ASSERT_TRUE(Same(tpSoft_fmax(X, Y), std::fmax(X, Y))) << X << " " << Y;
    }
    ASSERT_TRUE(
        Same(tpSoft_frexp(X, &OurExponent), std::frexp(X, &HostExponent)));
    if (std::isfinite(X))
      ASSERT_EQ(OurExponent, HostExponent);
    ASSERT_TRUE(Same(tpSoft_modf(X, &OurWhole), std::modf(X, &HostWhole)));
    ASSERT_TRUE(Same(OurWhole, HostWhole));
    ASSERT_TRUE(Same(tpSoft_remainder(X, Y), std::remainder(X, Y)))
        << X << " " << Y;
    int OurQuotient, HostQuotient = 0;
    ASSERT_TRUE(Same(tpSoft_remquo(X, Y, &OurQuotient),
                     std::remquo(X, Y, &HostQuotient)));
    if (std::isfinite(X) && !std::isnan(Y) && Y != 0)
      ASSERT_TRUE(((OurQuotient ^ HostQuotient) & 7) == 0 ||
                  ((OurQuotient + HostQuotient) & 7) == 0)
          << X << " " << Y << " " << OurQuotient << " " << HostQuotient;
    ASSERT_TRUE(Same(tpSoft_nextafter(X, Y), std::nextafter(X, Y)))
        << X << " " << Y;
    ASSERT_TRUE(Same(tpSoft_logb(X), std::logb(X))) << X;
    if (std::isfinite(X) && X != 0)
      ASSERT_EQ(tpSoft_ilogb(X), std::ilogb(X)) << X;
    int Exponent = static_cast<int>(std::bit_cast<uint64_t>(Y) % 4400) - 2200;
    ASSERT_TRUE(Same(tpSoft_ldexp(X, Exponent), std::ldexp(X, Exponent)))
        << X << " " << Exponent;
  };
  for (double X : tp::test::edgeDoubles())
    for (double Y : tp::test::edgeDoubles())
      Check(X, Y);
  for (int Eighth = -4096; Eighth <= 4096 && !HasFatalFailure(); ++Eighth)
    Check(Eighth * 0.125, 1.0);
  tp::test::RandomDoubles Random;
  for (int I = 0; I != 200'000 && !HasFatalFailure(); ++I) {
    double X = Random.near(1e8);
    Check(X, Random.near(X));
  }
}

} // namespace
