//===- FloatMath.h - Minimum and maximum of numbers -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_FLOATMATH_H
#define TP_KERNELS_COMMON_FLOATMATH_H

#include "tp/math.h"

namespace tp {

// tp::fmin and fmax without their promises about NaN and the sign of zero, of
// which the host would have to keep track in code. Here neither operand is NaN,
// and which zero comes out of two must not matter to the caller.

#ifdef __tp__
inline float minimum(float A, float B) { return fmin(A, B); }
inline float maximum(float A, float B) { return fmax(A, B); }
#else
constexpr float minimum(float A, float B) { return A < B ? A : B; }
constexpr float maximum(float A, float B) { return A > B ? A : B; }
#endif

} // namespace tp

#endif // TP_KERNELS_COMMON_FLOATMATH_H
