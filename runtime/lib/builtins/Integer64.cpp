//===- Integer64.cpp - 64-bit integers of the code generator --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "runtime/lib/builtins/WideInteger.h"

using namespace tp::wide;

/// A zero divisor traps in the first 32-bit division.
static inline uint64_t divide64(uint64_t A, uint64_t B, uint64_t &Remainder) {
  if (high(B) == 0) {
    uint32_t Divisor = low(B);
    uint32_t QuotientHigh = 0;
    uint32_t Rest = high(A);
    if (Rest >= Divisor) {
      QuotientHigh = Rest / Divisor;
      Rest -= QuotientHigh * Divisor;
    }
    uint32_t QuotientLow;
    if (Rest == 0) {
      QuotientLow = low(A) / Divisor;
      Rest = low(A) - QuotientLow * Divisor;
    } else {
      QuotientLow = divide(Rest, low(A), Divisor, Rest);
    }
    Remainder = Rest;
    return make(QuotientHigh, QuotientLow);
  }
  if (A < B) {
    Remainder = A;
    return 0;
  }
  // The divisor's upper 32 significant bits give a quotient that is right or
  // one too large; starting from one less, it is right or one too small.
  int Shift = __builtin_clz(high(B));
  uint32_t Ignored;
  uint64_t Half = A >> 1;
  uint32_t Estimate =
      divideNormalized(high(Half), low(Half), high(B << Shift), Ignored);
  uint32_t Quotient = Estimate >> (31 - Shift);
  if (Quotient != 0)
    --Quotient;
  uint64_t Product = multiply(Quotient, low(B)) + make(Quotient * high(B), 0);
  uint64_t Rest = A - Product;
  if (Rest >= B) {
    ++Quotient;
    Rest -= B;
  }
  Remainder = Rest;
  return Quotient;
}

static inline uint64_t magnitude(int64_t Value) {
  return Value < 0 ? -static_cast<uint64_t>(Value)
                   : static_cast<uint64_t>(Value);
}

static inline int64_t withSign(uint64_t Magnitude, int64_t Sign) {
  return static_cast<int64_t>(Sign < 0 ? -Magnitude : Magnitude);
}

extern "C" {

uint64_t TP_LIBCALL(__udivdi3)(uint64_t A, uint64_t B) {
  uint64_t Remainder;
  return divide64(A, B, Remainder);
}

uint64_t TP_LIBCALL(__umoddi3)(uint64_t A, uint64_t B) {
  uint64_t Remainder;
  divide64(A, B, Remainder);
  return Remainder;
}

uint64_t TP_LIBCALL(__udivmoddi4)(uint64_t A, uint64_t B, uint64_t *Remainder) {
  uint64_t Rest;
  uint64_t Quotient = divide64(A, B, Rest);
  if (Remainder)
    *Remainder = Rest;
  return Quotient;
}

int64_t TP_LIBCALL(__divdi3)(int64_t A, int64_t B) {
  uint64_t Remainder;
  return withSign(divide64(magnitude(A), magnitude(B), Remainder), A ^ B);
}

int64_t TP_LIBCALL(__moddi3)(int64_t A, int64_t B) {
  uint64_t Remainder;
  divide64(magnitude(A), magnitude(B), Remainder);
  return withSign(Remainder, A);
}

int64_t TP_LIBCALL(__divmoddi4)(int64_t A, int64_t B, int64_t *Remainder) {
  uint64_t Rest;
  uint64_t Quotient = divide64(magnitude(A), magnitude(B), Rest);
  *Remainder = withSign(Rest, A);
  return withSign(Quotient, A ^ B);
}

int64_t TP_LIBCALL(__muldi3)(int64_t A, int64_t B) {
  uint64_t UA = static_cast<uint64_t>(A), UB = static_cast<uint64_t>(B);
  uint32_t Cross = high(UA) * low(UB) + low(UA) * high(UB);
  return static_cast<int64_t>(multiply(low(UA), low(UB)) + make(Cross, 0));
}

int64_t TP_LIBCALL(__mulodi4)(int64_t A, int64_t B, int *Overflow) {
  Integer128 P = multiply(magnitude(A), magnitude(B));
  bool Negative = (A ^ B) < 0;
  uint64_t Limit = (uint64_t(1) << 63) - !Negative;
  *Overflow = P.High != 0 || P.Low > Limit;
  return static_cast<int64_t>(Negative ? -P.Low : P.Low);
}

int64_t TP_LIBCALL(__ashldi3)(int64_t Value, int Shift) {
  uint64_t V = static_cast<uint64_t>(Value);
  if (Shift & 32)
    return static_cast<int64_t>(make(low(V) << (Shift & 31), 0));
  if (Shift == 0)
    return Value;
  return static_cast<int64_t>(
      make(high(V) << Shift | low(V) >> (32 - Shift), low(V) << Shift));
}

int64_t TP_LIBCALL(__lshrdi3)(int64_t Value, int Shift) {
  uint64_t V = static_cast<uint64_t>(Value);
  if (Shift & 32)
    return static_cast<int64_t>(make(0, high(V) >> (Shift & 31)));
  if (Shift == 0)
    return Value;
  return static_cast<int64_t>(
      make(high(V) >> Shift, low(V) >> Shift | high(V) << (32 - Shift)));
}

int64_t TP_LIBCALL(__ashrdi3)(int64_t Value, int Shift) {
  uint64_t V = static_cast<uint64_t>(Value);
  int32_t High = static_cast<int32_t>(high(V));
  if (Shift & 32)
    return static_cast<int64_t>(
        make(static_cast<uint32_t>(High >> 31),
             static_cast<uint32_t>(High >> (Shift & 31))));
  if (Shift == 0)
    return Value;
  return static_cast<int64_t>(make(static_cast<uint32_t>(High >> Shift),
                                   low(V) >> Shift | high(V) << (32 - Shift)));
}

int TP_LIBCALL(__cmpdi2)(int64_t A, int64_t B) {
  return A < B ? 0 : A == B ? 1 : 2;
}

int TP_LIBCALL(__ucmpdi2)(uint64_t A, uint64_t B) {
  return A < B ? 0 : A == B ? 1 : 2;
}

} // extern "C"
