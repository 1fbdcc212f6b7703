//===- BvhBuilder.h - Binned surface-area-heuristic builder -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiles for the host and for the TP: the caller gives all memory.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_BVHBUILDER_H
#define TP_KERNELS_BVH_BVHBUILDER_H

#include "kernels/bvh/BoundingBox.h"
#include "kernels/common/SceneLayout.h"

#include <stdint.h>

namespace tp {

/// What a traversal pays, in cycles. Only the ratio matters. Both defaults
/// estimate the report's chip: some 100 cycles of waiting for memory and 60
/// instructions. Counting visits on the Cornell box, equal costs do best.
struct BvhCosts {
  /// To visit an inner node.
  float Node = 160;
  /// To intersect a triangle.
  float Triangle = 160;
};

/// An inner node of the binary tree. References to it hold its index.
struct BvhNode {
  BoundingBox Boxes[2];
  BvhReference Child[2];
};

/// Memory for buildBvh() and its result.
struct BvhStorage {
  /// One box per primitive; finite, lower <= upper.
  const BoundingBox *Boxes;
  uint32_t PrimitiveCount;
  /// PrimitiveCount entries; receives a permutation of the primitive numbers in
  /// which each leaf is a range.
  uint32_t *Order;
  /// Room for PrimitiveCount - 1 nodes (at least 0).
  BvhNode *Nodes;
  /// Receives the number of nodes made.
  uint32_t NodeCount;
};

/// Builds a bounding volume hierarchy over 1 to kMaxBvhTriangles primitives and
/// returns its root. No leaf is empty or holds more than kMaxLeafTriangles, no
/// path is longer than kMaxBvhDepth, whatever the boxes (also many equal ones).
/// The result is the same on every machine with IEEE floats; with other float
/// rules (-ffast-math) the tree may differ, but is still complete.
BvhReference buildBvh(BvhStorage &Storage, const BvhCosts &Costs = BvhCosts());

} // namespace tp

#endif // TP_KERNELS_BVH_BVHBUILDER_H
