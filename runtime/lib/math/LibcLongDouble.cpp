//===- LibcLongDouble.cpp - The C library's functions of long doubles -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// long double is double.
//
//===----------------------------------------------------------------------===//

#include <math.h>

#define TP_UNARY(Name)                                                         \
  long double Name##l(long double X) { return Name(static_cast<double>(X)); }
#define TP_BINARY(Name)                                                        \
  long double Name##l(long double X, long double Y) {                          \
    return Name(static_cast<double>(X), static_cast<double>(Y));               \
  }
#define TP_INTEGER(Type, Name)                                                 \
  Type Name##l(long double X) { return Name(static_cast<double>(X)); }

extern "C" {

TP_UNARY(acos)
TP_UNARY(acosh)
TP_UNARY(asin)
TP_UNARY(asinh)
TP_UNARY(atan)
TP_UNARY(atanh)
TP_UNARY(cbrt)
TP_UNARY(ceil)
TP_UNARY(cos)
TP_UNARY(cosh)
TP_UNARY(erf)
TP_UNARY(erfc)
TP_UNARY(exp)
TP_UNARY(exp2)
TP_UNARY(expm1)
TP_UNARY(fabs)
TP_UNARY(floor)
TP_UNARY(lgamma)
TP_UNARY(log)
TP_UNARY(log10)
TP_UNARY(log1p)
TP_UNARY(log2)
TP_UNARY(logb)
TP_UNARY(nearbyint)
TP_UNARY(rint)
TP_UNARY(round)
TP_UNARY(roundeven)
TP_UNARY(sin)
TP_UNARY(sinh)
TP_UNARY(sqrt)
TP_UNARY(tan)
TP_UNARY(tanh)
TP_UNARY(tgamma)
TP_UNARY(trunc)

TP_BINARY(atan2)
TP_BINARY(copysign)
TP_BINARY(fdim)
TP_BINARY(fmax)
TP_BINARY(fmin)
TP_BINARY(fmod)
TP_BINARY(hypot)
TP_BINARY(nextafter)
TP_BINARY(pow)
TP_BINARY(remainder)

TP_INTEGER(int, ilogb)
TP_INTEGER(long, lrint)
TP_INTEGER(long, lround)
TP_INTEGER(long long, llrint)
TP_INTEGER(long long, llround)

long double fmal(long double X, long double Y, long double Z) {
  return fma(static_cast<double>(X), static_cast<double>(Y),
             static_cast<double>(Z));
}
long double frexpl(long double X, int *Exponent) {
  return frexp(static_cast<double>(X), Exponent);
}
long double ldexpl(long double X, int Exponent) {
  return ldexp(static_cast<double>(X), Exponent);
}
long double scalbnl(long double X, int Exponent) {
  return ldexp(static_cast<double>(X), Exponent);
}
long double scalblnl(long double X, long Exponent) {
  return scalbln(static_cast<double>(X), Exponent);
}
long double modfl(long double X, long double *Whole) {
  double WholeDouble;
  double Fraction = modf(static_cast<double>(X), &WholeDouble);
  *Whole = WholeDouble;
  return Fraction;
}
long double remquol(long double X, long double Y, int *Quotient) {
  return remquo(static_cast<double>(X), static_cast<double>(Y), Quotient);
}
double nexttoward(double X, long double Toward) {
  return nextafter(X, static_cast<double>(Toward));
}
long double nexttowardl(long double X, long double Toward) {
  return nextafter(static_cast<double>(X), static_cast<double>(Toward));
}
long double nanl(const char *Tag) { return nan(Tag); }

} // extern "C"
