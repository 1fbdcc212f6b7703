//===- RayTriangleTester.h - A ray against triangles ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// After S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2(1), 2013: vertices are moved and sheared so that the
// ray is the axis, and three products of their coordinates tell on which side
// of each edge it passes. Triangles that share an edge compute the same numbers
// for it, so no ray slips between them. A ray that meets an edge exactly meets
// all its triangles: there is no second computation in double precision.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_RAYTRIANGLETESTER_H
#define TP_KERNELS_BVH_RAYTRIANGLETESTER_H

#include "kernels/bvh/Ray.h"
#include "kernels/common/EarlyLoad.h"
#include "kernels/common/FloatMath.h"
#include "kernels/common/Inline.h"
#include "kernels/common/SceneLayout.h"

#include <stddef.h>

namespace tp {

/// What the tests of one ray against triangles share.
class RayTriangleTester {
public:
  TP_KERNEL_INLINE explicit RayTriangleTester(const Ray &R) {
    // The axis along which the ray goes farthest is the last.
    const float SizeX = fabs(R.Direction.X);
    const float SizeY = fabs(R.Direction.Y);
    const float SizeZ = fabs(R.Direction.Z);
    const bool IsX = (SizeX >= SizeY) & (SizeX >= SizeZ);
    const bool IsY = !IsX & (SizeY >= SizeZ);
    const Vector3 O = turn(R.Origin, IsX, IsY);
    const Vector3 D = turn(R.Direction, IsX, IsY);
    Origin = O;
    InverseZ = 1.0f / D.Z;
    ShearX = D.X / D.Z;
    ShearY = D.Y / D.Z;
    OffsetX = IsX ? 4 : IsY ? 8 : 0;
    OffsetY = IsX ? 8 : IsY ? 0 : 4;
    OffsetZ = IsX ? 0 : IsY ? 4 : 8;
  }

  /// Replaces \p Found by the nearest hit that is nearer among \p Count
  /// triangles, whose numbers begin with \p First. The corners of the first
  /// are at \p Corners, those of each other \p Stride bytes behind those of
  /// the one before.
  template <unsigned Count>
  TP_KERNEL_INLINE void test(const char *Corners, uint32_t Stride,
                             uint32_t First, Hit &Found) const {
    Shape Shapes[Count];
    for (unsigned Triangle = 0; Triangle != Count; ++Triangle)
      Shapes[Triangle] = load(Corners + size_t(Triangle) * Stride);
    // One wait for all.
    for (Shape &Each : Shapes)
      for (unsigned Corner = 0; Corner != 3; ++Corner) {
        loadHere(Each.X[Corner]);
        loadHere(Each.Y[Corner]);
        loadHere(Each.Z[Corner]);
      }
    for (unsigned Triangle = 0; Triangle != Count; ++Triangle)
      test(Shapes[Triangle], First + Triangle, Found);
  }

private:
  /// Three corners, the axes turned.
  struct Shape {
    float X[3];
    float Y[3];
    float Z[3];
  };

  /// \p V with its axes turned so that X or Y, if wanted, is the last.
  static Vector3 turn(Vector3 V, bool IsX, bool IsY) {
    return {IsX   ? V.Y
            : IsY ? V.Z
                  : V.X,
            IsX   ? V.Z
            : IsY ? V.X
                  : V.Y,
            IsX   ? V.X
            : IsY ? V.Y
                  : V.Z};
  }

  TP_KERNEL_INLINE Shape load(const char *Corners) const {
    Shape Result;
    for (unsigned Corner = 0; Corner != 3; ++Corner) {
      Result.X[Corner] = word(Corners + OffsetX, Corner);
      Result.Y[Corner] = word(Corners + OffsetY, Corner);
      Result.Z[Corner] = word(Corners + OffsetZ, Corner);
    }
    return Result;
  }
  TP_KERNEL_INLINE static float word(const char *Axis, unsigned Corner) {
    return reinterpret_cast<const float *>(Axis)[size_t(3) * Corner];
  }

  TP_KERNEL_INLINE void test(const Shape &Triangle, uint32_t Number,
                             Hit &Found) const {
    float X[3], Y[3], Z[3];
    for (unsigned Corner = 0; Corner != 3; ++Corner) {
      Z[Corner] = Triangle.Z[Corner] - Origin.Z;
      X[Corner] = Triangle.X[Corner] - Origin.X - ShearX * Z[Corner];
      Y[Corner] = Triangle.Y[Corner] - Origin.Y - ShearY * Z[Corner];
    }
    const float U = X[2] * Y[1] - Y[2] * X[1];
    const float V = X[0] * Y[2] - Y[0] * X[2];
    const float W = X[1] * Y[0] - Y[1] * X[0];
    const bool IsLeft = minimum(minimum(U, V), W) >= 0.0f;
    const bool IsRight = maximum(maximum(U, V), W) <= 0.0f;
    if (!(IsLeft | IsRight))
      return;
    // NaN if the ray passes along all three edges; then no comparison is true.
    const float Distance =
        (U * Z[0] + V * Z[1] + W * Z[2]) / (U + V + W) * InverseZ;
    if (Distance > 0.0f)
      Found.take(Distance, Number);
  }

  Vector3 Origin;
  float InverseZ;
  float ShearX;
  float ShearY;
  /// Of the turned axes in a vector, in bytes.
  uint32_t OffsetX, OffsetY, OffsetZ;
};

} // namespace tp

#endif // TP_KERNELS_BVH_RAYTRIANGLETESTER_H
