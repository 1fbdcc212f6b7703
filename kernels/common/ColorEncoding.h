//===- ColorEncoding.h - Linear colours to framebuffer pixels ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_COLORENCODING_H
#define TP_KERNELS_COMMON_COLORENCODING_H

#include "kernels/common/FloatMath.h"
#include "kernels/common/Vector3.h"

#include <stdint.h>

namespace tp {

/// The sRGB transfer function (IEC 61966-2-1) of \p Linear in [0, 1]. Above the
/// function's linear part its power of 1/2.4 is approximated by the minimax
/// combination of the square root, the fourth root, the value and 1, which is
/// within 0.0004 (a tenth of the step between two 8-bit values).
inline float encodeSrgb(float Linear) {
  if (Linear <= 0.0031308f)
    return 12.92f * Linear;
  const float Root = sqrt(Linear);
  const float FourthRoot = sqrt(Root);
  return 0.8337566f * Root + 0.2981040f * FourthRoot - 0.0553170f * Linear -
         0.0769025f;
}

/// A channel clamped to [0, 1] and encoded, rounded to the nearest of 0..255.
/// NaN makes 0.
inline uint32_t encodeChannel(float Linear) {
  const float Clamped = Linear > 0.0f ? minimum(Linear, 1.0f) : 0.0f;
  return static_cast<uint32_t>(
      static_cast<int32_t>(encodeSrgb(Clamped) * 255.0f + 0.5f));
}

/// An opaque framebuffer pixel (see LaunchBlock) of the linear \p Color.
inline uint32_t encodePixel(Vector3 Color) {
  return encodeChannel(Color.X) | encodeChannel(Color.Y) << 8 |
         encodeChannel(Color.Z) << 16 | 0xFF000000u;
}

} // namespace tp

#endif // TP_KERNELS_COMMON_COLORENCODING_H
