//===- DoubleParts.h - What the functions of doubles share ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_MATH_DOUBLEPARTS_H
#define TP_RUNTIME_LIB_MATH_DOUBLEPARTS_H

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"
#include "runtime/lib/math/PairArithmetic.h"

namespace tp {

using DoublePair = Pair<double>;

inline double doubleNaN() { return soft::fromBits(soft::kNaN); }
inline double doubleInfinity() { return soft::fromBits(soft::kInfinity); }
inline double magnitudeOf(double X) {
  return soft::fromBits(soft::bits(X) & ~soft::kSign);
}
inline double withSign(double Magnitude, double Sign) {
  return soft::fromBits((soft::bits(Magnitude) & ~soft::kSign) |
                        (soft::bits(Sign) & soft::kSign));
}
inline bool isNaN(double X) {
  return (soft::bits(X) & ~soft::kSign) > soft::kInfinity;
}

/// Sum of \p Coefficients[I] * X^I.
template <int Count>
inline double polynomial(double X, const double (&Coefficients)[Count]) {
  double Sum = Coefficients[Count - 1];
  for (int I = Count - 2; I >= 0; --I)
    Sum = Coefficients[I] + X * Sum;
  return Sum;
}

/// 2 to the \p Exponent, which is in [-1022, 1023].
inline double doublePowerOfTwo(int Exponent) {
  return soft::fromBits(static_cast<uint64_t>(Exponent + soft::kBias) << 52);
}

/// Base-2 logarithm to about 2^-65 of itself, of a finite number above 0 that
/// has the bits \p Magnitude.
DoublePair logarithm2(uint64_t Magnitude);

/// Natural logarithm of a finite number above 0.
DoublePair logarithm(DoublePair X);

/// 2^(High + Low) for results from the smallest subnormal to below infinity;
/// 2^-58.
double exponential2(DoublePair X);

/// e^\p X times 2 to the \p Shift, rounded once; for any number.
double exponential(double X, int Shift);

/// e^\p X - 1 for \p X in [-80, 80], to about 2^-55 of itself.
DoublePair exponentialMinus1(double X);

} // namespace tp

extern "C" {
double TP_LIBCALL(sin)(double X);
double TP_LIBCALL(cos)(double X);
double TP_LIBCALL(tan)(double X);
double TP_LIBCALL(asin)(double X);
double TP_LIBCALL(acos)(double X);
double TP_LIBCALL(atan)(double X);
double TP_LIBCALL(atan2)(double Y, double X);
double TP_LIBCALL(exp)(double X);
double TP_LIBCALL(exp2)(double X);
double TP_LIBCALL(log)(double X);
double TP_LIBCALL(log2)(double X);
double TP_LIBCALL(log10)(double X);
double TP_LIBCALL(pow)(double X, double Y);
double TP_LIBCALL(ldexp)(double X, int Exponent);
double TP_LIBCALL(rint)(double X);
double TP_LIBCALL(floor)(double X);
double TP_LIBCALL(ceil)(double X);
double TP_LIBCALL(trunc)(double X);
double TP_LIBCALL(round)(double X);
double TP_LIBCALL(fmod)(double X, double Y);
double TP_LIBCALL(fmin)(double X, double Y);
double TP_LIBCALL(fmax)(double X, double Y);
double TP_LIBCALL(frexp)(double X, int *Exponent);
double TP_LIBCALL(modf)(double X, double *Whole);
double TP_LIBCALL(sqrt)(double X);
double TP_LIBCALL(acosh)(double X);
double TP_LIBCALL(asinh)(double X);
double TP_LIBCALL(atanh)(double X);
double TP_LIBCALL(cbrt)(double X);
double TP_LIBCALL(cosh)(double X);
double TP_LIBCALL(erf)(double X);
double TP_LIBCALL(erfc)(double X);
double TP_LIBCALL(expm1)(double X);
double TP_LIBCALL(hypot)(double X, double Y);
double TP_LIBCALL(lgamma)(double X);
double TP_LIBCALL(log1p)(double X);
double TP_LIBCALL(nextafter)(double X, double Toward);
double TP_LIBCALL(remainder)(double X, double Y);
double TP_LIBCALL(remquo)(double X, double Y, int *Quotient);
double TP_LIBCALL(sinh)(double X);
double TP_LIBCALL(tanh)(double X);
double TP_LIBCALL(tgamma)(double X);
int TP_LIBCALL(ilogb)(double X);
double TP_LIBCALL(logb)(double X);
} // extern "C"

#endif // TP_RUNTIME_LIB_MATH_DOUBLEPARTS_H
