//===- MemoryRayTracer.h - Rays through a BVH in memory ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PATHTRACER_MEMORYRAYTRACER_H
#define TP_KERNELS_PATHTRACER_MEMORYRAYTRACER_H

#include "kernels/bvh/BvhTraversal.h"
#include "kernels/common/EarlyLoad.h"
#include "kernels/pathtracer/PathTracer.h"

namespace tp {

/// Traces every ray from global memory. \p Format is a format of nodes, like
/// FullNodes.
template <class Format = FullNodes> class MemoryRayTracer {
public:
  /// \p Entries has room for traversalEntries(BvhDepth of the scene).
  MemoryRayTracer(const SceneView &Scene, TraversalStack::Entry *Entries)
      : Memory{Format::nodes(Scene), Scene.Triangles},
        Root(Format::root(Scene)), Entries(Entries) {}

  /// The first triangle that \p R meets before \p MaxDistance.
  TP_KERNEL_INLINE Hit findClosestHit(const Ray &R, float MaxDistance) {
    const RayTriangleTester Triangles(R);
    const typename Format::BoxTester Boxes(R);
    Hit Found{MaxDistance, kNoTriangle};
    findClosestHitBelow<Format>(Memory, Root, Triangles, Boxes, Entries, Found);
    return Found;
  }

  /// Whether \p R meets any triangle before \p MaxDistance.
  TP_KERNEL_INLINE bool isBlocked(const Ray &R, float MaxDistance) {
    const RayTriangleTester Triangles(R);
    const typename Format::BoxTester Boxes(R);
    return isBlockedBelow<Format>(Memory, Root, Triangles, Boxes, Entries,
                                  MaxDistance);
  }

private:
  const BvhMemory Memory;
  const BvhReference Root;
  TraversalStack::Entry *const Entries;
};

/// The baseline: renderPixels() from global memory.
template <class Format = FullNodes>
void renderPixelsFromMemory(const LaunchBlock &Launch) {
  TraversalStack::Entry Entries[TraversalStack::Capacity];
  const auto *Block = devicePointer<const SceneHeader>(Launch.Scene);
  const SceneHeader Header = loadTogether(*Block);
  const SceneView Scene(Block, Header);
  renderPixels(Launch, Scene, MemoryRayTracer<Format>(Scene, Entries));
}

} // namespace tp

#endif // TP_KERNELS_PATHTRACER_MEMORYRAYTRACER_H
