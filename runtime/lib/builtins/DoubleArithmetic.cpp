//===- DoubleArithmetic.cpp - IEEE double in 32-bit integer code ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Round to nearest, ties to even; subnormals kept; every NaN result is the same
// quiet NaN. No flags.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"

using namespace tp::soft;
using namespace tp::wide;

static uint64_t add(uint64_t A, uint64_t B) {
  uint64_t MagnitudeA = A & ~kSign;
  uint64_t MagnitudeB = B & ~kSign;
  if (MagnitudeA < MagnitudeB) {
    uint64_t T = A;
    A = B;
    B = T;
    T = MagnitudeA;
    MagnitudeA = MagnitudeB;
    MagnitudeB = T;
  }
  uint64_t Sign = A & kSign;
  uint64_t Differ = (A ^ B) & kSign;
  if (MagnitudeA >= kInfinity) {
    if (MagnitudeA > kInfinity || (MagnitudeB == kInfinity && Differ))
      return kNaN;
    return A;
  }
  if (MagnitudeB == 0) {
    if (MagnitudeA == 0)
      return A & B;
    return A;
  }
  // One bit of room above for the carry.
  Unpacked UA = unpack(MagnitudeA);
  Unpacked UB = unpack(MagnitudeB);
  uint64_t Larger = UA.Significand >> 1;
  uint64_t Smaller =
      shiftRightSticky(UB.Significand >> 1, UA.Exponent - UB.Exponent);
  uint64_t Sum = Differ ? Larger - Smaller : Larger + Smaller;
  if (Sum == 0)
    return 0;
  int Shift = leadingZeros(Sum);
  return pack(Sign, UA.Exponent + 1 - Shift, Sum << Shift);
}

static uint64_t multiplyDoubles(uint64_t A, uint64_t B) {
  uint64_t Sign = (A ^ B) & kSign;
  A &= ~kSign;
  B &= ~kSign;
  if (A >= kInfinity || B >= kInfinity) {
    if (A > kInfinity || B > kInfinity || A == 0 || B == 0)
      return kNaN;
    return Sign | kInfinity;
  }
  if (A == 0 || B == 0)
    return Sign;
  Unpacked UA = unpack(A);
  Unpacked UB = unpack(B);
  Integer128 P = multiply(UA.Significand, UB.Significand);
  int Exponent = UA.Exponent + UB.Exponent - kBias + 1;
  if (!(P.High & kSign)) {
    P.High = P.High << 1 | P.Low >> 63;
    P.Low <<= 1;
    --Exponent;
  }
  return pack(Sign, Exponent, P.High | (P.Low != 0));
}

static uint64_t divideDoubles(uint64_t A, uint64_t B) {
  uint64_t Sign = (A ^ B) & kSign;
  A &= ~kSign;
  B &= ~kSign;
  if (A >= kInfinity || B >= kInfinity) {
    if (A > kInfinity || B > kInfinity || A == B)
      return kNaN;
    return A == kInfinity ? Sign | kInfinity : Sign;
  }
  if (B == 0)
    return A == 0 ? kNaN : Sign | kInfinity;
  if (A == 0)
    return Sign;
  Unpacked UA = unpack(A);
  Unpacked UB = unpack(B);
  int Exponent = UA.Exponent - UB.Exponent + kBias;
  uint64_t Partial = UA.Significand;
  if (Partial >= UB.Significand)
    Partial >>= 1;
  else
    --Exponent;
  uint32_t QuotientHigh = divideDigit(Partial, UB.Significand);
  uint32_t QuotientLow = divideDigit(Partial, UB.Significand);
  return pack(Sign, Exponent, make(QuotientHigh, QuotientLow) | (Partial != 0));
}

/// Bit by bit: Root is the root of the bits of the radicand taken so far, Rest
/// what they exceed its square by.
static uint64_t squareRoot(uint64_t A) {
  uint64_t Magnitude = A & ~kSign;
  if (Magnitude == 0)
    return A;
  if (Magnitude > kInfinity || (A & kSign))
    return kNaN;
  if (Magnitude == kInfinity)
    return A;
  Unpacked U = unpack(Magnitude);
  int Exponent = U.Exponent - kBias;
  uint64_t Radicand = Exponent & 1 ? U.Significand : U.Significand >> 1;
  uint64_t Root = 0;
  uint64_t Rest = 0;
  for (int Bit = 0; Bit != 55; ++Bit) {
    Rest = Rest << 2 | Radicand >> 62;
    Radicand <<= 2;
    Root <<= 1;
    uint64_t Trial = Root << 1 | 1;
    if (Rest >= Trial) {
      Rest -= Trial;
      Root |= 1;
    }
  }
  return pack(0, (Exponent >> 1) + kBias, Root << 9 | (Rest != 0));
}

static bool less(const Integer128 &A, const Integer128 &B) {
  return A.High != B.High ? A.High < B.High : A.Low < B.Low;
}

static Integer128 shiftRightSticky(Integer128 P, int Shift) {
  if (Shift == 0)
    return P;
  if (Shift >= 64)
    return {tp::wide::shiftRightSticky(P.High | (P.Low != 0), Shift - 64), 0};
  uint64_t Lost = P.Low << (64 - Shift);
  return {P.High << (64 - Shift) | P.Low >> Shift | (Lost != 0),
          P.High >> Shift};
}

static uint64_t multiplyAdd(uint64_t A, uint64_t B, uint64_t C) {
  uint64_t MagnitudeA = A & ~kSign;
  uint64_t MagnitudeB = B & ~kSign;
  uint64_t MagnitudeC = C & ~kSign;
  if (MagnitudeA == 0 || MagnitudeB == 0 || MagnitudeC == 0 ||
      MagnitudeA >= kInfinity || MagnitudeB >= kInfinity ||
      MagnitudeC >= kInfinity) {
    // A finite product that overflows must not hide an infinite sum.
    if (MagnitudeA < kInfinity && MagnitudeB < kInfinity &&
        MagnitudeC >= kInfinity)
      return MagnitudeC > kInfinity ? kNaN : C;
    uint64_t Product = multiplyDoubles(A, B);
    bool ProductIsZero = MagnitudeA == 0 || MagnitudeB == 0;
    return MagnitudeC == 0 && !ProductIsZero ? Product : add(Product, C);
  }
  uint64_t Sign = (A ^ B) & kSign;
  Unpacked UA = unpack(MagnitudeA);
  Unpacked UB = unpack(MagnitudeB);
  Unpacked UC = unpack(MagnitudeC);
  Integer128 P = multiply(UA.Significand, UB.Significand);
  int Exponent = UA.Exponent + UB.Exponent - kBias + 1;
  if (!(P.High & kSign)) {
    P = {P.Low << 1, P.High << 1 | P.Low >> 63};
    --Exponent;
  }
  Integer128 Q = {0, UC.Significand};
  int ExponentC = UC.Exponent;
  bool Subtract = ((Sign ^ C) & kSign) != 0;
  if (ExponentC > Exponent || (ExponentC == Exponent && less(P, Q))) {
    Integer128 T = P;
    P = Q;
    Q = T;
    int E = Exponent;
    Exponent = ExponentC;
    ExponentC = E;
    Sign = C & kSign;
  }
  // One bit of room above for the carry, at both sides of the sum.
  P = shiftRightSticky(P, 1);
  Q = shiftRightSticky(Q, 1 + Exponent - ExponentC);
  Integer128 Sum;
  if (Subtract) {
    Sum = {P.Low - Q.Low, P.High - Q.High - (P.Low < Q.Low)};
  } else {
    uint64_t Low = P.Low + Q.Low;
    Sum = {Low, P.High + Q.High + (Low < P.Low)};
  }
  ++Exponent;
  if (Sum.High == 0) {
    if (Sum.Low == 0)
      return 0;
    Sum = {0, Sum.Low};
    Exponent -= 64;
  }
  int Shift = leadingZeros(Sum.High);
  if (Shift != 0)
    Sum = {Sum.Low << Shift, Sum.High << Shift | Sum.Low >> (64 - Shift)};
  return pack(Sign, Exponent - Shift, Sum.High | (Sum.Low != 0));
}

extern "C" {

double TP_LIBCALL(__adddf3)(double A, double B) {
  return fromBits(add(bits(A), bits(B)));
}

double TP_LIBCALL(__subdf3)(double A, double B) {
  return fromBits(add(bits(A), bits(B) ^ kSign));
}

double TP_LIBCALL(__muldf3)(double A, double B) {
  return fromBits(multiplyDoubles(bits(A), bits(B)));
}

double TP_LIBCALL(__divdf3)(double A, double B) {
  return fromBits(divideDoubles(bits(A), bits(B)));
}

double TP_LIBCALL(__negdf2)(double A) { return fromBits(bits(A) ^ kSign); }

double TP_LIBCALL(__tp_sqrtdf)(double A) {
  return fromBits(squareRoot(bits(A)));
}

double TP_LIBCALL(__tp_fmadf)(double A, double B, double C) {
  return fromBits(multiplyAdd(bits(A), bits(B), bits(C)));
}

} // extern "C"
