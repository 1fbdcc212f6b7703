//===- Decimal.h - Exact decimal expansion of a double ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_LIBC_DECIMAL_H
#define TP_RUNTIME_LIB_LIBC_DECIMAL_H

#include <stdint.h>

namespace tp {

/// A number between 0 and 10^310 in decimal digits: a finite double's magnitude
/// with all of them, or what a text says.
class Decimal {
public:
  /// Zero, for append().
  Decimal() : Begin(0), End(0) {}
  explicit Decimal(double Value);

  /// Adds \p Digit * 10^\p Power, for powers from 309 on in descending order.
  /// Digits below 10^-1080 are only told from zeros.
  void append(unsigned Digit, int Power);

  /// A whole number times a power of two.
  struct Binary {
    uint64_t Whole;
    int Exponent;
  };

  /// The number rounded to \p Bits bits, ties to even, or fewer bits so that
  /// the exponent is at least \p MinExponent. Changes the digits.
  Binary toBinary(int Bits, int MinExponent);

  bool isZero() const { return Begin == End; }

  /// Power of ten of the first digit that is not 0; 0 for zero.
  int exponent() const;

  /// Power of ten of the last digit that is not 0; 0 for zero.
  int lastPower() const;

  /// The digit that counts 10^\p Power.
  unsigned digit(int Power) const;

  /// Rounds to a multiple of 10^\p Power, ties to the even digit. \p Power is
  /// at most 308.
  void round(int Power);

private:
  void multiplyByPowerOfTwo(unsigned Power);
  void divideByPowerOfTwo(unsigned Power);
  void strip();
  uint64_t wholePart() const;

  /// Words of 9 digits, the most significant first. Words[UnitsWord] counts
  /// ones; those behind it are the fraction.
  static constexpr int UnitsWord = 35;
  static constexpr int NumWords = UnitsWord + 1 + 120;
  uint32_t Words[NumWords] = {};
  /// The words that are not 0 lie in [Begin, End).
  int Begin = UnitsWord - 1;
  int End = UnitsWord + 1;
};

} // namespace tp

#endif // TP_RUNTIME_LIB_LIBC_DECIMAL_H
