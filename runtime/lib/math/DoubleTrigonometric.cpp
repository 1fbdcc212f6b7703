//===- DoubleTrigonometric.cpp - sin, cos, tan of doubles -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// As in Trigonometric.cpp, with wider integers.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"

using namespace tp;
using namespace tp::soft;

namespace {

struct ReducedAngle {
  DoublePair Rest;
  uint32_t Quadrant;
};

} // namespace

/// 64 zeros, then the bits of 2/pi behind the point.
constexpr uint32_t TwoOverPi[] = {
    0x00000000, 0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0,
    0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0,
    0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
    0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7,
    0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea,
    0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20};

/// 64 bits of the table from \p Bit on.
static uint64_t twoOverPiBits(uint32_t Bit) {
  const uint32_t *Word = TwoOverPi + Bit / 32;
  uint32_t Shift = Bit % 32;
  uint64_t Bits = wide::make(Word[0], Word[1]);
  return Shift == 0 ? Bits : Bits << Shift | Word[2] >> (32 - Shift);
}

constexpr double QuarterPi = 0x1.921fb54442d18p-1;

/// For finite \p X.
static ReducedAngle reduce(double X) {
  uint64_t Bits = bits(X);
  uint64_t Magnitude = Bits & ~kSign;
  if (Magnitude <= bits(QuarterPi))
    return {{X, 0.0}, 0};

  // |X| is Integer * 2^(Exponent - 1075).
  uint64_t Integer = Magnitude << 12 >> 12 | uint64_t(1) << 52;
  uint32_t Start = static_cast<uint32_t>(Magnitude >> 52) - 1075 - 2 + 64;
  wide::Integer128 Low = wide::multiply(Integer, twoOverPiBits(Start + 128));
  wide::Integer128 Middle = wide::multiply(Integer, twoOverPiBits(Start + 64));
  // The top two bits are the quadrant, the others the fraction of the next.
  uint64_t TurnsLow = Middle.Low + Low.High;
  uint64_t TurnsHigh =
      Integer * twoOverPiBits(Start) + Middle.High + (TurnsLow < Low.High);
  uint32_t Quadrant =
      static_cast<uint32_t>((TurnsHigh + (uint64_t(1) << 61)) >> 62);
  uint64_t FractionHigh = TurnsHigh << 2 | TurnsLow >> 62;
  uint64_t FractionLow = TurnsLow << 2;
  uint64_t Sign = Bits & kSign;
  if (FractionHigh >> 63 != 0) {
    FractionLow = -FractionLow;
    FractionHigh = ~FractionHigh + (FractionLow == 0);
    Sign ^= kSign;
  }
  if (Bits & kSign)
    Quadrant = -Quadrant;

  int Shift = 0;
  if (FractionHigh == 0) {
    FractionHigh = FractionLow | 1;
    FractionLow = 0;
    Shift = 64;
  }
  int Zeros = wide::leadingZeros(FractionHigh);
  if (Zeros != 0) {
    FractionHigh = FractionHigh << Zeros | FractionLow >> (64 - Zeros);
    Shift += Zeros;
  }
  // pi/2 as a 64-bit integer has a weight of 2^-63.
  wide::Integer128 Angle = wide::multiply(FractionHigh, 0xC90FDAA22168C234u);
  double Unit =
      fromBits(Sign | static_cast<uint64_t>(1023 - 63 + 11 - Shift) << 52);
  double RestHigh =
      static_cast<double>(static_cast<int64_t>(Angle.High >> 11)) * Unit;
  uint64_t Lower = (Angle.High & 0x7FF) << 42 | Angle.Low >> 22;
  double RestLow =
      static_cast<double>(static_cast<int64_t>(Lower)) * (Unit * 0x1p-53);
  return {{RestHigh, RestLow}, Quadrant & 3};
}

/// sin(R) = R.High + the result, for |R| <= pi/4; 2^-57.
static double sineTail(DoublePair R) {
  static const double P[] = {-0x1.5555555555555p-3,  0x1.1111111111110p-7,
                             -0x1.a01a01a019938p-13, 0x1.71de3a546095bp-19,
                             -0x1.ae645412c55f8p-26, 0x1.61217f0b7f164p-33,
                             -0x1.ab17d4044cb77p-41};
  double Square = R.High * R.High;
  return R.High * Square * polynomial(Square, P) + R.Low * (1.0 - 0.5 * Square);
}

/// cos(R) for |R| <= pi/4; 2^-60.
static DoublePair cosineOf(DoublePair R) {
  static const double Q[] = {0x1.5555555555555p-5,  -0x1.6c16c16c16c16p-10,
                             0x1.a01a01a019d0ap-16, -0x1.27e4fb7712d65p-22,
                             0x1.1eed8deb97a8fp-29, -0x1.9394ba0cd6119p-37,
                             0x1.ab785b0032d5ep-45};
  DoublePair Square = twoProduct(R.High, R.High);
  DoublePair Start = fastTwoSum(1.0, -0.5 * Square.High);
  double Rest = Square.High * Square.High * polynomial(Square.High, Q);
  return fastTwoSum(Start.High,
                    Start.Low + (Rest - (0.5 * Square.Low + R.High * R.Low)));
}

/// Below this sin and tan of X are X, and the products would be subnormal.
constexpr double Tiny = 0x1p-27;

static bool isFinite(double X) { return (bits(X) & ~kSign) < kInfinity; }

extern "C" {

double TP_LIBCALL(sin)(double X) {
  if (!isFinite(X))
    return doubleNaN();
  if (magnitudeOf(X) < Tiny)
    return X;
  ReducedAngle A = reduce(X);
  double Result =
      A.Quadrant & 1 ? cosineOf(A.Rest).High : A.Rest.High + sineTail(A.Rest);
  return A.Quadrant & 2 ? -Result : Result;
}

double TP_LIBCALL(cos)(double X) {
  if (!isFinite(X))
    return doubleNaN();
  if (magnitudeOf(X) < Tiny)
    return 1.0;
  ReducedAngle A = reduce(X);
  double Result =
      A.Quadrant & 1 ? A.Rest.High + sineTail(A.Rest) : cosineOf(A.Rest).High;
  return (A.Quadrant + 1) & 2 ? -Result : Result;
}

double TP_LIBCALL(tan)(double X) {
  if (!isFinite(X))
    return doubleNaN();
  if (magnitudeOf(X) < Tiny)
    return X;
  ReducedAngle A = reduce(X);
  DoublePair Sine = fastTwoSum(A.Rest.High, sineTail(A.Rest));
  DoublePair Cosine = cosineOf(A.Rest);
  if (A.Quadrant & 1) {
    DoublePair Quotient = divide(-Cosine.High, Sine);
    return Quotient.High + (Quotient.Low - Cosine.Low / Sine.High);
  }
  DoublePair Quotient = divide(Sine.High, Cosine);
  return Quotient.High + (Quotient.Low + Sine.Low / Cosine.High);
}

} // extern "C"
