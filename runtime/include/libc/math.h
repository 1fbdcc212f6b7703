/*===- math.h - Mathematical functions ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_MATH_H
#define TP_LIBC_MATH_H

/* The functions of float are those of tp/math.h, which states their errors;
 * those that are not there are computed as double.
 * double is computed in software. long double is double. No function sets
 * errno. */

#define HUGE_VAL __builtin_huge_val()
#define HUGE_VALF __builtin_huge_valf()
#define HUGE_VALL __builtin_huge_vall()
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
#define M_2_SQRTPI 1.12837916709551257390

#define FP_NAN 0
#define FP_INFINITE 1
#define FP_ZERO 2
#define FP_SUBNORMAL 3
#define FP_NORMAL 4

#define FP_ILOGB0 (-2147483647 - 1)
#define FP_ILOGBNAN (-2147483647 - 1)

#define MATH_ERRNO 1
#define MATH_ERREXCEPT 2
/* The functions report errors by their results alone. */
#define math_errhandling 0

#ifdef __FP_FAST_FMAF
#define FP_FAST_FMAF 1
#endif

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
float acoshf(float X);
float asinf(float X);
float asinhf(float X);
float atanf(float X);
float atan2f(float Y, float X);
float atanhf(float X);
float cbrtf(float X);
float ceilf(float X);
float copysignf(float Magnitude, float Sign);
float cosf(float X);
float coshf(float X);
float erff(float X);
float erfcf(float X);
float expf(float X);
float exp2f(float X);
float exp10f(float X);
float expm1f(float X);
float fabsf(float X);
float fdimf(float X, float Y);
float floorf(float X);
float fmaf(float X, float Y, float Z);
float fmaxf(float X, float Y);
float fminf(float X, float Y);
float fmodf(float X, float Y);
float frexpf(float X, int *Exponent);
float hypotf(float X, float Y);
int ilogbf(float X);
float ldexpf(float X, int Exponent);
float lgammaf(float X);
long long llrintf(float X);
long long llroundf(float X);
float logf(float X);
float log10f(float X);
float log1pf(float X);
float log2f(float X);
float logbf(float X);
long lrintf(float X);
long lroundf(float X);
float modff(float X, float *Whole);
float nanf(const char *Tag);
float nearbyintf(float X);
float nextafterf(float X, float Toward);
float nexttowardf(float X, long double Toward);
float powf(float X, float Y);
float remainderf(float X, float Y);
float remquof(float X, float Y, int *Quotient);
float rintf(float X);
float roundf(float X);
float roundevenf(float X);
float scalblnf(float X, long Exponent);
float scalbnf(float X, int Exponent);
float sinf(float X);
float sinhf(float X);
float sqrtf(float X);
float tanf(float X);
float tanhf(float X);
float tgammaf(float X);
float truncf(float X);

/* In units in the last place of the exact result, the greatest errors found in
 * 900,000 arguments of all magnitudes (test/unit/runtime/DoubleMathTest.cpp):
 * acosh, asinh, atanh, cbrt, log, log2, log10 0.51; asin, acos, atan, log1p
 * 0.7; atan2 0.75; cosh, exp, exp2, pow, sinh, tanh 0.8; sin, cos 0.85; tan
 * 0.95; expm1, hypot 1; erf 1.3; lgamma, tgamma of positive numbers 2, tgamma
 * of others 5; erfc 4. The error of lgamma below 0 is 2.5 * 2^-52 of 1 and the
 * result's magnitude together. The others are exact or correctly rounded. */
double acos(double X);
double acosh(double X);
double asin(double X);
double asinh(double X);
double atan(double X);
double atan2(double Y, double X);
double atanh(double X);
double cbrt(double X);
double ceil(double X);
double copysign(double Magnitude, double Sign);
double cos(double X);
double cosh(double X);
double erf(double X);
double erfc(double X);
double exp(double X);
double exp2(double X);
double exp10(double X);
double expm1(double X);
double fabs(double X);
double fdim(double X, double Y);
double floor(double X);
double fma(double X, double Y, double Z);
double fmax(double X, double Y);
double fmaximum(double X, double Y);
double fmin(double X, double Y);
double fminimum(double X, double Y);
double fmod(double X, double Y);
double frexp(double X, int *Exponent);
double hypot(double X, double Y);
int ilogb(double X);
double ldexp(double X, int Exponent);
double lgamma(double X);
long long llrint(double X);
long long llround(double X);
double log(double X);
double log10(double X);
double log1p(double X);
double log2(double X);
double logb(double X);
long lrint(double X);
long lround(double X);
double modf(double X, double *Whole);
double nan(const char *Tag);
double nearbyint(double X);
double nextafter(double X, double Toward);
double nexttoward(double X, long double Toward);
double pow(double X, double Y);
double remainder(double X, double Y);
double remquo(double X, double Y, int *Quotient);
double rint(double X);
double round(double X);
double roundeven(double X);
double scalbln(double X, long Exponent);
double scalbn(double X, int Exponent);
double sin(double X);
double sinh(double X);
double sqrt(double X);
double tan(double X);
double tanh(double X);
double tgamma(double X);
double trunc(double X);

long double acosl(long double X);
long double acoshl(long double X);
long double asinl(long double X);
long double asinhl(long double X);
long double atanl(long double X);
long double atan2l(long double Y, long double X);
long double atanhl(long double X);
long double cbrtl(long double X);
long double ceill(long double X);
long double copysignl(long double Magnitude, long double Sign);
long double cosl(long double X);
long double coshl(long double X);
long double erfl(long double X);
long double erfcl(long double X);
long double expl(long double X);
long double exp2l(long double X);
long double expm1l(long double X);
long double fabsl(long double X);
long double fdiml(long double X, long double Y);
long double floorl(long double X);
long double fmal(long double X, long double Y, long double Z);
long double fmaxl(long double X, long double Y);
long double fminl(long double X, long double Y);
long double fmodl(long double X, long double Y);
long double frexpl(long double X, int *Exponent);
long double hypotl(long double X, long double Y);
int ilogbl(long double X);
long double ldexpl(long double X, int Exponent);
long double lgammal(long double X);
long long llrintl(long double X);
long long llroundl(long double X);
long double logl(long double X);
long double log10l(long double X);
long double log1pl(long double X);
long double log2l(long double X);
long double logbl(long double X);
long lrintl(long double X);
long lroundl(long double X);
long double modfl(long double X, long double *Whole);
long double nanl(const char *Tag);
long double nearbyintl(long double X);
long double nextafterl(long double X, long double Toward);
long double nexttowardl(long double X, long double Toward);
long double powl(long double X, long double Y);
long double remainderl(long double X, long double Y);
long double remquol(long double X, long double Y, int *Quotient);
long double rintl(long double X);
long double roundl(long double X);
long double roundevenl(long double X);
long double scalblnl(long double X, long Exponent);
long double scalbnl(long double X, int Exponent);
long double sinl(long double X);
long double sinhl(long double X);
long double sqrtl(long double X);
long double tanl(long double X);
long double tanhl(long double X);
long double tgammal(long double X);
long double truncl(long double X);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_MATH_H */
