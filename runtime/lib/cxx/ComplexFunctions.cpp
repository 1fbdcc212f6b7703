//===- ComplexFunctions.cpp - <complex.h> by means of <complex> -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include <complex>

// long double is double.
#define TP_TYPES(Define, Name, Function)                                       \
  Define(float, Name##f, Function, float)                                      \
      Define(double, Name, Function, double)                                   \
          Define(long double, Name##l, Function, double)
#define TP_DEFINE_UNARY(Type, Name, Function, Computed)                        \
  Type _Complex Name(Type _Complex Z) {                                        \
    return Function(std::complex<Computed>(static_cast<Computed _Complex>(Z))) \
        .__rep();                                                              \
  }
#define TP_DEFINE_REAL(Type, Name, Function, Computed)                         \
  Type Name(Type _Complex Z) {                                                 \
    return Function(                                                           \
        std::complex<Computed>(static_cast<Computed _Complex>(Z)));            \
  }
#define TP_DEFINE_BINARY(Type, Name, Function, Computed)                       \
  Type _Complex Name(Type _Complex Z, Type _Complex W) {                       \
    return Function(std::complex<Computed>(static_cast<Computed _Complex>(Z)), \
                    std::complex<Computed>(static_cast<Computed _Complex>(W))) \
        .__rep();                                                              \
  }
#define TP_UNARY(Name, Function) TP_TYPES(TP_DEFINE_UNARY, Name, std::Function)
#define TP_REAL(Name, Function) TP_TYPES(TP_DEFINE_REAL, Name, std::Function)

extern "C" {
TP_UNARY(cacos, acos)
TP_UNARY(cacosh, acosh)
TP_UNARY(casin, asin)
TP_UNARY(casinh, asinh)
TP_UNARY(catan, atan)
TP_UNARY(catanh, atanh)
TP_UNARY(conj, conj)
TP_UNARY(ccos, cos)
TP_UNARY(ccosh, cosh)
TP_UNARY(cexp, exp)
TP_UNARY(clog, log)
TP_UNARY(cproj, proj)
TP_UNARY(csin, sin)
TP_UNARY(csinh, sinh)
TP_UNARY(csqrt, sqrt)
TP_UNARY(ctan, tan)
TP_UNARY(ctanh, tanh)

TP_REAL(cabs, abs)
TP_REAL(carg, arg)
TP_REAL(cimag, imag)
TP_REAL(creal, real)

TP_TYPES(TP_DEFINE_BINARY, cpow, std::pow)
} // extern "C"
