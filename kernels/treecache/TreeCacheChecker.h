//===- TreeCacheChecker.h - Verifies a cache as it runs ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_TREECACHECHECKER_H
#define TP_KERNELS_TREECACHE_TREECACHECHECKER_H

#include "kernels/treecache/CacheLink.h"
#include "kernels/treecache/SlotFormat.h"
#include "kernels/treecache/TreeCacheVerifier.h"

#include <stdint.h>

namespace tp {

/// The layout of the slots of \p Cache, a TreeCache.
template <class Cache> constexpr TreeCacheLayout treeCacheLayout() {
  using Format = typename Cache::SlotFormat;
  static_assert(Format::ChildOffset + kWideBvhWidth * sizeof(uint32_t) ==
                    Format::NodeBytes,
                "the verifier knows no words behind a node's child words");
  TreeCacheLayout Layout{};
  Layout.SlotBytes = Cache::SlotBytes;
  Layout.ParentOffset = Format::ParentOffset;
  Layout.SourceOffset = Format::SourceOffset;
  Layout.MemoryNodeBytes = Format::Nodes::NodeBytes;
  Layout.ChildOffset = Format::ChildOffset;
  Layout.TriangleBytes = kTriangleTestBytes;
  Layout.LeafTriangles = Format::TrianglesPerSlot;
  Layout.RestOffset = Format::RestOffset;
  return Layout;
}

/// What a TreeCache is made of.
template <class Cache> TreeCacheState treeCacheState(const Cache &Slots) {
  return {Slots.base(),
          Slots.end(),
          Slots.end() / Cache::SlotBytes,
          Slots.firstUnused() / Cache::SlotBytes,
          Slots.firstFree(),
          Slots.word(kRootWord)};
}

/// What a cache of nodes of \p NodeFormat (as FullNodes) holds a part of.
template <class NodeFormat>
TreeCacheSource treeCacheSource(const SceneView &Scene) {
  return {NodeFormat::nodes(Scene), Scene.Header->NodeCount, Scene.Triangles,
          Scene.Header->TriangleCount, NodeFormat::root(Scene)};
}

/// Verifies the cache of one thread after each deletion, and ends the run with
/// a message on stderr and status 1 if a rule is broken.
class TreeCacheChecker {
public:
  /// After a deletion that left \p Path to go on. The verifier's scratch memory
  /// comes from the heap: local store would be missing in the cache.
  void verifyDeletion(const TreeCacheLayout &Layout,
                      const TreeCacheState &State,
                      const TreeCacheSource &Source, const TreeCachePath &Path);

private:
  uint32_t DeletionCount = 0;
};

/// Writes to stderr how many deletions the checkers of all threads have
/// verified: once, when the threads have met behind the last one.
void reportVerifiedDeletions();

} // namespace tp

#endif // TP_KERNELS_TREECACHE_TREECACHECHECKER_H
