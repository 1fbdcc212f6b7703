/*===- math.h - Mathematical functions ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_MATH_H
#define TP_LIBC_MATH_H

/* The functions of float are those of tp/math.h, which states their errors.
 * double is computed in software. long double is double. No function sets
 * errno. */

#define HUGE_VAL __builtin_huge_val()
#define HUGE_VALF __builtin_huge_valf()
#define INFINITY __builtin_inff()
#define NAN __builtin_nanf("")

#define M_E 2.7182818284590452354
#define M_LOG2E 1.4426950408889634074
#define M_LOG10E 0.43429448190325182765
#define M_LN2 0.69314718055994530942
#define M_LN10 2.30258509299404568402
#define M_PI 3.14159265358979323846
#define M_PI_2 1.57079632679489661923
#define M_PI_4 0.78539816339744830962
#define M_1_PI 0.31830988618379067154
#define M_2_PI 0.63661977236758134308
#define M_SQRT2 1.41421356237309504880
#define M_SQRT1_2 0.70710678118654752440

#define FP_NAN 0
#define FP_INFINITE 1
#define FP_ZERO 2
#define FP_SUBNORMAL 3
#define FP_NORMAL 4

#define fpclassify(X)                                                          \
  __builtin_fpclassify(FP_NAN, FP_INFINITE, FP_NORMAL, FP_SUBNORMAL, FP_ZERO, X)
#define isfinite(X) __builtin_isfinite(X)
#define isinf(X) __builtin_isinf(X)
#define isnan(X) __builtin_isnan(X)
#define isnormal(X) __builtin_isnormal(X)
#define signbit(X) __builtin_signbit(X)
#define isgreater(X, Y) __builtin_isgreater(X, Y)
#define isgreaterequal(X, Y) __builtin_isgreaterequal(X, Y)
#define isless(X, Y) __builtin_isless(X, Y)
#define islessequal(X, Y) __builtin_islessequal(X, Y)
#define islessgreater(X, Y) __builtin_islessgreater(X, Y)
#define isunordered(X, Y) __builtin_isunordered(X, Y)

#ifdef __cplusplus
extern "C" {
#endif

typedef float float_t;
typedef double double_t;

float acosf(float X);
float asinf(float X);
float atanf(float X);
float atan2f(float Y, float X);
float ceilf(float X);
float copysignf(float Magnitude, float Sign);
float cosf(float X);
float exp2f(float X);
float expf(float X);
float fabsf(float X);
float fdimf(float X, float Y);
float floorf(float X);
float fmaf(float X, float Y, float Z);
float fmaxf(float X, float Y);
float fminf(float X, float Y);
float fmodf(float X, float Y);
float frexpf(float X, int *Exponent);
float hypotf(float X, float Y);
float ldexpf(float X, int Exponent);
float log10f(float X);
float log2f(float X);
float logf(float X);
float modff(float X, float *Whole);
float nearbyintf(float X);
float powf(float X, float Y);
float rintf(float X);
float roundevenf(float X);
float roundf(float X);
float scalbnf(float X, int Exponent);
float sinf(float X);
float sqrtf(float X);
float tanf(float X);
float truncf(float X);
long lrintf(float X);
long lroundf(float X);

/* In units in the last place of the exact result, the greatest errors found in
 * 900,000 arguments of all magnitudes (test/unit/runtime/DoubleMathTest.cpp):
 * log, log2, log10 0.51; asin, acos, atan 0.7; atan2 0.75; exp, exp2, pow 0.8;
 * sin, cos 0.85; tan 0.95. The others below are exact or correctly rounded. */
double acos(double X);
double asin(double X);
double atan(double X);
double atan2(double Y, double X);
double cos(double X);
double exp(double X);
double exp2(double X);
double log(double X);
double log10(double X);
double log2(double X);
double pow(double X, double Y);
double sin(double X);
double tan(double X);

double ceil(double X);
double copysign(double Magnitude, double Sign);
double fabs(double X);
double fdim(double X, double Y);
double floor(double X);
double fma(double X, double Y, double Z);
double fmax(double X, double Y);
double fmin(double X, double Y);
double fmod(double X, double Y);
double frexp(double X, int *Exponent);
double ldexp(double X, int Exponent);
double modf(double X, double *Whole);
double nearbyint(double X);
double rint(double X);
double round(double X);
double roundeven(double X);
double scalbn(double X, int Exponent);
double sqrt(double X);
double trunc(double X);
long lrint(double X);
long lround(double X);
long long llrint(double X);
long long llround(double X);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_MATH_H */
