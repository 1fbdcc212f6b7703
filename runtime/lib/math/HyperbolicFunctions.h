//===- HyperbolicFunctions.h - For floats and for doubles --- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What the functions have in common in both precisions, by arithmetic with
// pairs. T is float or double; the overloads of exponential, exponentialMinus1
// and logarithm for it come before.
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_MATH_HYPERBOLICFUNCTIONS_H
#define TP_RUNTIME_LIB_MATH_HYPERBOLICFUNCTIONS_H

#include "runtime/lib/math/PairArithmetic.h"

namespace tp {

/// What differs between the precisions.
template <typename T> struct Precision;

/// Square root of a number above 0.
template <typename T> inline Pair<T> squareRoot(Pair<T> X) {
  T Root = Precision<T>::squareRoot(X.High);
  Pair<T> Square = twoProduct(Root, Root);
  T Rest = ((X.High - Square.High) - Square.Low) + X.Low;
  return fastTwoSum(Root, Rest / (Root + Root));
}

/// Logarithm of 1 + \p X, which is not tiny.
template <typename T> inline T logarithmOf1Plus(Pair<T> X) {
  return logarithm(sum(X, T(1))).High;
}

template <typename T> inline T expMinus1(T X) {
  T Magnitude = Precision<T>::magnitude(X);
  if (!(Magnitude >= Precision<T>::Tiny))
    return X;
  // Beyond, the 1 is too small to count, or the power is.
  constexpr T Large = Precision<T>::Large;
  if (X > Large)
    return exponential(X, 0);
  if (X < -Large)
    return T(-1);
  return exponentialMinus1(X).High;
}

template <typename T> inline T logOf1Plus(T X) {
  if (!(Precision<T>::magnitude(X) >= Precision<T>::Tiny))
    return X;
  if (X == T(-1))
    return -Precision<T>::infinity();
  if (X < T(-1))
    return Precision<T>::nan();
  if (X == Precision<T>::infinity())
    return X;
  return logarithm(twoSum(T(1), X)).High;
}

/// For \p X at least 0: (e^X - e^-X) / 2 = (E + E / (E + 1)) / 2 with
/// E = e^X - 1.
template <typename T> inline T hyperbolicSine(T X) {
  if (!(X >= Precision<T>::Small))
    return X;
  if (X > Precision<T>::Large)
    return exponential(X, -1);
  Pair<T> E = exponentialMinus1(X);
  return T(0.5) * sum(E, divide(E, sum(E, T(1)))).High;
}

/// For \p X at least 0.
template <typename T> inline T hyperbolicCosine(T X) {
  if (X > Precision<T>::Large)
    return exponential(X, -1);
  if (!(X >= T(0)))
    return Precision<T>::nan();
  Pair<T> Power = sum(exponentialMinus1(X), T(1));
  return T(0.5) * add(Power.High, sum(divide(T(1), Power), Power.Low)).High;
}

/// For \p X at least 0: E / (E + 2) with E = e^2X - 1.
template <typename T> inline T hyperbolicTangent(T X) {
  if (!(X >= Precision<T>::Small))
    return X;
  if (X > Precision<T>::Large / 2)
    return T(1);
  Pair<T> E = exponentialMinus1(X + X);
  return divide(E, sum(E, T(2))).High;
}

/// Logarithm of 2 \p X.
template <typename T> inline T logarithmOfTwice(T X) {
  return sum(logarithm(Pair<T>{X, T(0)}), Precision<T>::Ln2).High;
}

/// For \p X at least 0: log(1 + X + X^2 / (1 + sqrt(1 + X^2))).
template <typename T> inline T areaSine(T X) {
  if (!(X >= Precision<T>::Small) || X == Precision<T>::infinity())
    return X;
  if (X > 1 / Precision<T>::Small)
    return logarithmOfTwice(X);
  Pair<T> Square = twoProduct(X, X);
  Pair<T> Root = squareRoot(sum(Square, T(1)));
  return logarithmOf1Plus(sum(divide(Square, sum(Root, T(1))), X));
}

/// log(1 + (X - 1) + sqrt(X^2 - 1)).
template <typename T> inline T areaCosine(T X) {
  if (!(X >= T(1)))
    return Precision<T>::nan();
  if (X == T(1))
    return T(0);
  if (X == Precision<T>::infinity())
    return X;
  if (X > 1 / Precision<T>::Small)
    return logarithmOfTwice(X);
  Pair<T> Square = sum(twoProduct(X, X), T(-1));
  return logarithmOf1Plus(sum(squareRoot(Square), twoSum(X, T(-1))));
}

/// For \p X at least 0: log(1 + 2X / (1 - X)) / 2.
template <typename T> inline T areaTangent(T X) {
  if (!(X >= Precision<T>::Small))
    return X;
  if (X >= T(1))
    return X == T(1) ? Precision<T>::infinity() : Precision<T>::nan();
  return T(0.5) * logarithmOf1Plus(divide(X + X, twoSum(T(1), -X)));
}

/// Cube root of \p X in [0.5, 4).
template <typename T> inline T cubeRoot(T X) {
  T Y = T(0.6459) + X * (T(0.37502) - X * T(0.035427));
  for (int Step = 0; Step != Precision<T>::CubeRootSteps; ++Step) {
    T Cube = Y * Y * Y;
    Y *= (Cube + X + X) / (Cube + Cube + X);
  }
  Pair<T> Square = twoProduct(Y, Y);
  Pair<T> Cube = multiply(Square, Y);
  return Y - ((Cube.High - X) + Cube.Low) / (3 * Square.High);
}

} // namespace tp

#endif // TP_RUNTIME_LIB_MATH_HYPERBOLICFUNCTIONS_H
