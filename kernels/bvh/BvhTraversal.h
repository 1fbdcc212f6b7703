//===- BvhTraversal.h - Rays through a BVH ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Written for an in-order processor whose loads take long but do not block: all
// words of a node or triangle are asked for before the first is used.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_BVHTRAVERSAL_H
#define TP_KERNELS_BVH_BVHTRAVERSAL_H

#include "kernels/common/FloatMath.h"
#include "kernels/common/SceneLayout.h"

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
};

/// What the box tests of one ray share.
class RayBoxTester {
public:
  explicit RayBoxTester(const Ray &R)
      : Origin(R.Origin),
        Inverse{inverse(R.Direction.X), inverse(R.Direction.Y),
                inverse(R.Direction.Z)},
        NearX(nearOffset(R.Direction.X)), NearY(nearOffset(R.Direction.Y)),
        NearZ(nearOffset(R.Direction.Z)), FarX(kBoundsSideBytes - NearX),
        FarY(kBoundsSideBytes - NearY), FarZ(kBoundsSideBytes - NearZ) {}

  /// For both children of a node, the distances at which the ray enters and
  /// leaves their boxes, within (0, MaxDistance); it misses where Enter >
  /// Leave.
  struct Distances {
    float Enter[2];
    float Leave[2];
  };

  Distances test(const char *Node, float MaxDistance) const {
    const float *NearXs = bounds(Node + NearX, 0);
    const float *NearYs = bounds(Node + NearY, 1);
    const float *NearZs = bounds(Node + NearZ, 2);
    const float *FarXs = bounds(Node + FarX, 0);
    const float *FarYs = bounds(Node + FarY, 1);
    const float *FarZs = bounds(Node + FarZ, 2);
    Distances Result;
    for (unsigned Child = 0; Child != 2; ++Child) {
      Result.Enter[Child] =
          maximum(maximum((NearXs[Child] - Origin.X) * Inverse.X,
                          (NearYs[Child] - Origin.Y) * Inverse.Y),
                  maximum((NearZs[Child] - Origin.Z) * Inverse.Z, 0.0f));
      Result.Leave[Child] =
          minimum(minimum((FarXs[Child] - Origin.X) * Inverse.X,
                          (FarYs[Child] - Origin.Y) * Inverse.Y),
                  minimum((FarZs[Child] - Origin.Z) * Inverse.Z, MaxDistance));
    }
    return Result;
  }

private:
  /// Finite for every direction, so that no 0 * infinity comes up.
  static float inverse(float Component) {
    constexpr float Tiny = 1e-18f;
    if (Component < 0.0f)
      return 1.0f / minimum(Component, -Tiny);
    return 1.0f / maximum(Component, Tiny);
  }
  static uint32_t nearOffset(float Component) {
    return Component < 0.0f ? kBoundsSideBytes : 0;
  }
  static const float *bounds(const char *Side, uint32_t Axis) {
    return reinterpret_cast<const float *>(Side + boundsOffset(Axis));
  }

  Vector3 Origin;
  Vector3 Inverse;
  uint32_t NearX, NearY, NearZ;
  uint32_t FarX, FarY, FarZ;
};

/// The distance at which \p R meets \p Triangle, or \p MaxDistance if it does
/// not before that.
inline float intersectTriangle(const TriangleRecord &Triangle, const Ray &R,
                               float MaxDistance) {
  const PlaneEquation Plane = Triangle.Plane;
  const PlaneEquation URow = Triangle.U;
  const PlaneEquation VRow = Triangle.V;
  const float Height = dot(Plane.Direction, R.Origin) + Plane.Offset;
  const float Distance = -Height / dot(Plane.Direction, R.Direction);
  // Also false if the ray lies in the plane and Distance is NaN.
  if (!(Distance > 0.0f && Distance < MaxDistance))
    return MaxDistance;
  const Vector3 Point = R.Origin + R.Direction * Distance;
  const float U = dot(URow.Direction, Point) + URow.Offset;
  const float V = dot(VRow.Direction, Point) + VRow.Offset;
  return U >= 0.0f && V >= 0.0f && U + V <= 1.0f ? Distance : MaxDistance;
}

enum class HitQuery {
  /// The first triangle along the ray.
  Closest,
  /// Whether there is a triangle; which one is arbitrary.
  Any
};

/// Finds where \p R meets a triangle of the scene before \p MaxDistance.
template <HitQuery Query>
inline Hit findHit(const SceneView &Scene, BvhReference Root, const Ray &R,
                   float MaxDistance) {
  struct StackEntry {
    BvhReference Reference;
    float Enter;
  };
  StackEntry Stack[kMaxBvhDepth];
  StackEntry *Top = Stack;

  const RayBoxTester Boxes(R);
  Hit Found{MaxDistance, kNoTriangle};
  BvhReference Reference = Root;
  for (;;) {
    if (!isLeaf(Reference)) {
      const char *Node = Scene.Nodes + Reference;
      const BvhReference *Children =
          reinterpret_cast<const BvhNode *>(Node)->Child;
      const BvhReference Child0 = Children[0];
      const BvhReference Child1 = Children[1];
      const RayBoxTester::Distances D = Boxes.test(Node, Found.Distance);
      const bool Hit0 = D.Enter[0] <= D.Leave[0];
      const bool Hit1 = D.Enter[1] <= D.Leave[1];
      if (Hit0 && Hit1) {
        if (D.Enter[0] <= D.Enter[1]) {
          *Top++ = {Child1, D.Enter[1]};
          Reference = Child0;
        } else {
          *Top++ = {Child0, D.Enter[0]};
          Reference = Child1;
        }
        continue;
      }
      if (Hit0) {
        Reference = Child0;
        continue;
      }
      if (Hit1) {
        Reference = Child1;
        continue;
      }
    } else {
      uint32_t Triangle = leafFirst(Reference);
      const uint32_t End = Triangle + leafCount(Reference);
      for (; Triangle != End; ++Triangle) {
        const float Distance =
            intersectTriangle(Scene.Triangles[Triangle], R, Found.Distance);
        if (Distance < Found.Distance) {
          Found = {Distance, Triangle};
          if (Query == HitQuery::Any)
            return Found;
        }
      }
    }
    do {
      if (Top == Stack)
        return Found;
      --Top;
    } while (Query == HitQuery::Closest && Top->Enter > Found.Distance);
    Reference = Top->Reference;
  }
}

} // namespace tp

#endif // TP_KERNELS_BVH_BVHTRAVERSAL_H
