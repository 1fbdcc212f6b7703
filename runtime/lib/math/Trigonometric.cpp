//===- Trigonometric.cpp - sin, cos, tan of floats ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The argument becomes a quadrant and a rest of at most pi/4 by an exact
// multiplication with enough bits of 2/pi (Payne and Hanek, Radian reduction
// for trigonometric functions, 1983). The polynomials are Chebyshev fits.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/FloatParts.h"

namespace tp {

namespace {

/// An angle: Quadrant * pi/2 + Rest.
struct ReducedAngle {
  FloatPair Rest;
  uint32_t Quadrant;
};

} // namespace

/// 32 zeros, then the bits of 2/pi behind the point.
constexpr uint32_t TwoOverPi[] = {
    0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1,
    0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab,
};

/// 32 bits of the table from \p Bit on.
static inline uint32_t twoOverPiBits(uint32_t Bit) {
  const uint32_t *Word = TwoOverPi + Bit / 32;
  uint32_t Shift = Bit % 32;
  return Shift == 0 ? Word[0] : Word[0] << Shift | Word[1] >> (32 - Shift);
}

constexpr float QuarterPi = 0x1.921fb6p-1f;

/// For finite \p X.
static ReducedAngle reduce(float X) {
  uint32_t Bits = floatBits(X);
  uint32_t Magnitude = Bits & ~kFloatSign;
  if (Magnitude <= floatBits(QuarterPi))
    return {{X, 0.0f}, 0};

  // |X| is Integer * 2^(Exponent - 150). Bits of 2/pi that make the product a
  // multiple of 4 do not count, and of the rest 96 bits suffice: no float's
  // multiple of 2/pi comes nearer to an integer than 2^-31.
  uint32_t Integer = (Magnitude & 0x007FFFFFu) | 0x00800000u;
  uint32_t Start = (Magnitude >> 23) - 150 - 2 + 32;
  uint64_t Low = static_cast<uint64_t>(Integer) * twoOverPiBits(Start + 64);
  uint64_t Middle = static_cast<uint64_t>(Integer) * twoOverPiBits(Start + 32);
  uint32_t High = Integer * twoOverPiBits(Start);
  // The top two bits are the quadrant, the others the fraction of the next.
  uint64_t Turns = (static_cast<uint64_t>(High) << 32) + Middle + (Low >> 32);
  uint32_t Quadrant =
      static_cast<uint32_t>((Turns + (uint64_t(1) << 61)) >> 62);
  uint64_t Fraction = Turns << 2;
  uint32_t Sign = Bits & kFloatSign;
  if (Fraction >> 63 != 0) {
    Fraction = -Fraction;
    Sign ^= kFloatSign;
  }
  if (Bits & kFloatSign)
    Quadrant = -Quadrant;

  uint32_t Upper = static_cast<uint32_t>(Fraction >> 32);
  int Shift = Upper != 0
                  ? __builtin_clz(Upper)
                  : 32 + __builtin_clz(static_cast<uint32_t>(Fraction) | 1);
  Fraction <<= Shift;
  // pi/2 as a 32-bit integer has a weight of 2^-31.
  uint64_t Angle = (Fraction >> 32) * 0xC90FDAA2u;
  float Unit =
      floatFromBits(Sign | static_cast<uint32_t>(127 - 31 + 8 - Shift) << 23);
  float RestHigh = static_cast<float>(static_cast<int32_t>(Angle >> 40)) * Unit;
  float RestLow =
      static_cast<float>(static_cast<int32_t>(Angle >> 16 & 0x00FFFFFF)) *
      (Unit * 0x1p-24f);
  return {{RestHigh, RestLow}, Quadrant & 3};
}

/// sin(R) for |R| <= pi/4; the polynomial's error is 2^-28.
static inline float sineOf(FloatPair R) {
  float Square = R.High * R.High;
  float P = -0x1.a013a8p-13f + Square * 0x1.6dbdeep-19f;
  P = 0x1.11110ep-7f + Square * P;
  P = -0x1.555556p-3f + Square * P;
  return R.High + (R.High * Square * P + R.Low * (1.0f - 0.5f * Square));
}

/// cos(R) for |R| <= pi/4; the polynomial's error is 2^-31.
static inline float cosineOf(FloatPair R) {
  FloatPair Square = twoProduct(R.High, R.High);
  float Q = 0x1.a015c4p-16f + Square.High * -0x1.25243cp-22f;
  Q = -0x1.6c16c0p-10f + Square.High * Q;
  Q = 0x1.555556p-5f + Square.High * Q;
  float Half = 0.5f * Square.High;
  FloatPair Start = fastTwoSum(1.0f, -Half);
  float Rest = Square.High * Square.High * Q;
  return Start.High +
         (Start.Low + (Rest - (0.5f * Square.Low + R.High * R.Low)));
}

static bool isFinite(float X) {
  return (floatBits(X) & kFloatInfinity) != kFloatInfinity;
}

/// Below this sin and tan of X are X, and the products would be subnormal.
constexpr float Tiny = 0x1p-12f;

float sin(float X) {
  if (!isFinite(X))
    return floatNaN();
  if (fabs(X) < Tiny)
    return X;
  ReducedAngle A = reduce(X);
  float Result = A.Quadrant & 1 ? cosineOf(A.Rest) : sineOf(A.Rest);
  return A.Quadrant & 2 ? -Result : Result;
}

float cos(float X) {
  if (!isFinite(X))
    return floatNaN();
  if (fabs(X) < Tiny)
    return 1.0f;
  ReducedAngle A = reduce(X);
  float Result = A.Quadrant & 1 ? sineOf(A.Rest) : cosineOf(A.Rest);
  return (A.Quadrant + 1) & 2 ? -Result : Result;
}

float tan(float X) {
  if (!isFinite(X))
    return floatNaN();
  if (fabs(X) < Tiny)
    return X;
  ReducedAngle A = reduce(X);
  // The polynomial's error is 2^-27 of the result.
  float Square = A.Rest.High * A.Rest.High;
  float P = 0x1.368a84p-10f + Square * 0x1.f7c856p-9f;
  P = 0x1.46743ap-7f + Square * P;
  P = 0x1.623d0ep-6f + Square * P;
  P = 0x1.ba52a2p-5f + Square * P;
  P = 0x1.111088p-3f + Square * P;
  P = 0x1.555556p-2f + Square * P;
  float Rest = A.Rest.High * Square * P + A.Rest.Low * (1.0f + Square);
  FloatPair Tangent = fastTwoSum(A.Rest.High, Rest);
  if (!(A.Quadrant & 1))
    return Tangent.High;
  return divide(-1.0f, Tangent).High;
}

} // namespace tp
