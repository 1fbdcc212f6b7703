//===- PairArithmetic.h - Numbers of twice the precision --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Sums and products of pairs of floats or doubles, without fused operations
// (T. J. Dekker, A floating-point technique for extending the available
// precision, 1971; D. E. Knuth, The Art of Computer Programming, volume 2).
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_MATH_PAIRARITHMETIC_H
#define TP_RUNTIME_LIB_MATH_PAIRARITHMETIC_H

#include <stdint.h>

namespace tp {

/// The sum of the two, of which Low is at most half a unit in High's last
/// place.
template <typename T> struct Pair {
  T High;
  T Low;
};

/// \p X without the lower half of its significand.
inline float upperHalf(float X) {
  return __builtin_bit_cast(float,
                            __builtin_bit_cast(uint32_t, X) & 0xFFFFF000u);
}
inline double upperHalf(double X) {
  return __builtin_bit_cast(double, __builtin_bit_cast(uint64_t, X) &
                                        0xFFFFFFFFF8000000u);
}

/// A + B exactly, for |A| >= |B|.
template <typename T> inline Pair<T> fastTwoSum(T A, T B) {
  T Sum = A + B;
  return {Sum, B - (Sum - A)};
}

/// A + B exactly.
template <typename T> inline Pair<T> twoSum(T A, T B) {
  T Sum = A + B;
  T PartB = Sum - A;
  return {Sum, (A - (Sum - PartB)) + (B - PartB)};
}

/// A * B, if nothing overflows or is subnormal: exactly for floats, to one bit
/// of 107 for doubles.
template <typename T> inline Pair<T> twoProduct(T A, T B) {
  T HighA = upperHalf(A);
  T HighB = upperHalf(B);
  T LowA = A - HighA;
  T LowB = B - HighB;
  T Product = A * B;
  T Error = HighA * HighB - Product;
  Error += HighA * LowB;
  Error += LowA * HighB;
  Error += LowA * LowB;
  return {Product, Error};
}

template <typename T> inline Pair<T> multiply(Pair<T> A, Pair<T> B) {
  Pair<T> P = twoProduct(A.High, B.High);
  return fastTwoSum(P.High, P.Low + (A.High * B.Low + A.Low * B.High));
}

template <typename T> inline Pair<T> multiply(Pair<T> A, T B) {
  Pair<T> P = twoProduct(A.High, B);
  return fastTwoSum(P.High, P.Low + A.Low * B);
}

/// A + B for |A| >= |B|.
template <typename T> inline Pair<T> add(T A, Pair<T> B) {
  Pair<T> S = fastTwoSum(A, B.High);
  return fastTwoSum(S.High, S.Low + B.Low);
}

/// A / B.
template <typename T> inline Pair<T> divide(T A, Pair<T> B) {
  T Quotient = A / B.High;
  Pair<T> P = twoProduct(Quotient, B.High);
  T Rest = ((A - P.High) - P.Low) - Quotient * B.Low;
  return fastTwoSum(Quotient, Rest / B.High);
}

/// A / B.
template <typename T> inline Pair<T> divide(Pair<T> A, Pair<T> B) {
  T Quotient = A.High / B.High;
  Pair<T> P = twoProduct(Quotient, B.High);
  T Rest = (((A.High - P.High) - P.Low) + A.Low) - Quotient * B.Low;
  return fastTwoSum(Quotient, Rest / B.High);
}

/// A + B, either of which may be the greater.
template <typename T> inline Pair<T> sum(Pair<T> A, Pair<T> B) {
  Pair<T> S = twoSum(A.High, B.High);
  return fastTwoSum(S.High, S.Low + (A.Low + B.Low));
}

template <typename T> inline Pair<T> sum(Pair<T> A, T B) {
  Pair<T> S = twoSum(A.High, B);
  return fastTwoSum(S.High, S.Low + A.Low);
}

} // namespace tp

#endif // TP_RUNTIME_LIB_MATH_PAIRARITHMETIC_H
