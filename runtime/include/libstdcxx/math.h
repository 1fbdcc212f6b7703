//===- math.h - The C library's functions with overloads --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The C header's functions take and return double; C++ has the same names for
// float, and functions in place of the classifying macros.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_MATH_H
#define TP_LIBSTDCXX_MATH_H

// libstdc++'s own header of this name then passes on to the C library's.
#define _GLIBCXX_INCLUDE_NEXT_C_HEADERS
#include_next <math.h>
#undef _GLIBCXX_INCLUDE_NEXT_C_HEADERS

#undef fpclassify
#undef isfinite
#undef isinf
#undef isnan
#undef isnormal
#undef signbit
#undef isgreater
#undef isgreaterequal
#undef isless
#undef islessequal
#undef islessgreater
#undef isunordered

extern "C++" {

#define TP_FLOAT_UNARY(Name)                                                   \
  inline float Name(float X) { return Name##f(X); }
TP_FLOAT_UNARY(acos)
TP_FLOAT_UNARY(asin)
TP_FLOAT_UNARY(atan)
TP_FLOAT_UNARY(cos)
TP_FLOAT_UNARY(exp)
TP_FLOAT_UNARY(exp2)
TP_FLOAT_UNARY(log)
TP_FLOAT_UNARY(log10)
TP_FLOAT_UNARY(log2)
TP_FLOAT_UNARY(sin)
TP_FLOAT_UNARY(tan)
TP_FLOAT_UNARY(ceil)
TP_FLOAT_UNARY(floor)
TP_FLOAT_UNARY(nearbyint)
TP_FLOAT_UNARY(rint)
TP_FLOAT_UNARY(round)
TP_FLOAT_UNARY(trunc)
inline float fabs(float X) { return __builtin_fabsf(X); }
inline float sqrt(float X) { return __builtin_elementwise_sqrt(X); }
#undef TP_FLOAT_UNARY

#define TP_FLOAT_BINARY(Name)                                                  \
  inline float Name(float X, float Y) { return Name##f(X, Y); }
TP_FLOAT_BINARY(atan2)
TP_FLOAT_BINARY(copysign)
TP_FLOAT_BINARY(fdim)
TP_FLOAT_BINARY(fmax)
TP_FLOAT_BINARY(fmin)
TP_FLOAT_BINARY(fmod)
TP_FLOAT_BINARY(pow)
#undef TP_FLOAT_BINARY

inline float fma(float X, float Y, float Z) { return fmaf(X, Y, Z); }
inline float frexp(float X, int *Exponent) { return frexpf(X, Exponent); }
inline float ldexp(float X, int Exponent) { return ldexpf(X, Exponent); }
inline float scalbn(float X, int Exponent) { return scalbnf(X, Exponent); }
inline float modf(float X, float *Whole) { return modff(X, Whole); }
inline long lrint(float X) { return lrintf(X); }
inline long lround(float X) { return lroundf(X); }

#define TP_CLASSIFY(Type)                                                      \
  inline int fpclassify(Type X) {                                              \
    return __builtin_fpclassify(FP_NAN, FP_INFINITE, FP_NORMAL, FP_SUBNORMAL,  \
                                FP_ZERO, X);                                   \
  }                                                                            \
  inline bool isfinite(Type X) { return __builtin_isfinite(X); }               \
  inline bool isinf(Type X) { return __builtin_isinf(X); }                     \
  inline bool isnan(Type X) { return __builtin_isnan(X); }                     \
  inline bool isnormal(Type X) { return __builtin_isnormal(X); }               \
  inline bool signbit(Type X) { return __builtin_signbit(X); }                 \
  inline bool isgreater(Type X, Type Y) { return __builtin_isgreater(X, Y); }  \
  inline bool isgreaterequal(Type X, Type Y) {                                 \
    return __builtin_isgreaterequal(X, Y);                                     \
  }                                                                            \
  inline bool isless(Type X, Type Y) { return __builtin_isless(X, Y); }        \
  inline bool islessequal(Type X, Type Y) {                                    \
    return __builtin_islessequal(X, Y);                                        \
  }                                                                            \
  inline bool isunordered(Type X, Type Y) {                                    \
    return __builtin_isunordered(X, Y);                                        \
  }
TP_CLASSIFY(float)
TP_CLASSIFY(double)
#undef TP_CLASSIFY

} // extern "C++"

#include <stdlib.h>

#endif // TP_LIBSTDCXX_MATH_H
