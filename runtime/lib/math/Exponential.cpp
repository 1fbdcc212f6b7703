//===- Exponential.cpp - Powers and logarithms of floats ------------------===//
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

constexpr FloatPair Ln2 = {0x1.62e430p-1f, -0x1.05c610p-29f};
constexpr FloatPair Log10Of2 = {0x1.344136p-2f, -0x1.ec10c0p-27f};
/// ln 2 so that its product with any float's exponent is exact, and the rest.
constexpr FloatPair Ln2Exact = {0x1.62e400p-1f, 0x1.7f7d1cp-20f};

/// 2^(High + Low) for results from the smallest subnormal to below infinity;
/// 2^-31.
static float exponential2(FloatPair X) {
  float Whole = rint(X.High);
  FloatPair Fraction = twoSum(X.High - Whole, X.Low);
  float Rest = Fraction.High;
  float P = 0x1.4413a4p-13f + Rest * 0x1.008a30p-16f;
  P = 0x1.5d87c0p-10f + Rest * P;
  P = 0x1.3b2a52p-7f + Rest * P;
  P = 0x1.c6b08ep-5f + Rest * P;
  P = 0x1.ebfbe0p-3f + Rest * P;
  FloatPair Linear = twoProduct(Rest, Ln2.High);
  FloatPair Sum = fastTwoSum(1.0f, Linear.High);
  float Tail = Rest * Rest * P +
               (Linear.Low + (Fraction.Low * Ln2.High + Rest * Ln2.Low));
  return scale(Sum.High + (Sum.Low + Tail), static_cast<int>(Whole));
}

/// Whether \p Y is an integer, and if so, odd: 0, 1 (even) or 2 (odd). A float
/// from 2^24 on is even.
static int integerKind(float Y) {
  float Magnitude = fabs(Y);
  if (Magnitude >= 0x1p24f)
    return 1;
  int Whole = static_cast<int>(Magnitude);
  if (static_cast<float>(Whole) != Magnitude)
    return 0;
  return 1 + (Whole & 1);
}

FloatPair logarithm2(uint32_t Bits) {
  int Exponent;
  float F = splitAroundOne(Bits, Exponent) - 1.0f;
  if (F == 0.0f)
    return {static_cast<float>(Exponent), 0.0f};
  // ln(1 + F) is 2 atanh(S).
  FloatPair S = divide(F, fastTwoSum(2.0f, F));
  FloatPair Square = multiply(S, S);
  float T = 0x1.c6c0e8p-4f + Square.High * 0x1.879640p-4f;
  T = 0x1.24928ep-3f + Square.High * T;
  T = 0x1.99999ap-3f + Square.High * T;
  // The series starts with 1/3.
  FloatPair P = fastTwoSum(0x1.555556p-2f, Square.High * T);
  P.Low += -0x1.555556p-27f;
  FloatPair Sum = add(1.0f, multiply(Square, P));
  // 2 / ln 2.
  FloatPair L =
      multiply(multiply(S, Sum), FloatPair{0x1.715476p+1f, 0x1.4ae0c0p-25f});
  return Exponent != 0 ? add(static_cast<float>(Exponent), L) : L;
}

FloatPair logarithm(FloatPair X) {
  return sum(multiply(logarithm2(floatBits(X.High)), Ln2), X.Low / X.High);
}

namespace {

/// e^X is 2^Whole (1 + High + Low).
struct SplitExponential {
  int Whole;
  FloatPair Fraction;
};

} // namespace

static inline SplitExponential splitExponential(float X) {
  float Whole = rint(X * 0x1.715476p+0f);
  float High = X - Whole * Ln2Exact.High;
  float Low = Whole * Ln2Exact.Low;
  FloatPair Rest = twoSum(High, -Low);
  float R = Rest.High;
  float P = 0x1.120b7ep-7f + R * 0x1.6d1118p-10f;
  P = 0x1.55551ap-5f + R * P;
  P = 0x1.5554dcp-3f + R * P;
  P = 0x1.000000p-1f + R * P;
  return {static_cast<int>(Whole), {R, Rest.Low + R * R * P}};
}

static inline float scaledExponential(float X, int Shift) {
  SplitExponential E = splitExponential(X);
  FloatPair Sum = fastTwoSum(1.0f, E.Fraction.High);
  return scale(Sum.High + (Sum.Low + E.Fraction.Low), E.Whole + Shift);
}

float exp(float X) {
  if (X != X)
    return floatNaN();
  if (X > 0x1.62e42ep+6f)
    return floatInfinity();
  if (X < -0x1.9fe36ap+6f)
    return 0.0f;
  return scaledExponential(X, 0);
}

float exponential(float X, int Shift) {
  if (X != X)
    return floatNaN();
  if (X > 100.0f)
    return floatInfinity();
  if (X < -120.0f)
    return 0.0f;
  return scaledExponential(X, Shift);
}

FloatPair exponentialMinus1(float X) {
  SplitExponential E = splitExponential(X);
  FloatPair Fraction = fastTwoSum(E.Fraction.High, E.Fraction.Low);
  float Scale = powerOfTwo(E.Whole);
  return sum(twoSum(Scale, -1.0f),
             {Fraction.High * Scale, Fraction.Low * Scale});
}

float exp2(float X) {
  if (X != X)
    return floatNaN();
  if (X >= 128.0f)
    return floatInfinity();
  if (X < -150.0f)
    return 0.0f;
  return exponential2({X, 0.0f});
}

float log(float X) {
  uint32_t Bits = floatBits(X);
  if ((Bits & ~kFloatSign) == 0)
    return -floatInfinity();
  if ((Bits & ~kFloatSign) > kFloatInfinity || (Bits & kFloatSign))
    return floatNaN();
  if (Bits == kFloatInfinity)
    return X;
  int Exponent;
  float F = splitAroundOne(Bits, Exponent) - 1.0f;
  // ln(1 + F) = F - F^2/2 + S (F^2/2 + R) with S = F / (2 + F); 2^-30.
  float S = F / (2.0f + F);
  float Square = S * S;
  float R = 0x1.245c40p-2f + Square * 0x1.ddcf72p-3f;
  R = 0x1.9999ecp-2f + Square * R;
  R = 0x1.555556p-1f + Square * R;
  R *= Square;
  FloatPair HalfSquare = twoProduct(0.5f * F, F);
  FloatPair Start = twoSum(F, -HalfSquare.High);
  float Whole = static_cast<float>(Exponent);
  FloatPair Sum = twoSum(Whole * Ln2Exact.High, Start.High);
  float Tail = S * (HalfSquare.High + R) - HalfSquare.Low;
  return Sum.High + (Sum.Low + (Start.Low + (Tail + Whole * Ln2Exact.Low)));
}

float log2(float X) {
  uint32_t Bits = floatBits(X);
  if ((Bits & ~kFloatSign) == 0)
    return -floatInfinity();
  if ((Bits & ~kFloatSign) > kFloatInfinity || (Bits & kFloatSign))
    return floatNaN();
  if (Bits == kFloatInfinity)
    return X;
  return logarithm2(Bits).High;
}

float log10(float X) {
  uint32_t Bits = floatBits(X);
  if ((Bits & ~kFloatSign) == 0)
    return -floatInfinity();
  if ((Bits & ~kFloatSign) > kFloatInfinity || (Bits & kFloatSign))
    return floatNaN();
  if (Bits == kFloatInfinity)
    return X;
  return multiply(logarithm2(Bits), Log10Of2).High;
}

float pow(float X, float Y) {
  if (Y == 0.0f || X == 1.0f)
    return 1.0f;
  if (X != X || Y != Y)
    return floatNaN();
  uint32_t Magnitude = floatBits(X) & ~kFloatSign;
  bool Negative = (floatBits(X) & kFloatSign) != 0;
  int Kind = integerKind(Y);
  bool NegateResult = Negative && Kind == 2;
  if (Magnitude == 0 || Magnitude == kFloatInfinity) {
    bool Zero = (Magnitude == 0) == (Y > 0.0f);
    float Result = Zero ? 0.0f : floatInfinity();
    return NegateResult ? -Result : Result;
  }
  if (Magnitude == kFloatOne && fabs(Y) == floatInfinity())
    return 1.0f;
  if (Negative && Kind == 0)
    return floatNaN();

  // From 2^31 on, every power but those of 1 overflows or vanishes; below
  // 2^-40 all round to 1.
  FloatPair L = logarithm2(Magnitude);
  float Result;
  if (fabs(Y) < 0x1p-40f || Magnitude == kFloatOne) {
    Result = 1.0f;
  } else {
    float Estimate = L.High * Y;
    if (Estimate > 129.0f) {
      Result = floatInfinity();
    } else if (Estimate < -152.0f) {
      Result = 0.0f;
    } else {
      FloatPair Exponent = multiply(L, Y);
      if (Exponent.High > 128.0f ||
          (Exponent.High == 128.0f && Exponent.Low >= 0.0f))
        Result = floatInfinity();
      else
        Result = exponential2(Exponent);
    }
  }
  return NegateResult ? -Result : Result;
}

} // namespace tp
