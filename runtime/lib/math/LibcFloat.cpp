//===- LibcFloat.cpp - The C library's functions of floats ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "runtime/lib/math/DoubleParts.h"
#include "runtime/lib/math/FloatParts.h"

namespace {

/// \p X and \p Exponent so that the input is X * 2^Exponent, X in [0.5, 1).
float splitExponent(float X, int *Exponent) {
  *Exponent = 0;
  uint32_t Magnitude = tp::floatBits(X) & ~tp::kFloatSign;
  if (Magnitude == 0 || Magnitude >= tp::kFloatInfinity)
    return X;
  if (Magnitude < 0x00800000u) {
    X *= 0x1p23f;
    Magnitude = tp::floatBits(X) & ~tp::kFloatSign;
    *Exponent = -23;
  }
  *Exponent += static_cast<int>(Magnitude >> 23) - 126;
  return tp::floatFromBits((tp::floatBits(X) & 0x807FFFFFu) | 0x3F000000u);
}

} // namespace

extern "C" {

float acosf(float X) { return tp::acos(X); }
float acoshf(float X) { return tp::acosh(X); }
float asinf(float X) { return tp::asin(X); }
float asinhf(float X) { return tp::asinh(X); }
float atanf(float X) { return tp::atan(X); }
float atan2f(float Y, float X) { return tp::atan2(Y, X); }
float atanhf(float X) { return tp::atanh(X); }
float cbrtf(float X) { return tp::cbrt(X); }
float ceilf(float X) { return tp::ceil(X); }
float copysignf(float Magnitude, float Sign) {
  return tp::copysign(Magnitude, Sign);
}
float cosf(float X) { return tp::cos(X); }
float coshf(float X) { return tp::cosh(X); }
float exp2f(float X) { return tp::exp2(X); }
float expf(float X) { return tp::exp(X); }
float expm1f(float X) { return tp::expm1(X); }
float fabsf(float X) { return tp::fabs(X); }
float fdimf(float X, float Y) { return X <= Y ? 0.0f : X - Y; }
float floorf(float X) { return tp::floor(X); }
float fmaxf(float X, float Y) { return tp::fmax(X, Y); }
float fminf(float X, float Y) { return tp::fmin(X, Y); }
float fmodf(float X, float Y) { return tp::fmod(X, Y); }
float frexpf(float X, int *Exponent) { return splitExponent(X, Exponent); }
float ldexpf(float X, int Exponent) { return tp::ldexp(X, Exponent); }
float log10f(float X) { return tp::log10(X); }
float log1pf(float X) { return tp::log1p(X); }
float log2f(float X) { return tp::log2(X); }
float logf(float X) { return tp::log(X); }
float nearbyintf(float X) { return tp::rint(X); }
float powf(float X, float Y) { return tp::pow(X, Y); }
float rintf(float X) { return tp::rint(X); }
float roundevenf(float X) { return tp::rint(X); }
float roundf(float X) { return tp::round(X); }
float scalbnf(float X, int Exponent) { return tp::ldexp(X, Exponent); }
float sinf(float X) { return tp::sin(X); }
float sinhf(float X) { return tp::sinh(X); }
float sqrtf(float X) { return tp::sqrt(X); }
float tanf(float X) { return tp::tan(X); }
float tanhf(float X) { return tp::tanh(X); }
float truncf(float X) { return tp::trunc(X); }
long lrintf(float X) { return static_cast<long>(tp::rint(X)); }
long lroundf(float X) { return static_cast<long>(tp::round(X)); }
long long llrintf(float X) { return static_cast<long long>(tp::rint(X)); }
long long llroundf(float X) { return static_cast<long long>(tp::round(X)); }
float scalblnf(float X, long Exponent) {
  // Beyond these every number overflows or vanishes.
  return tp::ldexp(X, Exponent > 500    ? 500
                      : Exponent < -500 ? -500
                                        : static_cast<int>(Exponent));
}
float nanf(const char *) { return tp::floatNaN(); }

// Through double, where the rounding is the second one.
float erff(float X) { return static_cast<float>(TP_LIBCALL(erf)(X)); }
float erfcf(float X) { return static_cast<float>(TP_LIBCALL(erfc)(X)); }
float lgammaf(float X) { return static_cast<float>(TP_LIBCALL(lgamma)(X)); }
float tgammaf(float X) { return static_cast<float>(TP_LIBCALL(tgamma)(X)); }

// Every result in double is a float.
float remainderf(float X, float Y) {
  return static_cast<float>(TP_LIBCALL(remainder)(X, Y));
}
float remquof(float X, float Y, int *Quotient) {
  return static_cast<float>(TP_LIBCALL(remquo)(X, Y, Quotient));
}
int ilogbf(float X) { return TP_LIBCALL(ilogb)(X); }
float logbf(float X) { return static_cast<float>(TP_LIBCALL(logb)(X)); }

float nextafterf(float X, float Toward) {
  if (X != X || Toward != Toward)
    return tp::floatNaN();
  if (X == Toward)
    return Toward;
  uint32_t Bits = tp::floatBits(X);
  if ((Bits & ~tp::kFloatSign) == 0)
    return tp::copysign(tp::floatFromBits(1), Toward);
  bool Up = (X < Toward) == ((Bits & tp::kFloatSign) == 0);
  return tp::floatFromBits(Up ? Bits + 1 : Bits - 1);
}

// long double is double.
float nexttowardf(float X, long double Toward) {
  double D = Toward;
  if (X != X || D != D)
    return tp::floatNaN();
  double Wide = X;
  if (Wide == D)
    return static_cast<float>(D);
  return nextafterf(X, Wide < D ? tp::floatInfinity() : -tp::floatInfinity());
}

float modff(float X, float *Whole) {
  *Whole = tp::trunc(X);
  float Magnitude = tp::fabs(X);
  return tp::copysign(Magnitude == tp::floatInfinity() ? 0.0f : X - *Whole, X);
}

/// The product is exact in double. Its sum with Z must not be rounded to double
/// halfway between two floats before it is rounded again: where the sum is not
/// exact, its last bit is made odd.
float fmaf(float X, float Y, float Z) {
  double Product = static_cast<double>(X) * static_cast<double>(Y);
  double Addend = static_cast<double>(Z);
  double Sum = Product + Addend;
  uint64_t Bits = __builtin_bit_cast(uint64_t, Sum);
  if ((Bits & 0x1FFFFFFF) == 0x10000000 && __builtin_isfinite(Sum)) {
    double PartZ = Sum - Product;
    double Error = (Product - (Sum - PartZ)) + (Addend - PartZ);
    if (Error != 0) {
      bool Away = (Error > 0) == (Sum > 0);
      Sum = __builtin_bit_cast(double, Away ? Bits + 1 : Bits - 1);
    }
  }
  return static_cast<float>(Sum);
}

float hypotf(float X, float Y) {
  if (tp::fabs(X) == tp::floatInfinity() || tp::fabs(Y) == tp::floatInfinity())
    return tp::floatInfinity();
  double DX = X, DY = Y;
  return static_cast<float>(TP_LIBCALL(__tp_sqrtdf)(DX * DX + DY * DY));
}

} // extern "C"
