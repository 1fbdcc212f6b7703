//===- EdgeValues.h - Numbers that break arithmetic -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_RUNTIME_EDGEVALUES_H
#define TP_TEST_UNIT_RUNTIME_EDGEVALUES_H

#include <bit>
#include <random>
#include <stdint.h>
#include <vector>

namespace tp::test {

/// Bit patterns around every power of two, and a few others.
inline std::vector<uint64_t> edgeIntegers() {
  std::vector<uint64_t> Values;
  for (int Bit = 0; Bit != 64; ++Bit)
    for (int Delta = -1; Delta <= 1; ++Delta) {
      uint64_t Value = (uint64_t(1) << Bit) + Delta;
      Values.push_back(Value);
      Values.push_back(-Value);
    }
  for (uint64_t Value :
       {0xFFFFFFFF00000000ull, 0xFFFFFFFEFFFFFFFFull, 0x8000000080000000ull,
        0x123456789ABCDEF0ull, 0x00000001FFFFFFFFull, 0x80000000FFFFFFFFull})
    Values.push_back(Value);
  return Values;
}

/// Zeros, subnormals, the ends of every range, halfway cases of the conversions
/// and of the sums, infinities and NaNs, of both signs.
inline std::vector<double> edgeDoubles() {
  std::vector<uint64_t> Patterns = {
      0x0000000000000000, 0x0000000000000001, 0x0000000000000002,
      0x0000000000000003, 0x0007FFFFFFFFFFFF, 0x0008000000000000,
      0x000FFFFFFFFFFFFE, 0x000FFFFFFFFFFFFF, 0x0010000000000000,
      0x0010000000000001, 0x001FFFFFFFFFFFFF, 0x0020000000000000,
      0x0350000000000000, 0x1FF0000000000000, 0x2000000000000001,
      0x3690000000000000, 0x36A0000000000000, 0x36A0000000000001,
      0x380FFFFFE0000000, 0x380FFFFFF0000000, 0x380FFFFFFFFFFFFF,
      0x3810000000000000, 0x3C90000000000000, 0x3CA0000000000000,
      0x3CA0000000000001, 0x3CB0000000000000, 0x3FE0000000000000,
      0x3FEFFFFFFFFFFFFF, 0x3FF0000000000000, 0x3FF0000000000001,
      0x3FF0000010000000, 0x3FF0000010000001, 0x3FF0000030000000,
      0x3FF8000000000000, 0x3FFFFFFFFFFFFFFF, 0x4000000000000000,
      0x4008000000000000, 0x4024000000000000, 0x41DFFFFFFFC00000,
      0x41DFFFFFFFFFFFFF, 0x41E0000000000000, 0x41EFFFFFFFE00000,
      0x41F0000000000000, 0x4330000000000000, 0x4330000000000001,
      0x433FFFFFFFFFFFFF, 0x4340000000000000, 0x43DFFFFFFFFFFFFF,
      0x43E0000000000000, 0x43EFFFFFFFFFFFFF, 0x43F0000000000000,
      0x47EFFFFFE0000000, 0x47EFFFFFEFFFFFFF, 0x47EFFFFFF0000000,
      0x47F0000000000000, 0x7FD0000000000000, 0x7FE0000000000000,
      0x7FEFFFFFFFFFFFFF, 0x7FF0000000000000, 0x7FF0000000000001,
      0x7FF8000000000000, 0x7FFFFFFFFFFFFFFF};
  std::vector<double> Values;
  for (uint64_t Pattern : Patterns) {
    Values.push_back(std::bit_cast<double>(Pattern));
    Values.push_back(std::bit_cast<double>(Pattern | 1ull << 63));
  }
  return Values;
}

/// Pairs of doubles whose exponents are often near each other, so that sums
/// cancel and products reach the ends of the range.
class RandomDoubles {
public:
  double next() { return std::bit_cast<double>(Generator()); }

  double near(double Other) {
    uint64_t Pattern = Generator();
    if (Pattern & 1) {
      uint64_t OtherBits = std::bit_cast<uint64_t>(Other);
      int64_t Exponent = static_cast<int64_t>(OtherBits >> 52 & 0x7FF) +
                         static_cast<int64_t>(Generator() % 121) - 60;
      Exponent = Exponent < 0 ? 0 : Exponent > 0x7FE ? 0x7FE : Exponent;
      Pattern = (Pattern & 0x800FFFFFFFFFFFFF) | static_cast<uint64_t>(Exponent)
                                                     << 52;
    }
    if (Pattern & 2)
      Pattern &= ~uint64_t(0) << (Generator() % 53);
    return std::bit_cast<double>(Pattern);
  }

  uint64_t integer() { return Generator() >> (Generator() % 64); }

private:
  std::mt19937_64 Generator{20260101};
};

} // namespace tp::test

#endif // TP_TEST_UNIT_RUNTIME_EDGEVALUES_H
