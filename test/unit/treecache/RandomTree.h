//===- RandomTree.h - Scenes with trees of every shape ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_TREECACHE_RANDOMTREE_H
#define TP_TEST_UNIT_TREECACHE_RANDOMTREE_H

#include "kernels/bvh/Ray.h"
#include "kernels/common/SceneLayout.h"

#include <cstdint>
#include <memory>
#include <new>
#include <random>
#include <vector>

namespace tp {

/// How a tree is grown from the root down.
enum class TreeShape : uint8_t {
  /// As flattenScene() makes it.
  Built,
  /// Two to four subtrees of any size, leaves of any size.
  Mixed,
  /// Leaves as large as they can be.
  LongLeaves,
  /// Down to the largest depth: each node has leaves and one node.
  Chain,
  /// Nothing but a leaf.
  Leaf,
  /// A leaf without triangles.
  Empty,
};

/// A block of random triangles in a cube of side 20 about the origin, and a
/// tree over them whose boxes are random, too, unless the tree is Built: they
/// only decide where rays go.
class RandomTree {
public:
  /// Any two with equal arguments are equal. At least one triangle.
  RandomTree(TreeShape Shape, uint32_t TriangleCount, uint32_t Seed);

  SceneView view() const { return SceneView(Block.get()); }

private:
  struct Free {
    void operator()(uint8_t *Memory) const {
      ::operator delete(Memory, std::align_val_t(kSceneAlignment));
    }
  };
  std::unique_ptr<uint8_t, Free> Block;
};

/// Rays that are like the one before, or not at all.
class RandomRays {
public:
  explicit RandomRays(uint32_t Seed) : Generator(Seed) {}

  Ray next();
  /// True once in \p Times.
  bool once(uint32_t Times) { return Generator() % Times == 0; }
  /// Uniform between the two.
  float number(float Lower, float Upper) {
    return std::uniform_real_distribution<float>(Lower, Upper)(Generator);
  }

private:
  Vector3 vector(float Side);

  std::mt19937 Generator;
  Ray Last{};
};

} // namespace tp

#endif // TP_TEST_UNIT_TREECACHE_RANDOMTREE_H
