//===- BvhVerifier.h - Is this tree a tree? ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiles for the host and for the TP: the caller gives all memory. Trusts
// nothing that it reads: any bytes get a verdict.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_BVHVERIFIER_H
#define TP_KERNELS_BVH_BVHVERIFIER_H

#include "kernels/bvh/BvhBuilder.h"
#include "kernels/bvh/WideBvh.h"
#include "kernels/common/BitSet.h"

#include <stddef.h>
#include <stdint.h>

namespace tp {

/// What every tree must keep. describeViolation() says each as a sentence.
enum class BvhRule : uint8_t {
  /// Not a rule: nothing is broken.
  None,
  /// A reference to a node names one that was made.
  ReferenceInRange,
  /// No node is reached twice.
  NodeOnce,
  /// Every node is reached.
  NodeReached,
  /// No path has more inner nodes than allowed.
  Depth,
  /// A node of the wide tree has at least two children.
  TwoChildren,
  /// The box of a child lies inside its parent's.
  ChildInParent,
  /// A leaf holds at least one primitive.
  LeafNotEmpty,
  /// A leaf holds no more primitives than allowed.
  LeafSize,
  /// A leaf's range lies inside the order.
  LeafInRange,
  /// The order holds numbers of primitives only.
  PrimitiveNumber,
  /// No primitive is in two leaves, or twice in one.
  PrimitiveOnce,
  /// Every primitive is in a leaf.
  PrimitiveInLeaf,
  /// A leaf's box contains its primitives.
  PrimitiveInBox,
};

/// Which rule is broken, and where.
struct BvhViolation {
  static constexpr uint32_t AtRoot = 0xFFFFFFFFu;

  BvhRule Rule = BvhRule::None;
  /// Index of the node whose child is at fault; AtRoot if it is the root.
  uint32_t Node = AtRoot;
  uint32_t Child = 0;
  /// The primitive, count, depth or reference that breaks the rule.
  uint32_t Value = 0;
};

/// What a verifier allows.
struct BvhLimits {
  uint32_t LeafPrimitives = kMaxLeafTriangles;
  /// At most kMaxBvhDepth.
  uint32_t Depth = kMaxBvhDepth;
};

/// What a verifier found.
struct BvhFindings {
  /// In the order of a depth-first walk.
  BvhViolation First;
  /// Primitives in no leaf, and those met again in another place.
  uint32_t LostPrimitives = 0;
  uint32_t RepeatedPrimitives = 0;
  uint32_t LeafCount = 0;
  /// Inner nodes on the longest path.
  uint32_t Depth = 0;
  /// The expected cost of a ray that hits the root's box, by the surface area
  /// heuristic. Means nothing if a rule is broken.
  double Cost = 0;

  bool isClean() const { return First.Rule == BvhRule::None; }
};

/// Words of scratch memory that a verifier of so many primitives and nodes
/// needs.
constexpr uint32_t bvhVerifierWords(uint32_t PrimitiveCount,
                                    uint32_t NodeCount) {
  return BitSet::wordCount(PrimitiveCount) + BitSet::wordCount(NodeCount);
}

/// Verifies what buildBvh() left in \p Storage. \p Scratch has
/// bvhVerifierWords(PrimitiveCount, NodeCount) words.
BvhFindings verifyBvh(const BvhStorage &Storage, BvhReference Root,
                      uint32_t *Scratch, const BvhCosts &Costs = BvhCosts(),
                      const BvhLimits &Limits = BvhLimits());

/// Verifies what widenBvh() left in \p Wide of the tree in \p Storage. \p
/// Scratch has bvhVerifierWords(PrimitiveCount, WideNodeCount) words.
BvhFindings verifyWideBvh(const BvhStorage &Storage, const WideBvhStorage &Wide,
                          BvhReference Root, uint32_t *Scratch,
                          const BvhCosts &Costs = BvhCosts(),
                          const BvhLimits &Limits = BvhLimits());

/// Writes the violation as a sentence without a full stop into \p Buffer, which
/// holds \p Bytes, and returns the length that it has in full.
int describeViolation(const BvhViolation &Violation, char *Buffer,
                      size_t Bytes);

} // namespace tp

#endif // TP_KERNELS_BVH_BVHVERIFIER_H
