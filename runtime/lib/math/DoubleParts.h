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
} // extern "C"

#endif // TP_RUNTIME_LIB_MATH_DOUBLEPARTS_H
