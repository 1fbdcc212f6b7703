//===- BvhTraversal.h - Rays through a BVH ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Written for an in-order processor whose loads take long but do not block: all
// words of a node or triangle are asked for before the first is used.
// Everything is inlined into the kernel: a call would move its operands through
// memory.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_BVHTRAVERSAL_H
#define TP_KERNELS_BVH_BVHTRAVERSAL_H

#include "kernels/common/FloatMath.h"
#include "kernels/common/Inline.h"
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

  /// For each child of a node, the distances at which the ray enters and leaves
  /// its box, within (0, MaxDistance); it misses where Enter > Leave.
  struct Distances {
    float Enter[kWideBvhWidth];
    float Leave[kWideBvhWidth];

    bool isHit(unsigned Child) const { return Enter[Child] <= Leave[Child]; }
  };

  TP_KERNEL_INLINE Distances test(const char *Node, float MaxDistance) const {
    const Side NearXs = load(Node + NearX, 0);
    const Side FarXs = load(Node + FarX, 0);
    const Side NearYs = load(Node + NearY, 1);
    const Side FarYs = load(Node + FarY, 1);
    const Side NearZs = load(Node + NearZ, 2);
    const Side FarZs = load(Node + FarZ, 2);
    Distances Result;
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      Result.Enter[Child] =
          maximum((NearXs.Plane[Child] - Origin.X) * Inverse.X, 0.0f);
      Result.Leave[Child] =
          minimum((FarXs.Plane[Child] - Origin.X) * Inverse.X, MaxDistance);
    }
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      Result.Enter[Child] = maximum(
          (NearYs.Plane[Child] - Origin.Y) * Inverse.Y, Result.Enter[Child]);
      Result.Leave[Child] = minimum((FarYs.Plane[Child] - Origin.Y) * Inverse.Y,
                                    Result.Leave[Child]);
    }
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      Result.Enter[Child] = maximum(
          (NearZs.Plane[Child] - Origin.Z) * Inverse.Z, Result.Enter[Child]);
      Result.Leave[Child] = minimum((FarZs.Plane[Child] - Origin.Z) * Inverse.Z,
                                    Result.Leave[Child]);
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
  /// One side of all children's boxes.
  struct Side {
    float Plane[kWideBvhWidth];
  };
  TP_KERNEL_INLINE static Side load(const char *Side, uint32_t Axis) {
    const float *Planes =
        reinterpret_cast<const float *>(Side + boundsOffset(Axis));
    return {{Planes[0], Planes[1], Planes[2], Planes[3]}};
  }

  Vector3 Origin;
  Vector3 Inverse;
  uint32_t NearX, NearY, NearZ;
  uint32_t FarX, FarY, FarZ;
};

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

/// A node's references.
struct WideChildren {
  TP_KERNEL_INLINE explicit WideChildren(const char *Node) {
    const auto *Wide = reinterpret_cast<const WideBvhNode *>(Node);
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
      References[Child] = Wide->Child[Child];
    // Some are used on some paths only: keeps the compiler from delaying their
    // loads until then.
    for (BvhReference &Reference : References)
      asm volatile("" : "+r"(Reference));
  }
  BvhReference References[kWideBvhWidth];
};

/// Nodes and leaves that wait to be visited.
class TraversalStack {
public:
  struct Entry {
    BvhReference Reference;
    float Enter;
  };
  /// Each node on the way leaves all but one of its children here.
  static constexpr uint32_t Capacity = kMaxBvhDepth * (kWideBvhWidth - 1) + 1;

  /// Room for Capacity entries. It is not a member, so that the compiler can
  /// keep the members in registers.
  explicit TraversalStack(Entry *Entries) : Bottom(Entries), Top(Entries) {}

  TP_KERNEL_INLINE void push(BvhReference Reference, float Enter) {
    *Top++ = {Reference, Enter};
  }
  /// Pushes without a branch that the load of \p Reference could sink behind.
  TP_KERNEL_INLINE void pushIf(bool Condition, BvhReference Reference) {
    Top->Reference = Reference;
    Top += Condition;
  }
  /// The youngest entry that begins before \p MaxDistance; false if there is
  /// none.
  TP_KERNEL_INLINE bool popNearer(float MaxDistance, BvhReference &Reference) {
    do {
      if (Top == Bottom)
        return false;
      --Top;
    } while (Top->Enter > MaxDistance);
    Reference = Top->Reference;
    return true;
  }
  /// The youngest entry; false if there is none.
  TP_KERNEL_INLINE bool pop(BvhReference &Reference) {
    if (Top == Bottom)
      return false;
    Reference = (--Top)->Reference;
    return true;
  }

private:
  Entry *const Bottom;
  Entry *Top;
};

/// Pushes the children that the ray hits but for the nearest, which becomes
/// \p Reference; false if it hits none.
TP_KERNEL_INLINE bool descendToNearest(const RayBoxTester::Distances &D,
                                       const BvhReference *Children,
                                       TraversalStack &Stack,
                                       BvhReference &Reference) {
  // Set even without a hit, lest its load waits for the decision.
  BvhReference Nearest = Children[0];
  float NearestEnter = D.isHit(0) ? D.Enter[0] : kMissDistance;
  for (unsigned Child = 1; Child != kWideBvhWidth; ++Child) {
    if (!D.isHit(Child))
      continue;
    if (D.Enter[Child] < NearestEnter) {
      if (NearestEnter != kMissDistance)
        Stack.push(Nearest, NearestEnter);
      Nearest = Children[Child];
      NearestEnter = D.Enter[Child];
    } else {
      Stack.push(Children[Child], D.Enter[Child]);
    }
  }
  Reference = Nearest;
  return NearestEnter != kMissDistance;
}

/// Replaces \p Found by the nearest hit in a leaf that is nearer.
TP_KERNEL_INLINE void intersectLeaf(const TriangleRecord *Triangles,
                                    BvhReference Leaf, const Ray &R,
                                    Hit &Found) {
  uint32_t Triangle = leafFirst(Leaf);
  const TriangleRecord *Record = Triangles + Triangle;
  uint32_t Left = leafCount(Leaf);
  // Two at a time share one wait for memory.
  for (; Left >= 2; Left -= 2, Triangle += 2, Record += 2) {
    const float DistanceA = intersectTriangle(Record[0], R);
    const float DistanceB = intersectTriangle(Record[1], R);
    Found.take(DistanceA, Triangle);
    Found.take(DistanceB, Triangle + 1);
  }
  if (Left != 0)
    Found.take(intersectTriangle(*Record, R), Triangle);
}

/// The first triangle that \p R meets before \p MaxDistance.
TP_KERNEL_INLINE Hit findClosestHit(const SceneView &Scene, BvhReference Root,
                                    Ray R, float MaxDistance) {
  const char *const Nodes = Scene.Nodes;
  const TriangleRecord *const Triangles = Scene.Triangles;
  const RayBoxTester Boxes(R);
  TraversalStack::Entry Entries[TraversalStack::Capacity];
  TraversalStack Stack(Entries);
  Hit Found{MaxDistance, kNoTriangle};
  BvhReference Reference = Root;
  for (;;) {
    if (!isLeaf(Reference)) {
      const char *Node = Nodes + Reference;
      const WideChildren Children(Node);
      if (descendToNearest(Boxes.test(Node, Found.Distance),
                           Children.References, Stack, Reference))
        continue;
    } else {
      intersectLeaf(Triangles, Reference, R, Found);
    }
    // Not `Found` itself, which would then live in the caller's memory.
    if (!Stack.popNearer(Found.Distance, Reference))
      return {Found.Distance, Found.Triangle};
  }
}

/// Whether \p R meets any triangle before \p MaxDistance. Takes the children of
/// a node in the order of memory: sorting would cost more than it saves.
TP_KERNEL_INLINE bool isBlocked(const SceneView &Scene, BvhReference Root,
                                Ray R, float MaxDistance) {
  const char *const Nodes = Scene.Nodes;
  const TriangleRecord *const Triangles = Scene.Triangles;
  const RayBoxTester Boxes(R);
  TraversalStack::Entry Entries[TraversalStack::Capacity];
  TraversalStack Stack(Entries);
  BvhReference Reference = Root;
  do {
    if (!isLeaf(Reference)) {
      const char *Node = Nodes + Reference;
      const WideChildren Children(Node);
      const RayBoxTester::Distances D = Boxes.test(Node, MaxDistance);
      for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
        Stack.pushIf(D.isHit(Child), Children.References[Child]);
    } else {
      Hit Found{MaxDistance, kNoTriangle};
      intersectLeaf(Triangles, Reference, R, Found);
      if (Found.Triangle != kNoTriangle)
        return true;
    }
  } while (Stack.pop(Reference));
  return false;
}

} // namespace tp

#endif // TP_KERNELS_BVH_BVHTRAVERSAL_H
