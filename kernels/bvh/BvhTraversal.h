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

  /// Replaces the hit by one that is nearer.
  void take(float OtherDistance, uint32_t OtherTriangle) {
    const bool IsNearer = OtherDistance < Distance;
    Distance = IsNearer ? OtherDistance : Distance;
    Triangle = IsNearer ? OtherTriangle : Triangle;
  }
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
    const SidePair NearXs = load(Node + NearX, 0);
    const SidePair FarXs = load(Node + FarX, 0);
    const SidePair NearYs = load(Node + NearY, 1);
    const SidePair FarYs = load(Node + FarY, 1);
    const SidePair NearZs = load(Node + NearZ, 2);
    const SidePair FarZs = load(Node + FarZ, 2);
    Distances Result;
    for (unsigned Child = 0; Child != 2; ++Child) {
      Result.Enter[Child] =
          maximum(maximum((NearXs.Child[Child] - Origin.X) * Inverse.X,
                          (NearYs.Child[Child] - Origin.Y) * Inverse.Y),
                  maximum((NearZs.Child[Child] - Origin.Z) * Inverse.Z, 0.0f));
      Result.Leave[Child] = minimum(
          minimum((FarXs.Child[Child] - Origin.X) * Inverse.X,
                  (FarYs.Child[Child] - Origin.Y) * Inverse.Y),
          minimum((FarZs.Child[Child] - Origin.Z) * Inverse.Z, MaxDistance));
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
  /// One side of the boxes of both children, by child.
  struct SidePair {
    float Child[2];
  };
  static SidePair load(const char *Side, uint32_t Axis) {
    const float *Bounds =
        reinterpret_cast<const float *>(Side + boundsOffset(Axis));
    return {{Bounds[0], Bounds[1]}};
  }

  Vector3 Origin;
  Vector3 Inverse;
  uint32_t NearX, NearY, NearZ;
  uint32_t FarX, FarY, FarZ;
};

/// What intersectTriangle() returns for a miss: beyond every distance.
inline constexpr float kMissDistance = 3.0e38f;

/// The distance at which \p R meets \p Triangle, or kMissDistance. Without
/// branches, so that nothing delays a load until it is known to be needed.
inline float intersectTriangle(const TriangleRecord &Triangle, const Ray &R) {
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

  const char *const Nodes = Scene.Nodes;
  const TriangleRecord *const Triangles = Scene.Triangles;
  const RayBoxTester Boxes(R);
  Hit Found{MaxDistance, kNoTriangle};
  BvhReference Reference = Root;
  for (;;) {
    if (!isLeaf(Reference)) {
      const char *Node = Nodes + Reference;
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
      const TriangleRecord *Record = Triangles + Triangle;
      uint32_t Left = leafCount(Reference);
      // Two at a time share one wait for memory.
      for (; Left >= 2; Left -= 2, Triangle += 2, Record += 2) {
        const float DistanceA = intersectTriangle(Record[0], R);
        const float DistanceB = intersectTriangle(Record[1], R);
        Found.take(DistanceA, Triangle);
        Found.take(DistanceB, Triangle + 1);
      }
      if (Left != 0)
        Found.take(intersectTriangle(*Record, R), Triangle);
      if (Query == HitQuery::Any && Found.Triangle != kNoTriangle)
        return Found;
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
