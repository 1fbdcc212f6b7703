//===- DoubleConvert.cpp - double, float and integers ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Conversions to integers cut the fraction off; values out of the integer's
// range become its nearest value and NaN becomes 0, like the TP's own
// conversions.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"

using namespace tp::soft;
using namespace tp::wide;

/// Whole part of the number, whose \p Exponent is unbiased; all ones when it
/// has more than 64 bits.
static inline uint64_t wholePart(int Exponent, uint64_t Significand) {
  if (Exponent < 0)
    return 0;
  if (Exponent > 63)
    return ~uint64_t(0);
  return Significand >> (63 - Exponent);
}

static inline int64_t saturate64(bool Negative, uint64_t Magnitude) {
  uint64_t Limit = (uint64_t(1) << 63) - !Negative;
  if (Magnitude > Limit)
    Magnitude = Limit;
  return static_cast<int64_t>(Negative ? -Magnitude : Magnitude);
}

namespace {

struct Whole {
  bool Negative;
  uint64_t Magnitude;
};

} // namespace

static inline Whole wholePart(double A) {
  uint64_t Bits = bits(A);
  uint64_t Magnitude = Bits & ~kSign;
  if (Magnitude < uint64_t(kBias) << 52 || Magnitude > kInfinity)
    return {false, 0};
  Unpacked U = unpack(Magnitude);
  return {(Bits & kSign) != 0, wholePart(U.Exponent - kBias, U.Significand)};
}

static inline Whole wholePart(float A) {
  uint32_t Bits = bits(A);
  uint32_t Magnitude = Bits & 0x7FFFFFFF;
  if (Magnitude < uint32_t(kFloatBias) << 23 || Magnitude > 0x7F800000)
    return {false, 0};
  Unpacked U = unpackFloat(Magnitude);
  return {(Bits >> 31) != 0, wholePart(U.Exponent - kFloatBias, U.Significand)};
}

static inline double toDouble(uint64_t Sign, uint64_t Magnitude) {
  if (Magnitude == 0)
    return fromBits(uint64_t(0));
  int Shift = leadingZeros(Magnitude);
  return fromBits(pack(Sign, kBias + 63 - Shift, Magnitude << Shift));
}

/// 32-bit integers are exact.
static inline double toDouble(uint64_t Sign, uint32_t Magnitude) {
  if (Magnitude == 0)
    return fromBits(uint64_t(0));
  int Shift = __builtin_clz(Magnitude);
  uint32_t Significand = Magnitude << Shift;
  uint32_t High = static_cast<uint32_t>(kBias + 30 - Shift) << 20;
  return fromBits(Sign | make(High + (Significand >> 11), Significand << 21));
}

static inline float toFloat(uint32_t Sign, uint64_t Magnitude) {
  if (Magnitude == 0)
    return 0.0f;
  int Shift = leadingZeros(Magnitude);
  return fromBits(packFloat(Sign, kFloatBias + 63 - Shift, Magnitude << Shift));
}

static inline uint64_t magnitude(int64_t Value) {
  return Value < 0 ? -static_cast<uint64_t>(Value)
                   : static_cast<uint64_t>(Value);
}

extern "C" {

double TP_LIBCALL(__extendsfdf2)(float A) {
  uint32_t Bits = bits(A);
  uint64_t Sign = make(Bits & 0x80000000, 0);
  uint32_t Magnitude = Bits & 0x7FFFFFFF;
  if (Magnitude >= 0x7F800000)
    return fromBits(Magnitude > 0x7F800000 ? kNaN : Sign | kInfinity);
  if (Magnitude == 0)
    return fromBits(Sign);
  Unpacked U = unpackFloat(Magnitude);
  return fromBits(pack(Sign, U.Exponent - kFloatBias + kBias, U.Significand));
}

float TP_LIBCALL(__truncdfsf2)(double A) {
  uint64_t Bits = bits(A);
  uint32_t Sign = high(Bits) & 0x80000000;
  uint64_t Magnitude = Bits & ~kSign;
  if (Magnitude >= kInfinity)
    return fromBits(Magnitude > kInfinity ? 0x7FC00000u : Sign | 0x7F800000u);
  if (Magnitude == 0)
    return fromBits(Sign);
  Unpacked U = unpack(Magnitude);
  return fromBits(
      packFloat(Sign, U.Exponent - kBias + kFloatBias, U.Significand));
}

int32_t TP_LIBCALL(__fixdfsi)(double A) {
  Whole W = wholePart(A);
  uint32_t Limit = 0x7FFFFFFFu + W.Negative;
  uint32_t Magnitude = W.Magnitude > Limit ? Limit : low(W.Magnitude);
  return static_cast<int32_t>(W.Negative ? -Magnitude : Magnitude);
}

uint32_t TP_LIBCALL(__fixunsdfsi)(double A) {
  Whole W = wholePart(A);
  if (W.Negative)
    return 0;
  return high(W.Magnitude) ? 0xFFFFFFFFu : low(W.Magnitude);
}

int64_t TP_LIBCALL(__fixdfdi)(double A) {
  Whole W = wholePart(A);
  return saturate64(W.Negative, W.Magnitude);
}

uint64_t TP_LIBCALL(__fixunsdfdi)(double A) {
  Whole W = wholePart(A);
  return W.Negative ? 0 : W.Magnitude;
}

int64_t TP_LIBCALL(__fixsfdi)(float A) {
  Whole W = wholePart(A);
  return saturate64(W.Negative, W.Magnitude);
}

uint64_t TP_LIBCALL(__fixunssfdi)(float A) {
  Whole W = wholePart(A);
  return W.Negative ? 0 : W.Magnitude;
}

double TP_LIBCALL(__floatsidf)(int32_t A) {
  uint32_t U = static_cast<uint32_t>(A);
  return A < 0 ? toDouble(kSign, -U) : toDouble(0, U);
}

double TP_LIBCALL(__floatunsidf)(uint32_t A) { return toDouble(0, A); }

double TP_LIBCALL(__floatdidf)(int64_t A) {
  return toDouble(A < 0 ? kSign : 0, magnitude(A));
}

double TP_LIBCALL(__floatundidf)(uint64_t A) { return toDouble(0, A); }

float TP_LIBCALL(__floatdisf)(int64_t A) {
  return toFloat(A < 0 ? 0x80000000 : 0, magnitude(A));
}

float TP_LIBCALL(__floatundisf)(uint64_t A) { return toFloat(0, A); }

} // extern "C"
