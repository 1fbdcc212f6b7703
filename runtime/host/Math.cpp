//===- Math.cpp - The TP's float instructions on the host -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/FloatParts.h"
#include "simulator/isa/Trigonometry.h"

namespace tp {

float rsqrt(float X) {
  return static_cast<float>(1.0 /
                            __builtin_elementwise_sqrt(static_cast<double>(X)));
}

float rcp(float X) { return 1.0f / X; }

float fastSin(float X) { return sine(X); }

float fastCos(float X) { return cosine(X); }

float fmin(float A, float B) {
  if (A != A)
    return B != B ? floatNaN() : B;
  if (B != B)
    return A;
  if (A == B)
    return floatBits(A) & kFloatSign ? A : B;
  return A < B ? A : B;
}

float fmax(float A, float B) {
  if (A != A)
    return B != B ? floatNaN() : B;
  if (B != B)
    return A;
  if (A == B)
    return floatBits(A) & kFloatSign ? B : A;
  return A > B ? A : B;
}

} // namespace tp
