//===- FloatMath.h - Float functions of the kernels -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_FLOATMATH_H
#define TP_KERNELS_COMMON_FLOATMATH_H

#include <math.h>

namespace tp {

inline float minimum(float A, float B) { return A < B ? A : B; }
inline float maximum(float A, float B) { return A > B ? A : B; }
inline float squareRoot(float X) { return __builtin_sqrtf(X); }
inline float sine(float X) { return sinf(X); }
inline float cosine(float X) { return cosf(X); }

} // namespace tp

#endif // TP_KERNELS_COMMON_FLOATMATH_H
