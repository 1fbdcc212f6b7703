//===- QuantizedBoxTester.h - A ray and a quantized node's boxes *- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_QUANTIZEDBOXTESTER_H
#define TP_KERNELS_BVH_QUANTIZEDBOXTESTER_H

#include "kernels/bvh/QuantizedPlanes.h"
#include "kernels/bvh/RayBoxTester.h"

#include <stddef.h>

namespace tp {

/// RayBoxTester for nodes that are QuantizedBvhNodes. A box is entered no later
/// and left no earlier than the full one: QuantizedBvh.cpp sees to that.
class QuantizedBoxTester {
public:
  explicit QuantizedBoxTester(const Ray &R)
      : X(R.Origin.X, R.Direction.X, 0), Y(R.Origin.Y, R.Direction.Y, 1),
        Z(R.Origin.Z, R.Direction.Z, 2) {}

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

private:
  template <NodeStore From>
  TP_KERNEL_INLINE BoxDistances testFrom(const char *Node,
                                         float MaxDistance) const {
    BoxDistances Result;
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      Result.Enter[Child] = 0.0f;
      Result.Leave[Child] = MaxDistance;
    }
    PlaneNumbers Decoder;
    const uint32_t Scales =
        reinterpret_cast<const QuantizedBvhNode *>(Node)->Scales;
    const Slabs SlabsX = X.load(Node, 0);
    X.clip(SlabsX, quantizedScale(Scales, 0), Decoder, Result);
    if (From == NodeStore::Local)
      loadNoEarlier(Node, Result);
    const Slabs SlabsY = Y.load(Node, 1);
    Y.clip(SlabsY, quantizedScale(Scales, 1), Decoder, Result);
    if (From == NodeStore::Local)
      loadNoEarlier(Node, Result);
    const Slabs SlabsZ = Z.load(Node, 2);
    Z.clip(SlabsZ, quantizedScale(Scales, 2), Decoder, Result);
    return Result;
  }

  /// The words of one axis of a node.
  struct Slabs {
    float Origin;
    uint32_t Near;
    uint32_t Far;
  };

  /// What the tests of one axis share.
  struct Axis {
    float Origin;
    float Inverse;
    /// Of the words of planes, in bytes from a node's start.
    uint32_t Near;
    uint32_t Far;

    Axis(float RayOrigin, float RayDirection, uint32_t Index)
        : Origin(RayOrigin), Inverse(RayBoxTester::inverse(RayDirection)) {
      const uint32_t Lower =
          __builtin_offsetof(QuantizedBvhNode, Planes) + size_t(8) * Index;
      Near = Lower + (RayDirection < 0.0f ? 4 : 0);
      Far = Lower + (RayDirection < 0.0f ? 0 : 4);
    }

    TP_KERNEL_INLINE Slabs load(const char *Node, uint32_t Index) const {
      return {reinterpret_cast<const QuantizedBvhNode *>(Node)->Origin[Index],
              *reinterpret_cast<const uint32_t *>(Node + Near),
              *reinterpret_cast<const uint32_t *>(Node + Far)};
    }

    /// Cuts the boxes' distances to what lies between the planes.
    TP_KERNEL_INLINE void clip(const Slabs &Node, float Scale,
                               PlaneNumbers &Decoder, BoxDistances &D) const {
      const float Start = (Node.Origin - Origin) * Inverse;
      const float Step = Scale * Inverse;
      const PlaneNumbers::Numbers Near = Decoder.decode(Node.Near);
      for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
        D.Enter[Child] = maximum(Near.Of[Child] * Step + Start, D.Enter[Child]);
      const PlaneNumbers::Numbers Far = Decoder.decode(Node.Far);
      for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
        D.Leave[Child] = minimum(Far.Of[Child] * Step + Start, D.Leave[Child]);
    }
  };

  Axis X;
  Axis Y;
  Axis Z;
};

} // namespace tp

#endif // TP_KERNELS_BVH_QUANTIZEDBOXTESTER_H
