//===- TriangleIntersection.h - A ray against a triangle --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_TRIANGLEINTERSECTION_H
#define TP_KERNELS_BVH_TRIANGLEINTERSECTION_H

#include "kernels/bvh/Ray.h"
#include "kernels/common/Inline.h"
#include "kernels/common/SceneLayout.h"

namespace tp {

/// What intersectTriangle() returns for a miss: beyond every distance.
inline constexpr float kMissDistance = 0x1p127f;

/// The distance at which \p R meets \p Triangle, or kMissDistance. Without
/// branches, so that nothing delays a load until it is known to be needed.
TP_KERNEL_INLINE float intersectTriangle(const TriangleRecord &Triangle,
                                         const Ray &R) {
  const PlaneEquation Plane = Triangle.Plane;
  const PlaneEquation URow = Triangle.U;
  const PlaneEquation VRow = Triangle.V;
  const float Height = dot(Plane.Direction, R.Origin) + Plane.Offset;
  const float Distance = -Height / dot(Plane.Direction, R.Direction);
  const Vector3 Point = R.Origin + R.Direction * Distance;
  const float U = dot(URow.Direction, Point) + URow.Offset;
  const float V = dot(VRow.Direction, Point) + VRow.Offset;
  // For a ray in the triangle's plane, Distance and with it U and V may be
  // infinite or NaN: then a comparison is false.
  const bool IsHit =
      (Distance > 0.0f) & (U >= 0.0f) & (V >= 0.0f) & (U + V <= 1.0f);
  return IsHit ? Distance : kMissDistance;
}

} // namespace tp

#endif // TP_KERNELS_BVH_TRIANGLEINTERSECTION_H
