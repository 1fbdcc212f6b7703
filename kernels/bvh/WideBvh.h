//===- WideBvh.h - From the binary tree to the traversed one ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiles for the host and for the TP: the caller gives all memory.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_WIDEBVH_H
#define TP_KERNELS_BVH_WIDEBVH_H

#include "kernels/bvh/BvhBuilder.h"

namespace tp {

/// Memory for widenBvh() and its result.
struct WideBvhStorage {
  /// What buildBvh() made.
  const BvhNode *Nodes;
  /// Room for as many nodes as the binary tree has.
  WideBvhNode *WideNodes;
  /// Receives the number of nodes made.
  uint32_t WideNodeCount;
  /// Receives the number of nodes on the longest way from the root to a leaf.
  uint32_t Depth = 0;
};

/// Takes up to four descendants of each node together, so that the sum of the
/// surfaces of the wide nodes, and with it the number that rays visit, is as
/// small as it can be; returns the new root. A root that is a leaf stays one.
/// Leaves stay what they are; no path gets longer. The children of a node come
/// in the order of their surfaces, the largest first. After H. Ylitie, T.
/// Karras and S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through
/// Compressed Wide BVHs", HPG 2017.
BvhReference widenBvh(WideBvhStorage &Storage, BvhReference Root);

} // namespace tp

#endif // TP_KERNELS_BVH_WIDEBVH_H
