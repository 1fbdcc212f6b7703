//===- CachedRayTracer.h - Rays through a cached BVH ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The baseline's traversal (kernels/bvh/BvhTraversal.h) over a tree of slots:
// the same tests in the same order, thus the same results. Where that holds
// references to nodes, this holds the offsets of the words that name them, and
// looks there whether they are loaded when it is their turn. Every such word is
// in a slot on the way from the root to the current node, which is never
// deleted.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_CACHEDRAYTRACER_H
#define TP_KERNELS_TREECACHE_CACHEDRAYTRACER_H

#include "kernels/bvh/BvhTraversal.h"
#include "kernels/treecache/TreeCache.h"
#ifdef TP_CACHE_CHECK
#include "kernels/treecache/TreeCacheChecker.h"
#endif

namespace tp {

/// Keeps what rays visit in a cache of \p Format (a SlotFormat); \p Policy (as
/// HighestBranch) says what is deleted when it is full. With TP_CACHE_CHECK
/// defined, the cache is verified after each deletion (TreeCacheChecker.h).
template <class Format, class Policy> class CachedRayTracer {
public:
  using Cache = TreeCache<Format, Policy::BytesPerSlot>;

  /// \p Slots is an empty cache of the tree Format::Nodes::root(\p Scene);
  /// \p Entries has room for traversalEntries() of the tree.
  CachedRayTracer(const SceneView &Scene, const Cache &Slots,
                  TraversalStack::Entry *Entries)
      : Memory{Nodes::nodes(Scene), Scene.Triangles}, Slots(Slots),
#ifdef TP_CACHE_CHECK
        Scene(Scene),
#endif
        Entries(Entries) {
    rayEvent(RayEvent::CacheSlots, Slots.end() / Cache::SlotBytes);
    rayEvent(RayEvent::CacheSlotBytes, Cache::SlotBytes);
    rayEvent(RayEvent::CacheSlotTriangles, Format::TrianglesPerSlot);
    rayEvent(RayEvent::CacheChildOffset, Format::ChildOffset);
  }

  /// The first triangle that \p R meets before \p MaxDistance.
  TP_KERNEL_INLINE Hit findClosestHit(const Ray &R, float MaxDistance) {
    Rules.beginRay();
    const RayTriangleTester Triangles(R);
    const BoxTester Boxes(R);
    const SlotMemory Words = Slots.memory();
    const char *const TaggedNodes = Words.at(0) - kInnerTag;
    TraversalStack Stack(Entries);
    Hit Nearest{MaxDistance, kNoTriangle};
    uint32_t Word = kRootWord;
    for (;;) {
      CacheLink Link = Words.word(Word);
      if (!isLoadedInner(Link)) {
        if (!isLoaded(Link))
          Link = fetch(Word, Link, Stack.top());
        if (!isLoadedInner(Link)) {
          if (!isLoaded(Link)) [[unlikely]] {
            Nearest = closestHitInMemory(Link, Triangles, Boxes, Stack.top(),
                                         Nearest);
          } else {
            noteVisit(Link);
            if (testPart(Words, Link, Triangles, Nearest)) {
              Word = Link - kLeafTag + Format::RestOffset;
              continue;
            }
          }
          if (!Stack.popNearer(Nearest.Distance, Word))
            return Nearest;
          continue;
        }
      }
      noteVisit(Link);
      const ChildWords Children(Link);
      const BoxDistances D =
          Boxes.testInLocalStore(TaggedNodes + Link, Nearest.Distance);
      if (!descendToNearest(D, Children.Words, Stack, Word) &&
          !Stack.popNearer(Nearest.Distance, Word))
        return Nearest;
    }
  }

  /// Whether \p R meets any triangle before \p MaxDistance.
  TP_KERNEL_INLINE bool isBlocked(const Ray &R, float MaxDistance) {
    Rules.beginRay();
    const RayTriangleTester Triangles(R);
    const BoxTester Boxes(R);
    const SlotMemory Words = Slots.memory();
    const char *const TaggedNodes = Words.at(0) - kInnerTag;
    TraversalStack Stack(Entries);
    uint32_t Word = kRootWord;
    do {
      CacheLink Link = Words.word(Word);
      if (!isLoadedInner(Link)) {
        if (!isLoaded(Link))
          Link = fetch(Word, Link, Stack.top());
        if (!isLoadedInner(Link)) {
          if (!isLoaded(Link)) [[unlikely]] {
            if (isBlockedInMemory(Link, Triangles, Boxes, Stack.top(),
                                  MaxDistance))
              return true;
            continue;
          }
          noteVisit(Link);
          Hit Found{MaxDistance, kNoTriangle};
          const bool HasRest = testPart(Words, Link, Triangles, Found);
          if (Found.Triangle != kNoTriangle)
            return true;
          Stack.pushIf(HasRest, Link - kLeafTag + Format::RestOffset);
          continue;
        }
      }
      noteVisit(Link);
      const ChildWords Children(Link);
      const BoxDistances D =
          Boxes.testInLocalStore(TaggedNodes + Link, MaxDistance);
      for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
        Stack.pushIf(D.isHit(Child), Children.Words[Child]);
    } while (Stack.pop(Word));
    return false;
  }

private:
  using Nodes = typename Format::Nodes;
  using BoxTester = typename Nodes::BoxTester;

  /// The offsets of the child words of an inner node.
  struct ChildWords {
    TP_KERNEL_INLINE explicit ChildWords(CacheLink Link) {
      for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
        Words[Child] = Link - kInnerTag + Format::ChildOffset + Child * 4;
    }
    uint32_t Words[kWideBvhWidth];
  };

  /// Loads what \p Link at \p Word names, and returns the link to its slot; or
  /// \p Link itself if no slot can be had. The entries below \p Top are
  /// waiting.
  TP_KERNEL_INLINE CacheLink fetch(uint32_t Word, BvhReference Link,
                                   TraversalStack::Entry *Top) {
    if (!Slots.hasFreeSlot()) [[unlikely]]
      return fetchIntoFullCache(Word, Link, Top);
    return Slots.load(Memory, Word, Link);
  }
  [[gnu::noinline]] CacheLink fetchIntoFullCache(uint32_t Word,
                                                 BvhReference Link,
                                                 TraversalStack::Entry *Top) {
    return makeRoom(Word, Top) ? Slots.load(Memory, Word, Link) : Link;
  }

  /// Once for each visit of a loaded \p Link.
  TP_KERNEL_INLINE void noteVisit(CacheLink Link) {
    rayEvent(RayEvent::SlotVisit, Link);
    Rules.visit(Slots, Link);
  }

  /// Deletes a branch so that what \p Word names can be loaded; false if the
  /// policy has none. The entries below \p Top are waiting.
  bool makeRoom(uint32_t Word, [[maybe_unused]] TraversalStack::Entry *Top) {
    const uint32_t Branch = Rules.chooseBranch(Slots, Word);
    if (Branch == kNoWord)
      return false;
    Slots.unloadBranch(Branch);
#ifdef TP_CACHE_CHECK
    const TreeCacheState State = treeCacheState(Slots);
    Checker.verifyDeletion(treeCacheLayout<Cache>(), State,
                           treeCacheSource<Nodes>(Scene),
                           {Word, &Entries->Reference,
                            sizeof(TraversalStack::Entry) / sizeof(uint32_t),
                            static_cast<uint32_t>(Top - Entries)});
#endif
    return true;
  }

  /// Replaces \p Found by the nearest hit that is nearer in the part of a leaf
  /// that \p Link names; true if the leaf goes on behind it.
  TP_KERNEL_INLINE static bool testPart(const SlotMemory &Words, CacheLink Link,
                                        const RayTriangleTester &Triangles,
                                        Hit &Found) {
    const uint32_t Slot = linkedSlot(Link);
    const char *Part = Words.at(Slot);
    const BvhReference Leaf = Words.word(Slot + Format::SourceOffset);
    testTriangles<Format::TrianglesPerSlot>(Part, leafFirst(Leaf),
                                            leafCount(Leaf), Triangles, Found);
    return Words.word(Slot + Format::RestOffset) != kNoRest;
  }

  /// Tests the first \p Count triangles of a slot, or \p Most if that is less.
  template <uint32_t Most>
  TP_KERNEL_INLINE static void
  testTriangles(const char *Part, uint32_t First, uint32_t Count,
                const RayTriangleTester &Triangles, Hit &Found) {
    if constexpr (Most != 0) {
      if (Count < Most)
        return testTriangles<Most - 1>(Part, First, Count, Triangles, Found);
      Triangles.test<Most>(Part, kTriangleTestBytes, First, Found);
    }
  }

  // Both take copies, so that those of the caller can stay in registers.
  [[gnu::noinline]] Hit closestHitInMemory(BvhReference Reference,
                                           RayTriangleTester Triangles,
                                           BoxTester Boxes,
                                           TraversalStack::Entry *Free,
                                           Hit Found) const {
    rayEvent(RayEvent::Bypass, Reference);
    findClosestHitBelow<Nodes>(Memory, Reference, Triangles, Boxes, Free,
                               Found);
    return Found;
  }
  [[gnu::noinline]] bool isBlockedInMemory(BvhReference Reference,
                                           RayTriangleTester Triangles,
                                           BoxTester Boxes,
                                           TraversalStack::Entry *Free,
                                           float MaxDistance) const {
    rayEvent(RayEvent::Bypass, Reference);
    return isBlockedBelow<Nodes>(Memory, Reference, Triangles, Boxes, Free,
                                 MaxDistance);
  }

  const BvhMemory Memory;
  Cache Slots;
  [[no_unique_address]] Policy Rules;
#ifdef TP_CACHE_CHECK
  const SceneView Scene;
  TreeCacheChecker Checker;
#endif
  TraversalStack::Entry *const Entries;
};

} // namespace tp

#endif // TP_KERNELS_TREECACHE_CACHEDRAYTRACER_H
