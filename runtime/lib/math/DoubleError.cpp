//===- DoubleError.cpp - Error function of doubles ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The polynomials are Chebyshev fits.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"

using namespace tp;
using namespace tp::soft;

/// erf(X) / X - 1 for |X| up to 1.
static double errorQuotient(double X) {
  static const double P[] = {
      0x1.06eba8214db69p-3,   -0x1.812746b0379e6p-2,  0x1.ce2f21a042b30p-4,
      -0x1.b82ce31284e00p-6,  0x1.565bcd0dbaa38p-8,   -0x1.c02db3dac435fp-11,
      0x1.f9a321d5b8e1ep-14,  -0x1.f4d1e3183f7aep-17, 0x1.b9df224ca4b97p-20,
      -0x1.5f1ecb6f0764cp-23, 0x1.f7b4bf3b13964p-27,  -0x1.389d4f2641625p-30,
      0x1.05ffd737fb32ep-34};
  return polynomial(X * X, P);
}

/// erfc(X) for X from 1/2 on: exp(-X^2) (1 + 2X)^-1 times a function that
/// hardly changes (M. M. Shepherd, J. G. Laframboise, Chebyshev approximation
/// of (1 + 2x) exp(x^2) erfc(x), 1981).
static double complement(double X) {
  static const double P[] = {
      0x1.3e0a99a0ee914p+0,   -0x1.1ebd220ea593bp-3,  -0x1.59e2c284b1198p-7,
      0x1.8f702ec6b32d3p-4,   -0x1.d76830c35349fp-4,  0x1.686106046f946p-4,
      -0x1.8ff5ef76c98b5p-5,  0x1.38ec6670eee8ap-6,   -0x1.143c4caa3414cp-8,
      -0x1.3cf3692200563p-12, 0x1.27e6657aa0040p-11,  -0x1.fda9129b2cd38p-14,
      -0x1.66e24deb181b3p-15, 0x1.97094cc0f9d65p-16,  0x1.3887a18e1747bp-19,
      -0x1.00067804720f9p-18, -0x1.7f374e84e2fa5p-25, 0x1.42b2879c9f3eap-21,
      -0x1.04ac6d23e969dp-27, -0x1.9278ed8f3ecfap-24, 0x1.e64ba3e47c9c6p-32,
      0x1.6d0a44c529dcep-27};
  if (X > 27.3)
    return 0.0;
  // A power of two keeps the factors from being subnormal.
  constexpr int Shift = 96;
  DoublePair Square = twoProduct(X, X);
  double Power = exponential(-Square.High, Shift);
  Power -= Power * Square.Low;
  double T = (X - 3.5) / (X + 3.5);
  double Result = Power * (polynomial(T, P) / (1.0 + 2.0 * X));
  return TP_LIBCALL(ldexp)(Result, -Shift);
}

extern "C" {

double TP_LIBCALL(erf)(double X) {
  if (isNaN(X))
    return doubleNaN();
  double Magnitude = magnitudeOf(X);
  if (Magnitude < 1.0)
    return X + X * errorQuotient(X);
  return withSign(1.0 - complement(Magnitude), X);
}

double TP_LIBCALL(erfc)(double X) {
  if (isNaN(X))
    return doubleNaN();
  if (X >= 0.5)
    return complement(X);
  if (X > -1.0)
    return (1.0 - X) - X * errorQuotient(X);
  return 2.0 - complement(-X);
}

} // extern "C"
