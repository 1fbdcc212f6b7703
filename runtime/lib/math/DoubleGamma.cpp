//===- DoubleGamma.cpp - Gamma function of doubles ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// From 10 on by Stirling's series; below, by the recurrence from there, or, for
// the logarithm, from a polynomial around 2 (a Chebyshev fit).
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"

using namespace tp;
using namespace tp::soft;

constexpr DoublePair Pi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoublePair Log2OfE = {0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr double FirstOfSeries = 10.0;

/// Stirling's correction of the logarithm, from 10 on.
static double stirlingSeries(double X) {
  static const double P[] = {0x1.5555555555555p-4,  -0x1.6c16c16c16c17p-9,
                             0x1.a01a01a01a01ap-11, -0x1.3813813813814p-11,
                             0x1.b951e2b18ff23p-11, -0x1.f6ab0d9993c7dp-10,
                             0x1.a41a41a41a41ap-8,  -0x1.e4286cb0f5398p-6,
                             0x1.6fe96381e0680p-3,  -0x1.6476701181f3ap+0};
  double Inverse = 1.0 / X;
  return Inverse * polynomial(Inverse * Inverse, P);
}

/// sin(Pi X); 0 only for integers.
static double sineOfPi(double X) {
  double Rest = X - 2.0 * TP_LIBCALL(rint)(0.5 * X);
  // Rest is in [-1, 1], and sin(Pi - T) is sin(T).
  if (Rest > 0.5)
    Rest = 1.0 - Rest;
  else if (Rest < -0.5)
    Rest = -1.0 - Rest;
  DoublePair Angle = multiply(Pi, Rest);
  double Sine = TP_LIBCALL(sin)(Angle.High);
  return Sine + Angle.Low * TP_LIBCALL(cos)(Angle.High);
}

namespace {

/// The number 2^(High + Low) times Factor.
struct Power {
  DoublePair Exponent;
  double Factor;
};

} // namespace

/// Gamma of a number above 2^-60.
static Power gammaPower(double X) {
  DoublePair Shifted = {X, 0.0};
  DoublePair Product = {1.0, 0.0};
  for (int Step = 0; Shifted.High < FirstOfSeries; ++Step) {
    Product = multiply(Product, Shifted);
    Shifted = twoSum(X, static_cast<double>(Step + 1));
  }
  double Y = Shifted.High;
  DoublePair L = logarithm2(bits(Y));
  DoublePair Exponent = sum(multiply(L, Y - 0.5), multiply(Log2OfE, -Y));
  // Of Low the derivative of the logarithm is enough.
  double Slope = L.High * 0x1.62e42fefa39efp-1 - 0.5 / Y;
  double Tail = stirlingSeries(Y) + Shifted.Low * Slope;
  Exponent = sum(Exponent, Tail * Log2OfE.High);
  // The square root of 2 Pi.
  DoublePair Factor =
      divide(DoublePair{0x1.40d931ff62706p+1, -0x1.a6a0d6f814637p-53}, Product);
  return {Exponent, Factor.High};
}

static double gammaOfNegative(double X) {
  if (X < -190.0)
    return TP_LIBCALL(rint)(0.5 * TP_LIBCALL(floor)(X)) * 2.0 ==
                   TP_LIBCALL(floor)(X)
               ? 0.0
               : -0.0;
  double A = -X;
  double Sine = sineOfPi(A);
  if (A < 0x1p-60)
    return 1.0 / X;
  Power P = gammaPower(A);
  // A power of two keeps the factors from being subnormal.
  constexpr int Shift = 96;
  DoublePair Exponent =
      sum({-P.Exponent.High, -P.Exponent.Low}, static_cast<double>(Shift));
  double Result = -Pi.High / (A * Sine * P.Factor) * exponential2(Exponent);
  return TP_LIBCALL(ldexp)(Result, -Shift);
}

/// log Gamma(2 + U) for |U| up to 1/2, plus \p Other.
static double aroundTwo(double U, DoublePair Other) {
  static const double P[] = {
      0x1.4a34cc4a60fa6p-2,   -0x1.13e001a557607p-4,  0x1.51322ac7d8333p-6,
      -0x1.e404fc218f370p-8,  0x1.7add6eadfcc7bp-9,   -0x1.38ac5c2c3ba16p-10,
      0x1.0b36af5972ed1p-11,  -0x1.d3fd4c217341ep-13, 0x1.a127cd91ac95bp-14,
      -0x1.78de7721ff5a0p-15, 0x1.5808af19fa483p-16,  -0x1.3cb7b3b3125e1p-17,
      0x1.2620de1c78d97p-18,  -0x1.1235bb6eb9201p-19, 0x1.f038cb2f6a913p-21,
      -0x1.d295ec4df68f0p-22, 0x1.2703c6effc4ebp-22,  -0x1.17d0781c44b2ep-23};
  // 1 less Euler's constant.
  DoublePair Linear =
      multiply(DoublePair{0x1.b0ee6072093cep-2, 0x1.6cb90701fbfabp-58}, U);
  return sum(sum(Other, Linear), U * U * polynomial(U, P)).High;
}

static double logGammaOfPositive(double X) {
  if (X < 0x1p-60)
    return -TP_LIBCALL(log)(X);
  if (X >= FirstOfSeries) {
    DoublePair L = logarithm({X, 0.0});
    if (X > 0x1p60) {
      DoublePair Factor = sum(L, -1.0);
      return X > 0x1p1020 || Factor.High * X == doubleInfinity()
                 ? doubleInfinity()
                 : multiply(Factor, X).High;
    }
    DoublePair Sum = sum(multiply(L, X - 0.5), -X);
    // Half of the logarithm of 2 Pi.
    DoublePair Constant = {0x1.d67f1c864beb5p-1, -0x1.65b5a1b7ff5dfp-55};
    return sum(sum(Sum, Constant), stirlingSeries(X)).High;
  }
  if (X < 0.5) {
    DoublePair L = logarithm(twoSum(X, 0.0));
    DoublePair L1 = logarithm(twoSum(1.0, X));
    return aroundTwo(X, {-L.High - L1.High, -L.Low - L1.Low});
  }
  if (X < 1.5) {
    DoublePair L = logarithm({X, 0.0});
    return aroundTwo(X - 1.0, {-L.High, -L.Low});
  }
  DoublePair Product = {1.0, 0.0};
  while (X >= 2.5) {
    X -= 1.0;
    Product = multiply(Product, X);
  }
  DoublePair L =
      Product.High == 1.0 ? DoublePair{0.0, 0.0} : logarithm(Product);
  return aroundTwo(X - 2.0, L);
}

extern "C" {

double TP_LIBCALL(tgamma)(double X) {
  if (isNaN(X) || X == -doubleInfinity())
    return doubleNaN();
  if (X == 0.0)
    return withSign(doubleInfinity(), X);
  if (X < 0.0)
    return TP_LIBCALL(floor)(X) == X ? doubleNaN() : gammaOfNegative(X);
  if (X < 0x1p-60)
    return 1.0 / X;
  if (X > 172.0)
    return doubleInfinity();
  Power P = gammaPower(X);
  // The last of the range would overflow before the factor is applied.
  return exponential2(sum(P.Exponent, -8.0)) * P.Factor * 256.0;
}

double TP_LIBCALL(lgamma)(double X) {
  if (isNaN(X))
    return doubleNaN();
  if (X > 0.0)
    return X == doubleInfinity() ? X : logGammaOfPositive(X);
  // Every number from 2^52 on is an integer.
  if (TP_LIBCALL(floor)(X) == X)
    return doubleInfinity();
  double A = -X;
  if (A < 0x1p-60)
    return -TP_LIBCALL(log)(A);
  double Reflection = Pi.High / (A * magnitudeOf(sineOfPi(A)));
  return TP_LIBCALL(log)(Reflection) - logGammaOfPositive(A);
}

} // extern "C"
