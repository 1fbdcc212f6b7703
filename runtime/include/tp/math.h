//===- math.h - Single-precision functions ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One source for the chip and the host, made of correctly rounded operations
// and integer steps only: both compute the same bits (of a NaN, only that it is
// one). Each comment states the greatest error, in units in the last place of
// the exact result, found over all floats, or, for two arguments, over 25
// million pairs (test/unit/runtime/MathTest.cpp holds the functions to it).
// Special cases are those of ISO C, annex F. No function sets errno.
//
//===----------------------------------------------------------------------===//

#ifndef TP_MATH_H
#define TP_MATH_H

#include <stdint.h>

namespace tp {

inline constexpr float kPi = 0x1.921fb6p+1f;

/// Magnitude of \p X. Exact.
inline float fabs(float X) { return __builtin_fabsf(X); }
/// \p Magnitude with the sign of \p Sign. Exact.
inline float copysign(float Magnitude, float Sign) {
  return __builtin_copysignf(Magnitude, Sign);
}
/// Square root; 0.5 ulp.
inline float sqrt(float X) { return __builtin_elementwise_sqrt(X); }

#ifdef __tp__

/// 1 / sqrt(\p X) in one instruction; 0.5 ulp but for a few results that are
/// rounded twice.
inline float rsqrt(float X) { return __builtin_tp_rsqrt(X); }
/// 1 / \p X in one instruction; 0.5 ulp.
inline float rcp(float X) { return __builtin_tp_rcp(X); }
/// Sine and cosine in one instruction; 1 ulp.
inline float fastSin(float X) { return __builtin_tp_sin(X); }
inline float fastCos(float X) { return __builtin_tp_cos(X); }
/// The smaller number; a NaN only if both are. -0 is smaller than +0.
inline float fmin(float A, float B) { return __builtin_fminf(A, B); }
/// The greater number; a NaN only if both are. -0 is smaller than +0.
inline float fmax(float A, float B) { return __builtin_fmaxf(A, B); }

#else

float rsqrt(float X);
float rcp(float X);
float fastSin(float X);
float fastCos(float X);
float fmin(float A, float B);
float fmax(float A, float B);

#endif

/// Sine; 0.84 ulp, also for the largest arguments.
float sin(float X);
/// Cosine; 0.83 ulp, also for the largest arguments.
float cos(float X);
/// Tangent; 1.51 ulp, also for the largest arguments.
float tan(float X);
/// Arc sine; 0.66 ulp.
float asin(float X);
/// Arc cosine; 0.65 ulp.
float acos(float X);
/// Arc tangent; 0.65 ulp.
float atan(float X);
/// Angle of the point (\p X, \p Y) from the x axis, in (-pi, pi]; 0.70 ulp.
float atan2(float Y, float X);

/// e to the \p X; 0.81 ulp.
float exp(float X);
/// 2 to the \p X; 0.65 ulp, 0.80 ulp where the result is subnormal.
float exp2(float X);
/// Natural logarithm; 0.66 ulp.
float log(float X);
/// Logarithm to the base 2; 0.51 ulp.
float log2(float X);
/// Logarithm to the base 10; 0.51 ulp.
float log10(float X);
/// \p X to the \p Y; 0.75 ulp, 0.80 ulp where the result is subnormal.
float pow(float X, float Y);

/// e to the \p X, less 1; 1.5 ulp.
float expm1(float X);
/// Natural logarithm of 1 + \p X; 0.7 ulp.
float log1p(float X);
/// Hyperbolic sine; 1.25 ulp.
float sinh(float X);
/// Hyperbolic cosine; 0.8 ulp.
float cosh(float X);
/// Hyperbolic tangent; 1.25 ulp.
float tanh(float X);
/// Inverse hyperbolic sine; 0.51 ulp.
float asinh(float X);
/// Inverse hyperbolic cosine; 0.51 ulp.
float acosh(float X);
/// Inverse hyperbolic tangent; 0.51 ulp.
float atanh(float X);
/// Cube root; 0.53 ulp.
float cbrt(float X);

/// The greatest integer not above \p X. Exact.
float floor(float X);
/// The least integer not below \p X. Exact.
float ceil(float X);
/// \p X without its fraction. Exact.
float trunc(float X);
/// The nearest integer, halves away from zero. Exact.
float round(float X);
/// The nearest integer, halves to the even one. Exact.
float rint(float X);
/// What is left of \p X after taking \p Y from it as often as it fits, with the
/// sign of \p X. Exact.
float fmod(float X, float Y);

/// \p X times 2 to the \p Exponent, correctly rounded.
float ldexp(float X, int Exponent);

/// \p X kept between \p Low and \p High; a NaN becomes \p Low.
inline float clamp(float X, float Low, float High) {
  return fmin(fmax(X, Low), High);
}
/// \p X kept between 0 and 1; a NaN becomes 0.
inline float saturate(float X) { return clamp(X, 0.0f, 1.0f); }

} // namespace tp

#endif // TP_MATH_H
