//===- BuiltBvh.h - The tree that a kernel built ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What the native runner and the simulator do alike after a run with
// BvhOrigin::Kernel: read the tree back, verify it, write it to a file.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_BUILTBVH_H
#define TP_KERNELS_COMMON_BUILTBVH_H

#include "kernels/bvh/BvhVerifier.h"
#include "kernels/common/LaunchSetup.h"

#include <string>
#include <vector>

namespace tp {

/// A binary tree with the wide one that was made from it.
struct BuiltBvh {
  std::vector<BoundingBox> Boxes;
  std::vector<uint32_t> Order;
  std::vector<BvhNode> Nodes;
  BvhReference Root = kNoBvh;
  std::vector<WideBvhNode> WideNodes;
  BvhReference WideRoot = kNoBvh;
};

/// The tree that a finished kernel left in the scene's BvhWorkspace. Fails if
/// the kernel built none, or if what it left cannot be a tree of this scene.
ErrorOr<BuiltBvh> readBuiltBvh(const LaunchBlock &Launch,
                               const LaunchMemory &Memory);

/// What is known of a tree that keeps every rule of BvhVerifier.h.
struct BvhSummary {
  BvhFindings Binary;
  BvhFindings Wide;
};

/// Fails, naming the first violation and the number of lost and repeated
/// triangles, if one of the two trees breaks a rule.
ErrorOr<BvhSummary> verifyBuiltBvh(const BuiltBvh &Tree);

/// One line: triangles, nodes, leaves, depth and cost.
std::string describeBuiltBvh(const BuiltBvh &Tree, const BvhSummary &Summary);

/// Writes order, nodes and roots, so that equal files mean equal trees.
Status writeBuiltBvh(const std::string &Path, const BuiltBvh &Tree);

/// All of the above: reads, writes to \p Path unless it is empty, verifies, and
/// returns the description.
ErrorOr<std::string> checkBuiltBvh(const LaunchBlock &Launch,
                                   const LaunchMemory &Memory,
                                   const std::string &Path);

} // namespace tp

#endif // TP_KERNELS_COMMON_BUILTBVH_H
