//===- Integer128Convert.cpp - 128-bit integers, float and double ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// As for narrower integers: conversions from floating point cut the fraction
// off, values out of range become the nearest one, and NaN becomes 0.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"

using namespace tp::soft;
using namespace tp::wide;

namespace {

/// A magnitude with its sign.
struct Whole128 {
  bool Negative;
  Integer128 Magnitude;
};

} // namespace

static inline Integer128 negate(Integer128 A) {
  return {-A.Low, ~A.High + (A.Low == 0)};
}

static Whole128 wholePart(double A) {
  uint64_t Bits = bits(A);
  uint64_t Magnitude = Bits & ~kSign;
  bool Negative = (Bits & kSign) != 0;
  if (Magnitude < uint64_t(kBias) << 52 || Magnitude > kInfinity)
    return {false, {0, 0}};
  Unpacked U = unpack(Magnitude);
  int Exponent = U.Exponent - kBias;
  if (Exponent > 127)
    return {Negative, {~uint64_t(0), ~uint64_t(0)}};
  if (Exponent < 64)
    return {Negative, {U.Significand >> (63 - Exponent), 0}};
  int Shift = 127 - Exponent;
  uint64_t Low = Shift == 0 ? 0 : U.Significand << (64 - Shift);
  return {Negative, {Low, U.Significand >> Shift}};
}

static Integer128 toSigned(double A) {
  Whole128 Whole = wholePart(A);
  if (Whole.Magnitude.High & kSign)
    return Whole.Negative ? Integer128{0, kSign}
                          : Integer128{~uint64_t(0), ~kSign};
  return Whole.Negative ? negate(Whole.Magnitude) : Whole.Magnitude;
}

static Integer128 toUnsigned(double A) {
  Whole128 Whole = wholePart(A);
  return Whole.Negative ? Integer128{0, 0} : Whole.Magnitude;
}

/// The top 64 bits from the first 1 on, and whether any other is 1 in the
/// lowest; \p Exponent becomes the first 1's.
static uint64_t significand(Integer128 A, int &Exponent) {
  if (A.High == 0) {
    int Shift = leadingZeros(A.Low);
    Exponent = 63 - Shift;
    return A.Low << Shift;
  }
  int Shift = leadingZeros(A.High);
  Exponent = 127 - Shift;
  if (Shift == 0)
    return A.High | (A.Low != 0);
  return A.High << Shift | A.Low >> (64 - Shift) | (A.Low << Shift != 0);
}

static double toDouble(bool Negative, Integer128 A) {
  if ((A.Low | A.High) == 0)
    return 0.0;
  int Exponent;
  uint64_t Significand = significand(A, Exponent);
  return fromBits(pack(Negative ? kSign : 0, Exponent + kBias, Significand));
}

static float toFloat(bool Negative, Integer128 A) {
  if ((A.Low | A.High) == 0)
    return 0.0f;
  int Exponent;
  uint64_t Significand = significand(A, Exponent);
  return fromBits(packFloat(Negative ? 0x80000000u : 0, Exponent + kFloatBias,
                            Significand));
}

extern "C" {

Integer128 TP_LIBCALL(__fixdfti)(double A) { return toSigned(A); }

Integer128 TP_LIBCALL(__fixunsdfti)(double A) { return toUnsigned(A); }

Integer128 TP_LIBCALL(__fixsfti)(float A) {
  return toSigned(TP_LIBCALL(__extendsfdf2)(A));
}

Integer128 TP_LIBCALL(__fixunssfti)(float A) {
  return toUnsigned(TP_LIBCALL(__extendsfdf2)(A));
}

double TP_LIBCALL(__floattidf)(uint64_t Low, uint64_t High) {
  Integer128 A = {Low, High};
  bool Negative = (High & kSign) != 0;
  return toDouble(Negative, Negative ? negate(A) : A);
}

double TP_LIBCALL(__floatuntidf)(uint64_t Low, uint64_t High) {
  return toDouble(false, {Low, High});
}

float TP_LIBCALL(__floattisf)(uint64_t Low, uint64_t High) {
  Integer128 A = {Low, High};
  bool Negative = (High & kSign) != 0;
  return toFloat(Negative, Negative ? negate(A) : A);
}

float TP_LIBCALL(__floatuntisf)(uint64_t Low, uint64_t High) {
  return toFloat(false, {Low, High});
}

} // extern "C"
