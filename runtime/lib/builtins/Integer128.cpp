//===- Integer128.cpp - 128-bit integers of the code generator ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "runtime/lib/builtins/WideInteger.h"

using namespace tp::wide;

static inline Integer128 negate(Integer128 A) {
  return {-A.Low, ~A.High + (A.Low == 0)};
}

static inline Integer128 subtract(Integer128 A, Integer128 B) {
  return {A.Low - B.Low, A.High - B.High - (A.Low < B.Low)};
}

static inline bool less(Integer128 A, Integer128 B) {
  return A.High != B.High ? A.High < B.High : A.Low < B.Low;
}

static inline bool isNegative(Integer128 A) { return A.High >> 63 != 0; }

static inline Integer128 magnitude(Integer128 A) {
  return isNegative(A) ? negate(A) : A;
}

static inline Integer128 withSign(Integer128 Magnitude, bool Negative) {
  return Negative ? negate(Magnitude) : Magnitude;
}

/// The lower half of a product.
static inline Integer128 multiplyLow(Integer128 A, Integer128 B) {
  Integer128 Product = multiply(A.Low, B.Low);
  Product.High += A.High * B.Low + A.Low * B.High;
  return Product;
}

static inline Integer128 shiftLeft(Integer128 A, uint32_t Shift) {
  if (Shift & 64)
    return {0, A.Low << (Shift & 63)};
  if (Shift == 0)
    return A;
  return {A.Low << Shift, A.High << Shift | A.Low >> (64 - Shift)};
}

/// floor((\p Partial * 2^32 + \p Digit) / \p Divisor), where \p Divisor has its
/// top bit set and is greater than \p Partial, which becomes the remainder.
static uint32_t nextDigit(uint64_t &Partial, uint32_t Digit, uint64_t Divisor) {
  uint32_t Quotient = divideDigit(Partial, Divisor);
  uint64_t Sum = Partial + Digit;
  if (Sum < Partial || Sum >= Divisor) {
    ++Quotient;
    Sum -= Divisor;
  }
  Partial = Sum;
  return Quotient;
}

/// Quotient of \p A, whose upper half is less than \p Divisor.
static uint64_t divideByNormalized(Integer128 A, uint64_t Divisor,
                                   uint64_t &Remainder) {
  Remainder = A.High;
  uint32_t High = nextDigit(Remainder, high(A.Low), Divisor);
  uint32_t Low = nextDigit(Remainder, low(A.Low), Divisor);
  return make(High, Low);
}

static Integer128 divideByHalf(Integer128 A, uint64_t Divisor,
                               uint64_t &Remainder) {
  uint64_t Rest = A.High;
  uint64_t QuotientHigh = 0;
  if (Rest >= Divisor)
    QuotientHigh = TP_LIBCALL(__udivmoddi4)(Rest, Divisor, &Rest);
  if (Rest == 0)
    return {TP_LIBCALL(__udivmoddi4)(A.Low, Divisor, &Remainder), QuotientHigh};
  int Shift = leadingZeros(Divisor);
  Integer128 Shifted = shiftLeft({A.Low, Rest}, static_cast<uint32_t>(Shift));
  uint64_t QuotientLow =
      divideByNormalized(Shifted, Divisor << Shift, Remainder);
  Remainder >>= Shift;
  return {QuotientLow, QuotientHigh};
}

/// A zero divisor traps in the first 32-bit division.
static Integer128 divide128(Integer128 A, Integer128 B, Integer128 &Remainder) {
  if (B.High == 0) {
    Remainder.High = 0;
    return divideByHalf(A, B.Low, Remainder.Low);
  }
  if (less(A, B)) {
    Remainder = A;
    return {0, 0};
  }
  // The divisor's upper 64 significant bits give a quotient that is right or
  // one too large; starting from one less, it is right or one too small.
  uint32_t Shift = static_cast<uint32_t>(leadingZeros(B.High));
  Integer128 Half = {A.High << 63 | A.Low >> 1, A.High >> 1};
  uint64_t Ignored;
  uint64_t Quotient =
      divideByNormalized(Half, shiftLeft(B, Shift).High, Ignored) >>
      (63 - Shift);
  if (Quotient != 0)
    --Quotient;
  Integer128 Rest = subtract(A, multiplyLow({Quotient, 0}, B));
  if (!less(Rest, B)) {
    ++Quotient;
    Rest = subtract(Rest, B);
  }
  Remainder = Rest;
  return {Quotient, 0};
}

static Integer128 divideSigned(Integer128 A, Integer128 B,
                               Integer128 &Remainder) {
  Integer128 Quotient = divide128(magnitude(A), magnitude(B), Remainder);
  Remainder = withSign(Remainder, isNegative(A));
  return withSign(Quotient, isNegative(A) != isNegative(B));
}

extern "C" {

Integer128 TP_LIBCALL(__udivti3)(uint64_t ALow, uint64_t AHigh, uint64_t BLow,
                                 uint64_t BHigh) {
  Integer128 Remainder;
  return divide128({ALow, AHigh}, {BLow, BHigh}, Remainder);
}

Integer128 TP_LIBCALL(__umodti3)(uint64_t ALow, uint64_t AHigh, uint64_t BLow,
                                 uint64_t BHigh) {
  Integer128 Remainder;
  divide128({ALow, AHigh}, {BLow, BHigh}, Remainder);
  return Remainder;
}

Integer128 TP_LIBCALL(__udivmodti4)(uint64_t ALow, uint64_t AHigh,
                                    uint64_t BLow, uint64_t BHigh,
                                    Integer128 *Remainder) {
  Integer128 Rest;
  Integer128 Quotient = divide128({ALow, AHigh}, {BLow, BHigh}, Rest);
  if (Remainder)
    *Remainder = Rest;
  return Quotient;
}

Integer128 TP_LIBCALL(__divti3)(uint64_t ALow, uint64_t AHigh, uint64_t BLow,
                                uint64_t BHigh) {
  Integer128 Remainder;
  return divideSigned({ALow, AHigh}, {BLow, BHigh}, Remainder);
}

Integer128 TP_LIBCALL(__modti3)(uint64_t ALow, uint64_t AHigh, uint64_t BLow,
                                uint64_t BHigh) {
  Integer128 Remainder;
  divideSigned({ALow, AHigh}, {BLow, BHigh}, Remainder);
  return Remainder;
}

Integer128 TP_LIBCALL(__divmodti4)(uint64_t ALow, uint64_t AHigh, uint64_t BLow,
                                   uint64_t BHigh, Integer128 *Remainder) {
  return divideSigned({ALow, AHigh}, {BLow, BHigh}, *Remainder);
}

Integer128 TP_LIBCALL(__multi3)(uint64_t ALow, uint64_t AHigh, uint64_t BLow,
                                uint64_t BHigh) {
  return multiplyLow({ALow, AHigh}, {BLow, BHigh});
}

Integer128 TP_LIBCALL(__muloti4)(uint64_t ALow, uint64_t AHigh, uint64_t BLow,
                                 uint64_t BHigh, int *Overflow) {
  Integer128 A = {ALow, AHigh}, B = {BLow, BHigh};
  bool Negative = isNegative(A) != isNegative(B);
  A = magnitude(A);
  B = magnitude(B);
  Integer128 Product = multiply(A.Low, B.Low);
  // One of the upper halves is 0, or the product is too large.
  Integer128 Cross =
      A.High != 0 ? multiply(A.High, B.Low) : multiply(B.High, A.Low);
  uint64_t High = Product.High + Cross.Low;
  *Overflow = (A.High != 0 && B.High != 0) || Cross.High != 0 ||
              High < Cross.Low ||
              (High >> 63 != 0 &&
               !(Negative && High == uint64_t(1) << 63 && Product.Low == 0));
  Product = multiplyLow(A, B);
  return withSign(Product, Negative);
}

Integer128 TP_LIBCALL(__ashlti3)(uint64_t Low, uint64_t High, int Shift) {
  return shiftLeft({Low, High}, static_cast<uint32_t>(Shift));
}

Integer128 TP_LIBCALL(__lshrti3)(uint64_t Low, uint64_t High, int Shift) {
  if (Shift & 64)
    return {High >> (Shift & 63), 0};
  if (Shift == 0)
    return {Low, High};
  return {Low >> Shift | High << (64 - Shift), High >> Shift};
}

Integer128 TP_LIBCALL(__ashrti3)(uint64_t Low, uint64_t High, int Shift) {
  int64_t Signed = static_cast<int64_t>(High);
  if (Shift & 64)
    return {static_cast<uint64_t>(Signed >> (Shift & 63)),
            static_cast<uint64_t>(Signed >> 63)};
  if (Shift == 0)
    return {Low, High};
  return {Low >> Shift | High << (64 - Shift),
          static_cast<uint64_t>(Signed >> Shift)};
}

} // extern "C"
