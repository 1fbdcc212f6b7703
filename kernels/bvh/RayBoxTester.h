//===- RayBoxTester.h - A ray against the boxes of a node -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_RAYBOXTESTER_H
#define TP_KERNELS_BVH_RAYBOXTESTER_H

#include "kernels/bvh/Ray.h"
#include "kernels/common/FloatMath.h"
#include "kernels/common/Inline.h"
#include "kernels/common/SceneLayout.h"

namespace tp {

/// For each child of a node, the distances at which the ray enters and leaves
/// its box, within (0, MaxDistance); it misses where Enter > Leave.
struct BoxDistances {
  float Enter[kWideBvhWidth];
  float Leave[kWideBvhWidth];

  bool isHit(unsigned Child) const { return Enter[Child] <= Leave[Child]; }
};

/// Where a box tester finds a node.
enum class NodeStore { Memory, Local };

/// The compiler takes every load for a slow one and asks for all words early,
/// more than there are registers. Here it shall not do so before it has
/// \p Result.
TP_KERNEL_INLINE void loadNoEarlier([[maybe_unused]] const char *&Node,
                                    [[maybe_unused]] BoxDistances &D) {
#ifdef __tp__
  asm(""
      : "+r"(Node)
      : "f"(D.Enter[0]), "f"(D.Enter[1]), "f"(D.Enter[2]), "f"(D.Enter[3]),
        "f"(D.Leave[0]), "f"(D.Leave[1]), "f"(D.Leave[2]), "f"(D.Leave[3]));
#endif
}

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

  /// Tests the boxes of the node whose words begin at \p Node.
  TP_KERNEL_INLINE BoxDistances test(const char *Node,
                                     float MaxDistance) const {
    return testFrom<NodeStore::Memory>(Node, MaxDistance);
  }

  /// The same for a node in the local store.
  TP_KERNEL_INLINE BoxDistances testInLocalStore(const char *Node,
                                                 float MaxDistance) const {
    return testFrom<NodeStore::Local>(Node, MaxDistance);
  }

  /// The inverse of a direction's component, finite for every direction, so
  /// that no 0 * infinity comes up.
  static float inverse(float Component) {
    constexpr float Tiny = 1e-18f;
    if (Component < 0.0f)
      return 1.0f / minimum(Component, -Tiny);
    return 1.0f / maximum(Component, Tiny);
  }

private:
  template <NodeStore From>
  TP_KERNEL_INLINE BoxDistances testFrom(const char *Node,
                                         float MaxDistance) const {
    BoxDistances Result;
    const Side NearXs = load(Node + NearX, 0);
    const Side FarXs = load(Node + FarX, 0);
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      Result.Enter[Child] =
          maximum((NearXs.Plane[Child] - Origin.X) * Inverse.X, 0.0f);
      Result.Leave[Child] =
          minimum((FarXs.Plane[Child] - Origin.X) * Inverse.X, MaxDistance);
    }
    if (From == NodeStore::Local)
      loadNoEarlier(Node, Result);
    const Side NearYs = load(Node + NearY, 1);
    const Side FarYs = load(Node + FarY, 1);
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      Result.Enter[Child] = maximum(
          (NearYs.Plane[Child] - Origin.Y) * Inverse.Y, Result.Enter[Child]);
      Result.Leave[Child] = minimum((FarYs.Plane[Child] - Origin.Y) * Inverse.Y,
                                    Result.Leave[Child]);
    }
    if (From == NodeStore::Local)
      loadNoEarlier(Node, Result);
    const Side NearZs = load(Node + NearZ, 2);
    const Side FarZs = load(Node + FarZ, 2);
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      Result.Enter[Child] = maximum(
          (NearZs.Plane[Child] - Origin.Z) * Inverse.Z, Result.Enter[Child]);
      Result.Leave[Child] = minimum((FarZs.Plane[Child] - Origin.Z) * Inverse.Z,
                                    Result.Leave[Child]);
    }
    return Result;
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

} // namespace tp

#endif // TP_KERNELS_BVH_RAYBOXTESTER_H
