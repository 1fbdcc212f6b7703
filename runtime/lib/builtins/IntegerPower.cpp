//===- IntegerPower.cpp - Powers with integer exponents -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What the optimizer makes of pow(x, n) under -ffast-math, by repeated
// squaring; the error grows with the exponent.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"

template <typename T> static inline T power(T Base, int Exponent) {
  uint32_t Count = Exponent < 0 ? -static_cast<uint32_t>(Exponent)
                                : static_cast<uint32_t>(Exponent);
  T Result = 1;
  for (; Count != 0; Count >>= 1) {
    if (Count & 1)
      Result *= Base;
    Base *= Base;
  }
  return Exponent < 0 ? 1 / Result : Result;
}

extern "C" {

double TP_LIBCALL(__powidf2)(double A, int Exponent) {
  return power(A, Exponent);
}

float TP_LIBCALL(__powisf2)(float A, int Exponent) {
  return power(A, Exponent);
}

} // extern "C"
