//===- CachedRayTracerTest.cpp - Cached rays against plain ones -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Random rays through random trees with caches of every size: each finds what
// the traversal from memory finds in the same visits, and after every single
// operation the cache keeps every rule of its verifier. CachedRayTracer
// verifies the deletions itself (TP_CACHE_CHECK), the path included.
//
//===----------------------------------------------------------------------===//

#include "kernels/treecache/CachedRayTracer.h"

#include "LoadedCache.h"
#include "kernels/common/RayEvents.h"
#include "kernels/pathtracer/MemoryRayTracer.h"
#include "kernels/treecache/HighestBranch.h"
#include "kernels/treecache/KeepTop.h"
#include "kernels/treecache/LeastRecentlyUsed.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <type_traits>
#include <utility>

using namespace tp;

namespace {

/// What a ray visits in memory, or in the slots whose sources it is told.
class VisitRecorder : public ProfileObserver {
public:
  void profileValue(uint32_t, uint32_t Marker, uint32_t Value) override {
    if (Marker == uint32_t(RayEvent::NodeFromMemory) ||
        Marker == uint32_t(RayEvent::TrianglesFromMemory))
      visit(Value, 0);
  }
  /// A node, or a leaf of which the rest follows on its own if there are more
  /// than \p SlotTriangles.
  void visit(BvhReference Visited, uint32_t SlotTriangles) {
    if (Visited != Rest)
      References.push_back(Visited);
    Rest = kNoNode;
    if (isLeaf(Visited) && SlotTriangles != 0 &&
        leafCount(Visited) > SlotTriangles)
      Rest = leafReference(leafFirst(Visited) + SlotTriangles,
                           leafCount(Visited) - SlotTriangles);
  }
  /// All since the last time.
  std::vector<BvhReference> take() {
    Rest = kNoNode;
    return std::exchange(References, {});
  }

private:
  static constexpr BvhReference kNoNode = 1;

  std::vector<BvhReference> References;
  BvhReference Rest = kNoNode;
};

/// What a traversal of a scene's tree leaves to be visited, with a little more
/// that it must not touch.
class GuardedEntries {
public:
  explicit GuardedEntries(const SceneView &Scene)
      : Entries(traversalEntries(Scene.Header->BvhDepth) + GuardCount, Guard) {}

  TraversalStack::Entry *data() { return Entries.data(); }
  bool isIntact() const {
    return std::all_of(Entries.end() - GuardCount, Entries.end(),
                       [](const TraversalStack::Entry &Entry) {
                         return Entry.Reference == Guard.Reference &&
                                Entry.Enter == Guard.Enter;
                       });
  }

private:
  static constexpr uint32_t GuardCount = 4;
  static constexpr TraversalStack::Entry Guard = {0x5AFE5AFE, -1};

  std::vector<TraversalStack::Entry> Entries;
};

/// What the policies of one test know.
struct Witness {
  VisitRecorder Visited;
  TreeCacheSource Source{};
  std::vector<uint32_t> Scratch;
  uint64_t Visits = 0;
  uint64_t Deletions = 0;

  template <class Cache> void verify(const Cache &Slots) {
    const TreeCacheState State = treeCacheState(Slots);
    Scratch.resize(treeCacheVerifierWords(State.SlotCount));
    const TreeCacheViolation Found = verifyTreeCache(
        treeCacheLayout<Cache>(), State, Source, nullptr, Scratch.data());
    ASSERT_TRUE(Found.isClean()) << describe(Found);
  }
};
Witness *CurrentWitness = nullptr;

/// How many slots are above the word, which is in the tree.
template <class Cache> uint32_t depthOf(const Cache &Slots, uint32_t Word) {
  uint32_t Depth = 0;
  for (; Word != kRootWord; Word = Slots.parent(Slots.slotOfWord(Word)))
    ++Depth;
  return Depth;
}

/// Whether the way from the root to \p Word passes \p Other, or ends there.
template <class Cache>
bool passes(const Cache &Slots, uint32_t Word, uint32_t Other) {
  while (Word != Other && Word != kRootWord)
    Word = Slots.parent(Slots.slotOfWord(Word));
  return Word == Other;
}

/// The depth of the highest branch of a full cache beside the way to \p Word,
/// or that of kNoWord.
template <class Cache>
uint32_t depthOfHighest(const Cache &Slots, uint32_t Word) {
  uint32_t Least = kNoWord;
  for (uint32_t Slot = 0; Slot != Slots.end(); Slot += Cache::SlotBytes) {
    const uint32_t Branch = Slots.parent(Slot);
    if (!passes(Slots, Word, Branch))
      Least = std::min(Least, depthOf(Slots, Branch));
  }
  return Least;
}

/// \p Policy, with a look at the cache at each visit and choice.
template <class Policy> class Watched : public Policy {
public:
  template <class Cache> void visit(Cache &Slots, CacheLink Link) {
    Policy::visit(Slots, Link);
    ++CurrentWitness->Visits;
    CurrentWitness->Visited.visit(Slots.source(linkedSlot(Link)),
                                  Cache::SlotFormat::TrianglesPerSlot);
    CurrentWitness->verify(Slots);
  }
  template <class Cache> uint32_t chooseBranch(Cache &Slots, uint32_t Word) {
    EXPECT_FALSE(Slots.hasFreeSlot()) << "a deletion in a cache with room";
    CurrentWitness->verify(Slots);
    const uint32_t Branch = Policy::chooseBranch(Slots, Word);
    CurrentWitness->Deletions += Branch != kNoWord;
    if (std::is_same_v<Policy, HighestBranch>)
      EXPECT_EQ(depthOfHighest(Slots, Word),
                Branch == kNoWord ? kNoWord : depthOf(Slots, Branch));
    return Branch;
  }
};

template <class FormatType, class PolicyType> struct Variant {
  using Format = FormatType;
  using Policy = PolicyType;
};

template <class VariantType> class CachedRays : public testing::Test {
protected:
  using Format = typename VariantType::Format;
  using Tracer = CachedRayTracer<Format, Watched<typename VariantType::Policy>>;
  using Cache = typename Tracer::Cache;

  /// Traces rays through \p Tree with a cache of so many slots.
  void compare(const RandomTree &Tree, uint32_t SlotCount, uint32_t RayCount,
               uint32_t Seed);

  Witness Seen;
};

using Variants = testing::Types<
    Variant<FullSlots, HighestBranch>, Variant<FullSlots, LeastRecentlyUsed>,
    Variant<FullSlots, KeepTop>, Variant<QuantizedSlots, HighestBranch>,
    Variant<QuantizedSlots, LeastRecentlyUsed>,
    Variant<QuantizedSlots, KeepTop>>;
TYPED_TEST_SUITE(CachedRays, Variants);

} // namespace

template <class VariantType>
void CachedRays<VariantType>::compare(const RandomTree &Tree,
                                      uint32_t SlotCount, uint32_t RayCount,
                                      uint32_t Seed) {
  const SceneView View = Tree.view();
  Seen.Source = treeCacheSource<typename Format::Nodes>(View);
  CurrentWitness = &Seen;
  CurrentProfileObserver = &Seen.Visited;
  GuardedEntries Entries(View), CachedEntries(View);
  std::vector<uint32_t> Memory(Cache::bytesFor(SlotCount) / sizeof(uint32_t));
  MemoryRayTracer<typename Format::Nodes> Plain(View, Entries.data());
  Tracer Cached(View,
                Cache(reinterpret_cast<char *>(Memory.data()), SlotCount,
                      Format::Nodes::root(View)),
                CachedEntries.data());
  RandomRays Rays(Seed);
  for (uint32_t Number = 0; Number != RayCount; ++Number) {
    const Ray R = Rays.next();
    const float MaxDistance = Rays.once(3) ? 1e30f : Rays.number(0, 30);
    if (Rays.once(2)) {
      const bool Expected = Plain.isBlocked(R, MaxDistance);
      const auto ExpectedVisits = Seen.Visited.take();
      EXPECT_EQ(Expected, Cached.isBlocked(R, MaxDistance));
      EXPECT_EQ(ExpectedVisits, Seen.Visited.take());
      continue;
    }
    const Hit Expected = Plain.findClosestHit(R, MaxDistance);
    const auto ExpectedVisits = Seen.Visited.take();
    const Hit Found = Cached.findClosestHit(R, MaxDistance);
    EXPECT_EQ(ExpectedVisits, Seen.Visited.take());
    EXPECT_EQ(Expected.Triangle, Found.Triangle);
    EXPECT_EQ(Expected.Distance, Found.Distance);
  }
  CurrentProfileObserver = nullptr;
  EXPECT_TRUE(Entries.isIntact());
  EXPECT_TRUE(CachedEntries.isIntact());
}

TYPED_TEST(CachedRays, FindWhatPlainRaysFind) {
  struct Case {
    TreeShape Shape;
    uint32_t Triangles;
  };
  const Case Cases[] = {{TreeShape::Built, 1},  {TreeShape::Built, 300},
                        {TreeShape::Mixed, 2},  {TreeShape::Mixed, 90},
                        {TreeShape::Chain, 50}, {TreeShape::LongLeaves, 100},
                        {TreeShape::Leaf, 1},   {TreeShape::Leaf, 15},
                        {TreeShape::Empty, 1}};
  uint32_t Seed = 0;
  for (const Case &Of : Cases)
    for (uint32_t Slots : {0u, 3u, 4u, 5u, 6u, 8u, 13u, 16u, 30u, 300u}) {
      const RandomTree Tree(Of.Shape, Of.Triangles, ++Seed);
      this->compare(Tree, Slots, 200, Seed);
      ASSERT_FALSE(this->HasFailure())
          << "shape " << int(Of.Shape) << ", " << Of.Triangles
          << " triangles, seed " << Seed << ", " << Slots << " slots";
    }
  EXPECT_GT(this->Seen.Visits, 40000u);
  if (!std::is_same_v<typename TypeParam::Policy, KeepTop>)
    EXPECT_GT(this->Seen.Deletions, 2000u);
}
