//===- Complex.cpp - Products and quotients of complex numbers ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// As annex G of the C standard has them: a result is infinite, not NaN, where
// an operand is infinite. The operators * and / of complex numbers call these
// functions, so that these use the parts only.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"

namespace {

template <typename T> struct Parts {
  T Real, Imaginary;
};

} // namespace

template <typename T> static bool isInfinite(Parts<T> Z) {
  return __builtin_isinf(Z.Real) || __builtin_isinf(Z.Imaginary);
}

template <typename T> static bool isFinite(Parts<T> Z) {
  return __builtin_isfinite(Z.Real) && __builtin_isfinite(Z.Imaginary);
}

template <typename T> static bool isNaN(T X) { return __builtin_isnan(X); }

template <typename T> static T copySign(T X, T Sign) {
  if constexpr (sizeof(T) == sizeof(float))
    return __builtin_copysignf(X, Sign);
  else
    return __builtin_copysign(X, Sign);
}

/// Infinite parts become ones, the others zeros, with their signs.
template <typename T> static Parts<T> unitOf(Parts<T> Z) {
  return {copySign(T(__builtin_isinf(Z.Real) ? 1 : 0), Z.Real),
          copySign(T(__builtin_isinf(Z.Imaginary) ? 1 : 0), Z.Imaginary)};
}

/// NaN parts become zeros with their signs.
template <typename T> static Parts<T> withoutNaN(Parts<T> Z) {
  return {isNaN(Z.Real) ? copySign(T(0), Z.Real) : Z.Real,
          isNaN(Z.Imaginary) ? copySign(T(0), Z.Imaginary) : Z.Imaginary};
}

template <typename T> static Parts<T> product(Parts<T> A, Parts<T> B) {
  const T Infinity = __builtin_inf();
  const T RealReal = A.Real * B.Real;
  const T ImaginaryImaginary = A.Imaginary * B.Imaginary;
  const T RealImaginary = A.Real * B.Imaginary;
  const T ImaginaryReal = A.Imaginary * B.Real;
  Parts<T> Z = {RealReal - ImaginaryImaginary, RealImaginary + ImaginaryReal};
  if (!isNaN(Z.Real) || !isNaN(Z.Imaginary))
    return Z;
  bool IsInfinite = isInfinite(A) || isInfinite(B);
  if (isInfinite(A)) {
    A = unitOf(A);
    B = withoutNaN(B);
  }
  if (isInfinite(B)) {
    B = unitOf(B);
    A = withoutNaN(A);
  }
  if (!IsInfinite &&
      (__builtin_isinf(RealReal) || __builtin_isinf(ImaginaryImaginary) ||
       __builtin_isinf(RealImaginary) || __builtin_isinf(ImaginaryReal))) {
    A = withoutNaN(A);
    B = withoutNaN(B);
    IsInfinite = true;
  }
  if (IsInfinite)
    Z = {Infinity * (A.Real * B.Real - A.Imaginary * B.Imaginary),
         Infinity * (A.Real * B.Imaginary + A.Imaginary * B.Real)};
  return Z;
}

/// What a quotient that came out as NaN is.
template <typename T>
static Parts<T> specialQuotient(Parts<T> A, Parts<T> B, Parts<T> Z) {
  const T Infinity = __builtin_inf();
  if (B.Real == 0 && B.Imaginary == 0 &&
      (!isNaN(A.Real) || !isNaN(A.Imaginary)))
    return {copySign(Infinity, B.Real) * A.Real,
            copySign(Infinity, B.Real) * A.Imaginary};
  if (isInfinite(A) && isFinite(B)) {
    A = unitOf(A);
    return {Infinity * (A.Real * B.Real + A.Imaginary * B.Imaginary),
            Infinity * (A.Imaginary * B.Real - A.Real * B.Imaginary)};
  }
  if (isInfinite(B) && isFinite(A)) {
    B = unitOf(B);
    return {T(0) * (A.Real * B.Real + A.Imaginary * B.Imaginary),
            T(0) * (A.Imaginary * B.Real - A.Real * B.Imaginary)};
  }
  return Z;
}

/// Makes the larger part of \p Z one of [1, 2) by a power of two, whose
/// exponent it returns. Zeros, infinities and NaN stay.
static int normalize(Parts<double> &Z) {
  const double Real = __builtin_fabs(Z.Real);
  const double Imaginary = __builtin_fabs(Z.Imaginary);
  const double Largest = Real > Imaginary ? Real : Imaginary;
  if (Largest == 0 || !isFinite(Z))
    return 0;
  const int Exponent = __builtin_ilogb(Largest);
  Z = {__builtin_scalbn(Z.Real, -Exponent),
       __builtin_scalbn(Z.Imaginary, -Exponent)};
  return Exponent;
}

static Parts<double> quotient(const Parts<double> A, const Parts<double> B) {
  Parts<double> C = A;
  Parts<double> D = B;
  int Exponent = normalize(C);
  Exponent -= normalize(D);
  const double Norm = D.Real * D.Real + D.Imaginary * D.Imaginary;
  const double Real = (C.Real * D.Real + C.Imaginary * D.Imaginary) / Norm;
  const double Imaginary = (C.Imaginary * D.Real - C.Real * D.Imaginary) / Norm;
  Parts<double> Z = {__builtin_scalbn(Real, Exponent),
                     __builtin_scalbn(Imaginary, Exponent)};
  if (isNaN(Z.Real) && isNaN(Z.Imaginary))
    return specialQuotient(A, B, Z);
  return Z;
}

template <typename Complex, typename T> static Complex complexOf(Parts<T> Z) {
  Complex Result;
  __real__ Result = Z.Real;
  __imag__ Result = Z.Imaginary;
  return Result;
}

extern "C" {

_Complex float TP_LIBCALL(__mulsc3)(float A, float B, float C, float D) {
  return complexOf<_Complex float>(product<float>({A, B}, {C, D}));
}

_Complex double TP_LIBCALL(__muldc3)(double A, double B, double C, double D) {
  return complexOf<_Complex double>(product<double>({A, B}, {C, D}));
}

_Complex float TP_LIBCALL(__divsc3)(float A, float B, float C, float D) {
  // Products of floats neither overflow nor vanish in double.
  Parts<double> Z = quotient({A, B}, {C, D});
  return complexOf<_Complex float>(Parts<float>{
      static_cast<float>(Z.Real), static_cast<float>(Z.Imaginary)});
}

_Complex double TP_LIBCALL(__divdc3)(double A, double B, double C, double D) {
  return complexOf<_Complex double>(quotient({A, B}, {C, D}));
}

} // extern "C"
