//===- DoubleHyperbolic.cpp - Hyperbolic functions and roots of doubles -===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"
#include "runtime/lib/math/HyperbolicFunctions.h"

using namespace tp;
using namespace tp::soft;

template <> struct tp::Precision<double> {
  static constexpr double Tiny = 0x1p-54;
  static constexpr double Small = 0x1p-28;
  static constexpr double Large = 40.0;
  static constexpr int CubeRootSteps = 2;
  static constexpr DoublePair Ln2 = {0x1.62e42fefa39efp-1,
                                     0x1.abc9e3b39803fp-56};
  static double infinity() { return doubleInfinity(); }
  static double nan() { return doubleNaN(); }
  static double magnitude(double X) { return magnitudeOf(X); }
  static double squareRoot(double X) { return TP_LIBCALL(__tp_sqrtdf)(X); }
};

/// An odd function by its values from 0 on; a NaN becomes the one NaN.
static double odd(double (*Function)(double), double X) {
  if (isNaN(X))
    return doubleNaN();
  return withSign(Function(magnitudeOf(X)), X);
}

extern "C" {

double TP_LIBCALL(expm1)(double X) {
  return isNaN(X) ? doubleNaN() : expMinus1(X);
}
double TP_LIBCALL(log1p)(double X) {
  return isNaN(X) ? doubleNaN() : logOf1Plus(X);
}
double TP_LIBCALL(sinh)(double X) { return odd(hyperbolicSine<double>, X); }
double TP_LIBCALL(cosh)(double X) { return hyperbolicCosine(magnitudeOf(X)); }
double TP_LIBCALL(tanh)(double X) { return odd(hyperbolicTangent<double>, X); }
double TP_LIBCALL(asinh)(double X) { return odd(areaSine<double>, X); }
double TP_LIBCALL(acosh)(double X) { return areaCosine(X); }
double TP_LIBCALL(atanh)(double X) { return odd(areaTangent<double>, X); }

double TP_LIBCALL(cbrt)(double X) {
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude > kInfinity)
    return doubleNaN();
  if (Magnitude == 0 || Magnitude == kInfinity)
    return X;
  int Exponent;
  double Fraction = TP_LIBCALL(frexp)(fromBits(Magnitude), &Exponent);
  // Rounded down, for negative exponents too.
  int Third = (Exponent + 3000) / 3 - 1000;
  double Root =
      cubeRoot(Fraction * static_cast<double>(1 << (Exponent - 3 * Third)));
  return withSign(TP_LIBCALL(ldexp)(Root, Third), X);
}

double TP_LIBCALL(hypot)(double X, double Y) {
  double A = magnitudeOf(X), B = magnitudeOf(Y);
  if (A == doubleInfinity() || B == doubleInfinity())
    return doubleInfinity();
  if (isNaN(A) || isNaN(B))
    return doubleNaN();
  if (A < B) {
    double Other = A;
    A = B;
    B = Other;
  }
  if (B == 0.0)
    return A;
  // The greater one between 1/2 and 1. A much smaller one does not count.
  int Exponent;
  A = TP_LIBCALL(frexp)(A, &Exponent);
  B = TP_LIBCALL(ldexp)(B, -Exponent);
  if (B < 0x1p-60)
    return TP_LIBCALL(ldexp)(A, Exponent);
  DoublePair Root = squareRoot(sum(twoProduct(A, A), twoProduct(B, B)));
  return TP_LIBCALL(ldexp)(Root.High, Exponent);
}

} // extern "C"
