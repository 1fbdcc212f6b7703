//===- Ray.h - A ray and where it meets a triangle --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_RAY_H
#define TP_KERNELS_BVH_RAY_H

#include "kernels/common/Vector3.h"

#include <stdint.h>

namespace tp {

/// Points Origin + t * Direction for t > 0. The direction need not be a unit
/// vector, but neither 0.
struct Ray {
  Vector3 Origin;
  Vector3 Direction;
};

inline constexpr uint32_t kNoTriangle = 0xFFFFFFFFu;

/// Where a ray meets a triangle first.
struct Hit {
  /// In units of the ray's direction.
  float Distance;
  /// Position in the scene's triangle array, or kNoTriangle.
  uint32_t Triangle;

  /// Replaces the hit by one that is nearer. Of two at the same distance, that
  /// of the lower number is, so that the order of tests does not matter.
  void take(float OtherDistance, uint32_t OtherTriangle) {
    const bool IsNearer =
        (OtherDistance < Distance) |
        ((OtherDistance == Distance) & (OtherTriangle < Triangle));
    Distance = IsNearer ? OtherDistance : Distance;
    Triangle = IsNearer ? OtherTriangle : Triangle;
  }
};

} // namespace tp

#endif // TP_KERNELS_BVH_RAY_H
