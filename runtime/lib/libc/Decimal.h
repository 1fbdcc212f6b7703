//===- Decimal.h - Exact decimal expansion of a double ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_LIBC_DECIMAL_H
#define TP_RUNTIME_LIB_LIBC_DECIMAL_H

#include <stdint.h>

namespace tp {

/// All decimal digits of a finite double's magnitude; at most 309 before and
/// 1074 behind the point.
class Decimal {
public:
  explicit Decimal(double Value);

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
