//===- WideInteger.h - 64- and 128-bit steps of 32-bit code -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Everything here is written so that the code generator needs no function call
// for it: 64-bit sums and shifts, 32 x 32 -> 64-bit products, 32-bit quotients.
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_BUILTINS_WIDEINTEGER_H
#define TP_RUNTIME_LIB_BUILTINS_WIDEINTEGER_H

#include <stdint.h>

namespace tp::wide {

inline uint32_t high(uint64_t Value) {
  return static_cast<uint32_t>(Value >> 32);
}

inline uint32_t low(uint64_t Value) { return static_cast<uint32_t>(Value); }

inline uint64_t make(uint32_t High, uint32_t Low) {
  return static_cast<uint64_t>(High) << 32 | Low;
}

inline uint64_t multiply(uint32_t A, uint32_t B) {
  return static_cast<uint64_t>(A) * B;
}

/// Number of leading zero bits of \p Value, which is not 0.
inline int leadingZeros(uint64_t Value) {
  return high(Value) ? __builtin_clz(high(Value))
                     : 32 + __builtin_clz(low(Value));
}

/// \p Value >> \p Shift where any bit shifted out sets the lowest bit of the
/// result. \p Shift is not negative.
inline uint64_t shiftRightSticky(uint64_t Value, int Shift) {
  if (Shift == 0)
    return Value;
  if (Shift > 63)
    return Value != 0;
  uint64_t Lost = Value << (64 - Shift);
  return Value >> Shift | (Lost != 0);
}

/// Laid out like a 128-bit integer of the code generator.
struct Integer128 {
  uint64_t Low;
  uint64_t High;
};

inline Integer128 multiply(uint64_t A, uint64_t B) {
  uint64_t LowLow = multiply(low(A), low(B));
  uint64_t LowHigh = multiply(low(A), high(B));
  uint64_t HighLow = multiply(high(A), low(B));
  uint64_t HighHigh = multiply(high(A), high(B));
  uint64_t Middle = LowHigh + high(LowLow);
  uint64_t Middle2 = HighLow + low(Middle);
  return {make(low(Middle2), low(LowLow)),
          HighHigh + high(Middle) + high(Middle2)};
}

/// Quotient of \p High : \p Low by \p Divisor, whose top bit is set and which
/// is greater than \p High. Two steps with 16-bit digits (Knuth, The Art of
/// Computer Programming, volume 2, algorithm 4.3.1D).
inline uint32_t divideNormalized(uint32_t High, uint32_t Low, uint32_t Divisor,
                                 uint32_t &Remainder) {
  uint32_t DivisorHigh = Divisor >> 16;
  uint32_t DivisorLow = Divisor & 0xFFFF;
  uint32_t Partial = High;
  uint32_t Quotient = 0;
  for (int Shift = 16; Shift >= 0; Shift -= 16) {
    uint32_t Next = Low >> Shift & 0xFFFF;
    uint32_t Digit = Partial / DivisorHigh;
    uint32_t Rest = Partial - Digit * DivisorHigh;
    while (Digit > 0xFFFF || Digit * DivisorLow > (Rest << 16 | Next)) {
      --Digit;
      Rest += DivisorHigh;
      if (Rest > 0xFFFF)
        break;
    }
    Partial = (Partial << 16 | Next) - Digit * Divisor;
    Quotient = Quotient << 16 | Digit;
  }
  Remainder = Partial;
  return Quotient;
}

/// The same for any \p Divisor greater than \p High.
inline uint32_t divide(uint32_t High, uint32_t Low, uint32_t Divisor,
                       uint32_t &Remainder) {
  int Shift = __builtin_clz(Divisor);
  uint64_t Shifted = make(High, Low) << Shift;
  uint32_t Quotient =
      divideNormalized(tp::wide::high(Shifted), tp::wide::low(Shifted),
                       Divisor << Shift, Remainder);
  Remainder >>= Shift;
  return Quotient;
}

/// One 32-bit digit of a long division: floor(\p Partial * 2^32 / \p Divisor),
/// where \p Divisor has its top bit set and is greater than \p Partial, which
/// becomes the remainder.
inline uint32_t divideDigit(uint64_t &Partial, uint64_t Divisor) {
  uint32_t DivisorHigh = high(Divisor);
  uint32_t Digit;
  uint64_t Rest;
  if (high(Partial) >= DivisorHigh) {
    Digit = 0xFFFFFFFFu;
    Rest = static_cast<uint64_t>(low(Partial)) + DivisorHigh;
  } else {
    uint32_t Remainder;
    Digit =
        divideNormalized(high(Partial), low(Partial), DivisorHigh, Remainder);
    Rest = Remainder;
  }
  uint64_t Subtrahend = multiply(Digit, low(Divisor));
  while (high(Rest) == 0 && Subtrahend > Rest << 32) {
    --Digit;
    Rest += DivisorHigh;
    Subtrahend -= low(Divisor);
  }
  Partial = (Rest << 32) - Subtrahend;
  return Digit;
}

} // namespace tp::wide

#endif // TP_RUNTIME_LIB_BUILTINS_WIDEINTEGER_H
