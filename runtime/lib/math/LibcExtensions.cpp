//===- LibcExtensions.cpp - What clang's math builtins call besides -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"
#include <math.h>

using namespace tp;

extern "C" {

double exp10(double X) { return pow(10, X); }
float exp10f(float X) { return powf(10, X); }

// A NaN wins; -0 is less than +0.
double fmaximum(double X, double Y) {
  return isNaN(X) || isNaN(Y) ? doubleNaN() : fmax(X, Y);
}
double fminimum(double X, double Y) {
  return isNaN(X) || isNaN(Y) ? doubleNaN() : fmin(X, Y);
}

} // extern "C"
