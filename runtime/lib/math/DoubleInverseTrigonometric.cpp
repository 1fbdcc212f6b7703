//===- DoubleInverseTrigonometric.cpp - asin ... atan2 of doubles ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// As in InverseTrigonometric.cpp, with longer polynomials.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"

using namespace tp;
using namespace tp::soft;

constexpr DoublePair Pi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoublePair HalfPi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr DoublePair QuarterPi = {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};

/// asin(X) - X divided by X, for X^2 = \p Square <= 1/4; 2^-57.
static double asinTail(double Square) {
  static const double P[] = {
      0x1.5555555555556p-3, 0x1.3333333332ecap-4, 0x1.6db6db6e31f13p-5,
      0x1.f1c71c1db0623p-6, 0x1.6e8bb1c8209a2p-6, 0x1.1c4d35cf95421p-6,
      0x1.c9cf07674736ap-7, 0x1.782651caa6547p-7, 0x1.52420b04b37bep-7,
      0x1.65a9c4dfcf8b2p-8, 0x1.1d189408314eep-6, -0x1.e6aaa8a0a04ccp-7,
      0x1.d72b2bc8155f8p-6};
  return Square * polynomial(Square, P);
}

/// asin(sqrt(\p Square)) for 0 < \p Square <= 1/4.
static DoublePair asinOfRoot(double Square) {
  double Root = TP_LIBCALL(__tp_sqrtdf)(Square);
  DoublePair P = twoProduct(Root, Root);
  double RootLow = ((Square - P.High) - P.Low) / (Root + Root);
  return fastTwoSum(Root, Root * asinTail(Square) + RootLow);
}

/// atan(X) for |X| <= tan(pi/8); 2^-58.
static DoublePair atanOf(DoublePair X) {
  static const double P[] = {
      -0x1.5555555555555p-2, 0x1.9999999999953p-3,  -0x1.249249248d7eep-3,
      0x1.c71c71c304b64p-4,  -0x1.745d165df3ee7p-4, 0x1.3b1392d9e64b0p-4,
      -0x1.110e880a643d8p-4, 0x1.e19a13b800ab6p-5,  -0x1.ac7a937cce153p-5,
      0x1.74ddd3c6187b4p-5,  -0x1.1b33b8784aa69p-5, 0x1.0ad368c98424cp-6};
  double Square = X.High * X.High;
  return {X.High,
          X.High * Square * polynomial(Square, P) + X.Low * (1.0 - Square)};
}

/// atan(\p Y / \p X) for numbers above 0 at which no product overflows or is
/// subnormal.
static DoublePair atanOfQuotient(double Y, double X) {
  constexpr double TanEighthPi = 0x1.a827999fcef32p-2;
  if (Y <= X * TanEighthPi)
    return atanOf(divide(Y, {X, 0.0}));
  if (X <= Y * TanEighthPi) {
    DoublePair A = atanOf(divide(-X, {Y, 0.0}));
    DoublePair S = fastTwoSum(HalfPi.High, A.High);
    return {S.High, S.Low + (HalfPi.Low + A.Low)};
  }
  DoublePair Difference = twoSum(Y, -X);
  DoublePair T = divide(Difference.High, twoSum(Y, X));
  T.Low += Difference.Low / (Y + X);
  DoublePair A = atanOf(T);
  DoublePair S = fastTwoSum(QuarterPi.High, A.High);
  return {S.High, S.Low + (QuarterPi.Low + A.Low)};
}

extern "C" {

double TP_LIBCALL(asin)(double X) {
  double Magnitude = magnitudeOf(X);
  if (!(Magnitude <= 1.0))
    return doubleNaN();
  if (Magnitude < 0x1p-27)
    return X;
  if (Magnitude < 0.5)
    return X + X * asinTail(X * X);
  if (Magnitude == 1.0)
    return withSign(HalfPi.High, X);
  DoublePair A = asinOfRoot((1.0 - Magnitude) * 0.5);
  DoublePair S = fastTwoSum(HalfPi.High, -2.0 * A.High);
  return withSign(S.High + (S.Low + (HalfPi.Low - 2.0 * A.Low)), X);
}

double TP_LIBCALL(acos)(double X) {
  double Magnitude = magnitudeOf(X);
  if (!(Magnitude <= 1.0))
    return doubleNaN();
  if (Magnitude < 0.5) {
    DoublePair S = fastTwoSum(HalfPi.High, -X);
    double Tail = Magnitude < 0x1p-27 ? 0.0 : X * asinTail(X * X);
    return S.High + (S.Low + (HalfPi.Low - Tail));
  }
  if (Magnitude == 1.0)
    return X > 0.0 ? 0.0 : Pi.High;
  DoublePair A = asinOfRoot((1.0 - Magnitude) * 0.5);
  if (X > 0.0)
    return 2.0 * (A.High + A.Low);
  DoublePair S = fastTwoSum(Pi.High, -2.0 * A.High);
  return S.High + (S.Low + (Pi.Low - 2.0 * A.Low));
}

double TP_LIBCALL(atan)(double X) {
  double Magnitude = magnitudeOf(X);
  if (isNaN(X))
    return doubleNaN();
  if (Magnitude < 0x1p-27)
    return X;
  if (Magnitude > 0x1p55)
    return withSign(HalfPi.High, X);
  DoublePair A = atanOfQuotient(Magnitude, 1.0);
  return withSign(A.High + A.Low, X);
}

double TP_LIBCALL(atan2)(double Y, double X) {
  if (isNaN(X) || isNaN(Y))
    return doubleNaN();
  uint64_t MagnitudeX = bits(X) & ~kSign;
  uint64_t MagnitudeY = bits(Y) & ~kSign;
  bool Left = (bits(X) & kSign) != 0;
  if (MagnitudeX == kInfinity && MagnitudeY == kInfinity)
    return withSign(Left ? 0x1.2d97c7f3321d2p+1 : QuarterPi.High, Y);
  if (MagnitudeX == 0 && MagnitudeY == 0)
    return withSign(Left ? Pi.High : 0.0, Y);
  // The axes and what is nearer to them than the result can show.
  int Ratio =
      static_cast<int>(MagnitudeY >> 52) - static_cast<int>(MagnitudeX >> 52);
  if (MagnitudeX == 0 || MagnitudeY == kInfinity || Ratio > 56)
    return withSign(HalfPi.High, Y);
  if (Left && (MagnitudeY == 0 || MagnitudeX == kInfinity || Ratio < -56))
    return withSign(Pi.High, Y);
  if (MagnitudeY == 0 || MagnitudeX == kInfinity)
    return withSign(0.0, Y);
  if (Ratio < -56)
    return Y / X;

  // Both to where no product overflows or is subnormal.
  int Shift = kBias - static_cast<int>(MagnitudeX >> 52);
  double A = TP_LIBCALL(ldexp)(fromBits(MagnitudeY), Shift);
  double B = TP_LIBCALL(ldexp)(fromBits(MagnitudeX), Shift);
  DoublePair Angle = atanOfQuotient(A, B);
  if (!Left)
    return withSign(Angle.High + Angle.Low, Y);
  DoublePair S = fastTwoSum(Pi.High, -Angle.High);
  return withSign(S.High + (S.Low + (Pi.Low - Angle.Low)), Y);
}

} // extern "C"
