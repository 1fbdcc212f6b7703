//===- InverseTrigonometric.cpp - asin, acos, atan, atan2 of floats -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The polynomials are Chebyshev fits.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/FloatParts.h"

namespace tp {

constexpr FloatPair Pi = {0x1.921fb6p+1f, -0x1.777a5cp-24f};
constexpr FloatPair HalfPi = {0x1.921fb6p+0f, -0x1.777a5cp-25f};
constexpr FloatPair QuarterPi = {0x1.921fb6p-1f, -0x1.777a5cp-26f};

/// asin(X) - X divided by X, for X^2 = \p Square <= 1/4; 2^-28.
static inline float asinTail(float Square) {
  float P = 0x1.18f91ep-6f + Square * 0x1.13fed4p-5f;
  P = 0x1.fd8da2p-6f + Square * P;
  P = 0x1.6d5bbap-5f + Square * P;
  P = 0x1.333430p-4f + Square * P;
  P = 0x1.555554p-3f + Square * P;
  return Square * P;
}

/// asin(sqrt(\p Square)) for 0 < \p Square <= 1/4.
static inline FloatPair asinOfRoot(float Square) {
  float Root = sqrt(Square);
  FloatPair P = twoProduct(Root, Root);
  float RootLow = ((Square - P.High) - P.Low) / (Root + Root);
  return fastTwoSum(Root, Root * asinTail(Square) + RootLow);
}

/// atan(X) for X = \p X.High + \p X.Low, |X| <= tan(pi/8); 2^-29.
static inline FloatPair atanOf(FloatPair X) {
  float Square = X.High * X.High;
  float P = -0x1.614378p-4f + Square * 0x1.9d86ecp-5f;
  P = 0x1.c57b92p-4f + Square * P;
  P = -0x1.248a16p-3f + Square * P;
  P = 0x1.99997cp-3f + Square * P;
  P = -0x1.555556p-2f + Square * P;
  return {X.High, X.High * Square * P + X.Low * (1.0f - Square)};
}

/// atan(\p Y / \p X) for finite numbers above 0 whose quotient neither
/// overflows nor is subnormal.
static inline FloatPair atanOfQuotient(float Y, float X) {
  constexpr float TanEighthPi = 0x1.a8279ap-2f;
  if (Y <= X * TanEighthPi)
    return atanOf(divide(Y, {X, 0.0f}));
  if (X <= Y * TanEighthPi) {
    FloatPair A = atanOf(divide(-X, {Y, 0.0f}));
    FloatPair S = fastTwoSum(HalfPi.High, A.High);
    return {S.High, S.Low + (HalfPi.Low + A.Low)};
  }
  FloatPair Difference = twoSum(Y, -X);
  FloatPair T = divide(Difference.High, twoSum(Y, X));
  T.Low += Difference.Low / (Y + X);
  FloatPair A = atanOf(T);
  FloatPair S = fastTwoSum(QuarterPi.High, A.High);
  return {S.High, S.Low + (QuarterPi.Low + A.Low)};
}

float asin(float X) {
  float Magnitude = fabs(X);
  if (!(Magnitude <= 1.0f))
    return floatNaN();
  if (Magnitude < 0x1p-12f)
    return X;
  if (Magnitude < 0.5f)
    return X + X * asinTail(X * X);
  if (Magnitude == 1.0f)
    return copysign(HalfPi.High, X);
  FloatPair A = asinOfRoot((1.0f - Magnitude) * 0.5f);
  FloatPair S = fastTwoSum(HalfPi.High, -2.0f * A.High);
  return copysign(S.High + (S.Low + (HalfPi.Low - 2.0f * A.Low)), X);
}

float acos(float X) {
  float Magnitude = fabs(X);
  if (!(Magnitude <= 1.0f))
    return floatNaN();
  if (Magnitude < 0.5f) {
    FloatPair S = fastTwoSum(HalfPi.High, -X);
    float Tail = Magnitude < 0x1p-12f ? 0.0f : X * asinTail(X * X);
    return S.High + (S.Low + (HalfPi.Low - Tail));
  }
  if (Magnitude == 1.0f)
    return X > 0.0f ? 0.0f : Pi.High;
  FloatPair A = asinOfRoot((1.0f - Magnitude) * 0.5f);
  if (X > 0.0f)
    return 2.0f * (A.High + A.Low);
  FloatPair S = fastTwoSum(Pi.High, -2.0f * A.High);
  return S.High + (S.Low + (Pi.Low - 2.0f * A.Low));
}

float atan(float X) {
  float Magnitude = fabs(X);
  if (X != X)
    return floatNaN();
  if (Magnitude < 0x1p-12f)
    return X;
  if (Magnitude > 0x1p26f)
    return copysign(HalfPi.High, X);
  FloatPair A = atanOfQuotient(Magnitude, 1.0f);
  return copysign(A.High + A.Low, X);
}

float atan2(float Y, float X) {
  if (X != X || Y != Y)
    return floatNaN();
  uint32_t MagnitudeX = floatBits(X) & ~kFloatSign;
  uint32_t MagnitudeY = floatBits(Y) & ~kFloatSign;
  bool Left = (floatBits(X) & kFloatSign) != 0;
  if (MagnitudeX == kFloatInfinity && MagnitudeY == kFloatInfinity)
    return copysign(Left ? 0x1.2d97c8p+1f : QuarterPi.High, Y);
  int Ratio =
      static_cast<int>(MagnitudeY >> 23) - static_cast<int>(MagnitudeX >> 23);
  if (MagnitudeX == 0 && MagnitudeY == 0)
    return copysign(Left ? Pi.High : 0.0f, Y);
  // The axes and what is nearer to them than the result can show.
  if (MagnitudeX == 0 || MagnitudeY == kFloatInfinity || Ratio > 27)
    return copysign(HalfPi.High, Y);
  if (Left && (MagnitudeY == 0 || MagnitudeX == kFloatInfinity || Ratio < -27))
    return copysign(Pi.High, Y);
  if (MagnitudeY == 0 || MagnitudeX == kFloatInfinity)
    return copysign(0.0f, Y);
  if (Ratio < -27)
    return Y / X;

  // Both to where no product overflows or is subnormal.
  float A = floatFromBits(MagnitudeY);
  float B = floatFromBits(MagnitudeX);
  if (MagnitudeX > floatBits(0x1p60f) || MagnitudeY > floatBits(0x1p60f)) {
    A *= 0x1p-64f;
    B *= 0x1p-64f;
  } else if (MagnitudeX < floatBits(0x1p-60f) ||
             MagnitudeY < floatBits(0x1p-60f)) {
    A *= 0x1p64f;
    B *= 0x1p64f;
    if (B < 0x1p-60f || A < 0x1p-60f) {
      A *= 0x1p40f;
      B *= 0x1p40f;
    }
  }
  FloatPair Angle = atanOfQuotient(A, B);
  if (!Left)
    return copysign(Angle.High + Angle.Low, Y);
  FloatPair S = fastTwoSum(Pi.High, -Angle.High);
  return copysign(S.High + (S.Low + (Pi.Low - Angle.Low)), Y);
}

} // namespace tp
