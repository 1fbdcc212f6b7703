//===- BvhTraversal.h - Rays through a BVH ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Written for an in-order processor whose loads take long but do not block: all
// words of a node or triangle are asked for before the first is used.
// Everything is inlined into the kernel: a call would move its operands through
// memory. The loops can be entered at any subtree, so that a caller with nodes
// of its own leaves to them what it has not got.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_BVHTRAVERSAL_H
#define TP_KERNELS_BVH_BVHTRAVERSAL_H

#include "kernels/bvh/RayBoxTester.h"
#include "kernels/bvh/RayTriangleTester.h"
#include "kernels/bvh/TraversalStack.h"
#include "kernels/common/Inline.h"
#include "kernels/common/RayEvents.h"
#include "kernels/common/SceneLayout.h"

namespace tp {

/// A node's references, whose words begin at \p Words.
struct WideChildren {
  TP_KERNEL_INLINE explicit WideChildren(const char *Words) {
    const auto *Child = reinterpret_cast<const BvhReference *>(Words);
    for (unsigned Slot = 0; Slot != kWideBvhWidth; ++Slot)
      References[Slot] = Child[Slot];
    // Some are used on some paths only: keeps the compiler from delaying their
    // loads until then.
    for (BvhReference &Reference : References)
      asm volatile("" : "+r"(Reference));
  }
  BvhReference References[kWideBvhWidth];
};

/// Replaces \p Found by the nearest hit that is nearer among the \p Count
/// triangles at \p Records; \p First is the number of the first one in the
/// scene.
TP_KERNEL_INLINE void testTriangles(const TriangleRecord *Records,
                                    uint32_t First, uint32_t Count,
                                    const RayTriangleTester &Tester,
                                    Hit &Found) {
  constexpr uint32_t Stride = sizeof(TriangleRecord);
  const char *Corners = reinterpret_cast<const char *>(Records);
  // Two at a time share one wait for memory.
  for (; Count >= 2;
       Count -= 2, First += 2, Corners += 2 * sizeof(TriangleRecord))
    Tester.test<2>(Corners, Stride, First, Found);
  if (Count != 0)
    Tester.test<1>(Corners, Stride, First, Found);
}

/// The nodes of the scene as SceneLayout.h has them, as traversal sees them. A
/// format of nodes has these members.
struct FullNodes {
  /// What a node takes in the format's array, in which references to nodes are
  /// byte offsets.
  static constexpr uint32_t NodeBytes = sizeof(WideBvhNode);
  /// Of the references to its children, in bytes from a node's start.
  static constexpr uint32_t ChildOffset =
      __builtin_offsetof(WideBvhNode, Child);
  using BoxTester = RayBoxTester;

  static const char *nodes(const SceneView &Scene) { return Scene.Nodes; }
  static BvhReference root(const SceneView &Scene) {
    return Scene.Header->Root;
  }
};

/// Where a traversal reads nodes and triangles.
struct BvhMemory {
  const char *Nodes;
  const TriangleRecord *Triangles;
};

/// Replaces \p Found by the nearest hit of the ray in the subtree \p Reference
/// that is nearer. \p Entries has room for what the subtree leaves to be
/// visited.
template <class Format>
TP_KERNEL_INLINE void
findClosestHitBelow(const BvhMemory &Memory, BvhReference Reference,
                    const RayTriangleTester &Triangles,
                    const typename Format::BoxTester &Boxes,
                    TraversalStack::Entry *Entries, Hit &Found) {
  TraversalStack Stack(Entries);
  // Not `Found` itself, which may live in the caller's memory.
  Hit Nearest = Found;
  for (;;) {
    if (!isLeaf(Reference)) {
      rayEvent(RayEvent::NodeFromMemory, Reference);
      const char *Node = Memory.Nodes + Reference;
      const WideChildren Children(Node + Format::ChildOffset);
      if (descendToNearest(Boxes.test(Node, Nearest.Distance),
                           Children.References, Stack, Reference))
        continue;
    } else {
      rayEvent(RayEvent::TrianglesFromMemory, Reference);
      const uint32_t First = leafFirst(Reference);
      testTriangles(Memory.Triangles + First, First, leafCount(Reference),
                    Triangles, Nearest);
    }
    if (!Stack.popNearer(Nearest.Distance, Reference))
      break;
  }
  Found = Nearest;
}

/// Whether the ray meets a triangle of the subtree \p Reference before
/// \p MaxDistance. \p Entries as in findClosestHitBelow(). Takes the children
/// of a node in the order of memory: sorting would cost more than it saves.
template <class Format>
TP_KERNEL_INLINE bool
isBlockedBelow(const BvhMemory &Memory, BvhReference Reference,
               const RayTriangleTester &Triangles,
               const typename Format::BoxTester &Boxes,
               TraversalStack::Entry *Entries, float MaxDistance) {
  TraversalStack Stack(Entries);
  do {
    if (!isLeaf(Reference)) {
      rayEvent(RayEvent::NodeFromMemory, Reference);
      const char *Node = Memory.Nodes + Reference;
      const WideChildren Children(Node + Format::ChildOffset);
      const BoxDistances D = Boxes.test(Node, MaxDistance);
      for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
        Stack.pushIf(D.isHit(Child), Children.References[Child]);
    } else {
      rayEvent(RayEvent::TrianglesFromMemory, Reference);
      const uint32_t First = leafFirst(Reference);
      Hit Found{MaxDistance, kNoTriangle};
      testTriangles(Memory.Triangles + First, First, leafCount(Reference),
                    Triangles, Found);
      if (Found.Triangle != kNoTriangle)
        return true;
    }
  } while (Stack.pop(Reference));
  return false;
}

} // namespace tp

#endif // TP_KERNELS_BVH_BVHTRAVERSAL_H
