/*===- complex.h - Complex numbers ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_COMPLEX_H
#define TP_LIBC_COMPLEX_H

#define complex _Complex
#define _Complex_I (__extension__ 1.0iF)
#define I _Complex_I
#define CMPLX(X, Y) __builtin_complex((double)(X), (double)(Y))
#define CMPLXF(X, Y) __builtin_complex((float)(X), (float)(Y))
#define CMPLXL(X, Y) __builtin_complex((long double)(X), (long double)(Y))

#ifdef __cplusplus
extern "C" {
#endif

/* Those of std::complex in C++. */
float cabsf(float _Complex Z);
float _Complex cacosf(float _Complex Z);
float _Complex cacoshf(float _Complex Z);
float cargf(float _Complex Z);
float _Complex casinf(float _Complex Z);
float _Complex casinhf(float _Complex Z);
float _Complex catanf(float _Complex Z);
float _Complex catanhf(float _Complex Z);
float _Complex conjf(float _Complex Z);
float _Complex ccosf(float _Complex Z);
float _Complex ccoshf(float _Complex Z);
float _Complex cexpf(float _Complex Z);
float cimagf(float _Complex Z);
float _Complex clogf(float _Complex Z);
float _Complex cpowf(float _Complex Z, float _Complex Exponent);
float _Complex cprojf(float _Complex Z);
float crealf(float _Complex Z);
float _Complex csinf(float _Complex Z);
float _Complex csinhf(float _Complex Z);
float _Complex csqrtf(float _Complex Z);
float _Complex ctanf(float _Complex Z);
float _Complex ctanhf(float _Complex Z);

double cabs(double _Complex Z);
double _Complex cacos(double _Complex Z);
double _Complex cacosh(double _Complex Z);
double carg(double _Complex Z);
double _Complex casin(double _Complex Z);
double _Complex casinh(double _Complex Z);
double _Complex catan(double _Complex Z);
double _Complex catanh(double _Complex Z);
double _Complex conj(double _Complex Z);
double _Complex ccos(double _Complex Z);
double _Complex ccosh(double _Complex Z);
double _Complex cexp(double _Complex Z);
double cimag(double _Complex Z);
double _Complex clog(double _Complex Z);
double _Complex cpow(double _Complex Z, double _Complex Exponent);
double _Complex cproj(double _Complex Z);
double creal(double _Complex Z);
double _Complex csin(double _Complex Z);
double _Complex csinh(double _Complex Z);
double _Complex csqrt(double _Complex Z);
double _Complex ctan(double _Complex Z);
double _Complex ctanh(double _Complex Z);

long double cabsl(long double _Complex Z);
long double _Complex cacosl(long double _Complex Z);
long double _Complex cacoshl(long double _Complex Z);
long double cargl(long double _Complex Z);
long double _Complex casinl(long double _Complex Z);
long double _Complex casinhl(long double _Complex Z);
long double _Complex catanl(long double _Complex Z);
long double _Complex catanhl(long double _Complex Z);
long double _Complex conjl(long double _Complex Z);
long double _Complex ccosl(long double _Complex Z);
long double _Complex ccoshl(long double _Complex Z);
long double _Complex cexpl(long double _Complex Z);
long double cimagl(long double _Complex Z);
long double _Complex clogl(long double _Complex Z);
long double _Complex cpowl(long double _Complex Z,
                           long double _Complex Exponent);
long double _Complex cprojl(long double _Complex Z);
long double creall(long double _Complex Z);
long double _Complex csinl(long double _Complex Z);
long double _Complex csinhl(long double _Complex Z);
long double _Complex csqrtl(long double _Complex Z);
long double _Complex ctanl(long double _Complex Z);
long double _Complex ctanhl(long double _Complex Z);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_COMPLEX_H */
