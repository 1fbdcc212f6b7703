//===- TreeCacheVerifierTest.cpp - A seeded fault for each rule -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/treecache/TreeCacheVerifier.h"

#include "LoadedCache.h"

#include <gtest/gtest.h>

using namespace tp;

namespace {

using Loaded = LoadedCache<FullSlots>;
using Cache = Loaded::Cache;

/// Long leaves of which some are not loaded, a free list of a few slots, and
/// slots that were never used.
class TreeCacheVerifier : public testing::Test {
protected:
  TreeCacheVerifier() : Tree(TreeShape::LongLeaves, 400, 1), C(Tree, 210, 10) {
    // A leaf, and the last part of another.
    for (bool IsRest : {false, true})
      for (uint32_t Word : C.loadedWords())
        if (Word != kRootWord && isLoadedLeaf(C.Slots.word(Word)) &&
            isRestWord(Word) == IsRest) {
          FreedCount += C.Slots.unloadBranch(Word);
          break;
        }
  }

  bool isRestWord(uint32_t Word) const {
    return isLeaf(C.Slots.source(Cache::slotOfWord(Word)));
  }
  void expectRule(TreeCacheRule Rule) { expectRule(Rule, C.state()); }
  void expectRule(TreeCacheRule Rule, const TreeCacheState &State,
                  const TreeCachePath *Path = nullptr) {
    const TreeCacheViolation Found = C.verify(State, Path);
    EXPECT_EQ(Found.Rule, Rule) << describe(Found);
    LastSentence = describe(Found);
  }
  /// The offset of some child word that is loaded, or is not and has a child.
  uint32_t someWord(bool IsLoaded) {
    for (uint32_t Slot : C.slots(false))
      for (uint32_t Child = 0; Child != kWideBvhWidth; ++Child) {
        const uint32_t Word = Slot + FullSlots::ChildOffset + Child * 4;
        const CacheLink Link = C.Slots.word(Word);
        if (isLoaded(Link) == IsLoaded && Link != kNoRest)
          return Word;
      }
    ADD_FAILURE() << "no such word";
    return 0;
  }

  const RandomTree Tree;
  Loaded C;
  uint32_t FreedCount = 0;
  std::string LastSentence;
};

} // namespace

TEST_F(TreeCacheVerifier, LoadedCachesAreClean) {
  EXPECT_EQ(describe(C.verify()), "every rule is kept");
  EXPECT_GT(FreedCount, 2u) << "a chain of leaf parts";
  EXPECT_GT(C.slots(true).size(), 3u);
  EXPECT_GT(C.slots(false).size(), 3u);
  for (TreeShape Shape : {TreeShape::Built, TreeShape::Mixed, TreeShape::Chain,
                          TreeShape::Leaf, TreeShape::Empty})
    for (uint32_t Slots : {0u, 1u, 2u, 3u, 9u, 1000u}) {
      const RandomTree Other(Shape, Shape == TreeShape::Leaf ? 15 : 50, 2);
      const Loaded Part(Other, Slots);
      EXPECT_EQ(describe(Part.verify()), "every rule is kept") << Slots;
      EXPECT_EQ(Part.loadedWords().size(),
                Part.Slots.firstUnused() / Cache::SlotBytes);
    }
}

TEST_F(TreeCacheVerifier, FindsSlotsOutsideTheMemory) {
  TreeCacheState State = C.state();
  --State.Bytes;
  expectRule(TreeCacheRule::SlotsInMemory, State);
  EXPECT_EQ(LastSentence, "the cache has 210 slots in memory for 209");
}

TEST_F(TreeCacheVerifier, FindsMoreUsedSlotsThanThereAre) {
  TreeCacheState State = C.state();
  State.UsedSlots = State.SlotCount + 1;
  expectRule(TreeCacheRule::UsedSlots, State);
}

TEST_F(TreeCacheVerifier, FindsFreeListsThatLeaveTheSlots) {
  TreeCacheState State = C.state();
  const uint32_t Last = State.FreeSlot;
  State.FreeSlot += 4;
  expectRule(TreeCacheRule::FreeLink, State);
  State = C.state();
  for (uint32_t Bad : {State.UsedSlots * Cache::SlotBytes, kRootWord, 1u}) {
    C.at(Last + FullSlots::ParentOffset) = Bad;
    expectRule(TreeCacheRule::FreeLink, State);
  }
}

TEST_F(TreeCacheVerifier, FindsFreeListsWithoutAnEnd) {
  C.at(C.Slots.firstFree() + FullSlots::ParentOffset) = C.Slots.firstFree();
  expectRule(TreeCacheRule::FreeListEnds);
}

TEST_F(TreeCacheVerifier, FindsLinksToNoSlot) {
  uint32_t &Link = C.at(someWord(true));
  const uint32_t Good = Link;
  for (uint32_t Bad : {Good + 4, Good + 4 * Cache::SlotBytes * 210,
                       (Good & 3) | C.Slots.firstUnused()}) {
    Link = Bad;
    expectRule(TreeCacheRule::LoadedLink);
  }
  C.at(kRootWord) = innerLink(Cache::SlotBytes * 210);
  expectRule(TreeCacheRule::LoadedLink);
  EXPECT_EQ(LastSentence, "at the root: the link 0x6271 names no used slot");
}

TEST_F(TreeCacheVerifier, FindsLinksOfTheWrongKind) {
  C.at(someWord(true)) ^= kInnerTag ^ kLeafTag;
  expectRule(TreeCacheRule::LinkKind);
}

TEST_F(TreeCacheVerifier, FindsReferencesThatMemoryDoesNotHave) {
  const uint32_t Word = someWord(false);
  const uint32_t Good = C.at(Word);
  for (uint32_t Bad : {Good ^ 128, Good ^ 0x40000000u, 0u}) {
    C.at(Word) = Bad;
    expectRule(TreeCacheRule::UnloadedLink);
  }
  C.at(Word) = Good;
  C.at(kRootWord) = leafReference(3, 2);
  expectRule(TreeCacheRule::UnloadedLink);
  EXPECT_EQ(LastSentence, "at the root: 0x80000032 is neither a link to a slot "
                          "nor memory's reference 0x0");
}

TEST_F(TreeCacheVerifier, FindsWrongRestsOfLeaves) {
  unsigned Ends = 0, Unloaded = 0, InChain = 0;
  for (uint32_t Slot : C.slots(true)) {
    uint32_t &Rest = C.at(Slot + FullSlots::RestOffset);
    const uint32_t Good = Rest;
    if (isLoaded(Good)) {
      // The rest of a loaded chain is forgotten.
      ++InChain;
      Rest = kNoRest;
      expectRule(TreeCacheRule::LeafRest);
      Rest = Good;
      continue;
    }
    ++(Good == kNoRest ? Ends : Unloaded);
    for (uint32_t Bad : {Good ^ 1 << 4, Good ^ 2, leafReference(1, 1)}) {
      Rest = Bad;
      expectRule(TreeCacheRule::LeafRest);
    }
    if (Good == kNoRest)
      for (uint32_t Bad : {leafLink(Slot), innerLink(Slot)}) {
        Rest = Bad;
        expectRule(TreeCacheRule::LeafRest);
      }
    Rest = Good;
  }
  EXPECT_GT(Ends, 0u);
  EXPECT_GT(Unloaded, 0u);
  EXPECT_GT(InChain, 0u);
}

TEST_F(TreeCacheVerifier, FindsFreeSlotsInTheTree) {
  const uint32_t Word = someWord(true);
  C.at(Word) = (C.at(Word) & 3) | C.Slots.firstFree();
  expectRule(TreeCacheRule::ReachedSlotFree);
}

TEST_F(TreeCacheVerifier, FindsReachedSlotsInTheFreeList) {
  // The last free slot goes on to a slot of the tree that ends the list.
  uint32_t Last = C.Slots.firstFree();
  while (C.Slots.parent(Last) != kNoSlot)
    Last = C.Slots.parent(Last);
  const uint32_t Reached = linkedSlot(C.Slots.word(someWord(true)));
  C.at(Last + FullSlots::ParentOffset) = Reached;
  C.at(Reached + FullSlots::ParentOffset) = kNoSlot;
  expectRule(TreeCacheRule::ReachedSlotFree);
}

TEST_F(TreeCacheVerifier, FindsSlotsWithTwoParents) {
  const std::vector<uint32_t> Words = C.loadedWords();
  uint32_t First = kNoWord;
  for (uint32_t Word : Words) {
    if (!isLoadedLeaf(C.Slots.word(Word)) || Word == kRootWord)
      continue;
    if (First == kNoWord) {
      First = Word;
      continue;
    }
    // The first in depth-first order, too: they have one parent.
    C.at(Word) = C.at(First);
    break;
  }
  expectRule(TreeCacheRule::SlotOnce);
}

TEST_F(TreeCacheVerifier, FindsCycles) {
  const uint32_t Word = someWord(true);
  const bool Leaf = isLoadedLeaf(C.Slots.word(Word));
  ASSERT_TRUE(Leaf || !C.slots(false).empty());
  for (uint32_t Inner : C.loadedWords())
    if (Inner != kRootWord && !isLoadedLeaf(C.Slots.word(Inner))) {
      C.at(Inner) = innerLink(Cache::slotOfWord(Inner));
      break;
    }
  expectRule(TreeCacheRule::SlotOnce);
}

TEST_F(TreeCacheVerifier, FindsWrongParents) {
  for (uint32_t Word : C.loadedWords()) {
    uint32_t &Parent =
        C.at(linkedSlot(C.Slots.word(Word)) + FullSlots::ParentOffset);
    const uint32_t Good = Parent;
    for (uint32_t Bad : {Good + 4, Good ^ 0x80000000u, 0u, kNoSlot}) {
      Parent = Bad;
      expectRule(TreeCacheRule::ParentWord);
    }
    Parent = Good;
  }
}

TEST_F(TreeCacheVerifier, FindsWrongSources) {
  for (uint32_t Word : C.loadedWords()) {
    uint32_t &Source =
        C.at(linkedSlot(C.Slots.word(Word)) + FullSlots::SourceOffset);
    const uint32_t Good = Source;
    for (uint32_t Bad : {Good ^ 128, Good ^ 1, ~Good}) {
      Source = Bad;
      expectRule(TreeCacheRule::SourceWord);
    }
    Source = Good;
  }
}

TEST_F(TreeCacheVerifier, FindsSourcesThatAreNotInMemory) {
  TreeCacheSource Source = C.source();
  auto Rule = [&] { return C.verify(C.state(), Source, nullptr).Rule; };
  uint32_t LastNode = 0, TriangleEnd = 0;
  for (uint32_t Slot : C.slots(false))
    LastNode = std::max<uint32_t>(LastNode,
                                  C.Slots.source(Slot) / sizeof(WideBvhNode));
  for (uint32_t Slot : C.slots(true))
    TriangleEnd = std::max(TriangleEnd, leafFirst(C.Slots.source(Slot)) +
                                            leafCount(C.Slots.source(Slot)));
  Source.NodeCount = LastNode + 1;
  Source.TriangleCount = TriangleEnd;
  EXPECT_EQ(Rule(), TreeCacheRule::None);
  Source.NodeCount = LastNode;
  EXPECT_EQ(Rule(), TreeCacheRule::SourceInMemory);
  Source = C.source();
  for (uint32_t Count : {0u, TriangleEnd / 2, TriangleEnd - 1}) {
    Source.TriangleCount = Count;
    EXPECT_EQ(Rule(), TreeCacheRule::SourceInMemory);
  }
  // A tree whose root lies across two nodes.
  Source = C.source();
  Source.Root = sizeof(WideBvhNode) / 2;
  C.at(FullSlots::SourceOffset) = Source.Root;
  EXPECT_EQ(Rule(), TreeCacheRule::SourceInMemory);
}

TEST_F(TreeCacheVerifier, FindsNodesThatDifferFromMemory) {
  for (uint32_t Slot : C.slots(false))
    for (uint32_t Offset : {0u, 4u, FullSlots::ChildOffset - 4}) {
      C.at(Slot + Offset) ^= 1;
      expectRule(TreeCacheRule::NodeWord);
      C.at(Slot + Offset) ^= 1;
    }
}

TEST_F(TreeCacheVerifier, FindsTrianglesThatDifferFromMemory) {
  for (uint32_t Slot : C.slots(true)) {
    const uint32_t Count =
        std::min(leafCount(C.Slots.source(Slot)), FullSlots::TrianglesPerSlot);
    for (uint32_t Offset : {0u, Count * kTriangleTestBytes - 4}) {
      C.at(Slot + Offset) ^= 0x80000000u;
      expectRule(TreeCacheRule::TriangleWord);
      C.at(Slot + Offset) ^= 0x80000000u;
    }
  }
}

TEST_F(TreeCacheVerifier, FindsLostSlots) {
  // A branch that is unlinked, but not freed.
  const uint32_t Word = someWord(true);
  const uint32_t Slot = linkedSlot(C.at(Word));
  C.at(Word) = C.Slots.source(Slot);
  expectRule(TreeCacheRule::SlotLost);
}

TEST_F(TreeCacheVerifier, FindsFreeSlotsThatAreForgotten) {
  TreeCacheState State = C.state();
  State.FreeSlot = C.Slots.parent(State.FreeSlot);
  expectRule(TreeCacheRule::SlotLost, State);
  State = C.state();
  ASSERT_LT(State.UsedSlots, State.SlotCount + 1);
  State.FreeSlot = kNoSlot;
  expectRule(TreeCacheRule::SlotLost, State);
}

/// A traversal in a deep slot, with entries of each of its ancestors.
TEST_F(TreeCacheVerifier, FindsDeletedPaths) {
  const std::vector<uint32_t> Words = C.loadedWords();
  const uint32_t Current = Words.back();
  struct Entry {
    uint32_t Word;
    float Enter;
  };
  std::vector<Entry> Stack;
  for (uint32_t Word = Current; Word != kRootWord;
       Word = C.Slots.parent(Cache::slotOfWord(Word)))
    Stack.insert(Stack.begin(), {Word, 1});
  ASSERT_GT(Stack.size(), 3u);
  Stack.insert(Stack.begin(), {kRootWord, 1});
  const TreeCachePath Path = {Current, &Stack[0].Word,
                              sizeof(Entry) / sizeof(uint32_t),
                              uint32_t(Stack.size())};
  const TreeCacheState State = C.state();
  EXPECT_EQ(describe(C.verify(State, &Path)), "every rule is kept");

  TreeCachePath Bad = Path;
  for (uint32_t Word :
       {Current + 2, C.Slots.firstFree() + FullSlots::ChildOffset,
        C.Slots.firstUnused() + FullSlots::ChildOffset, kNoWord,
        C.slots(false)[0], C.slots(false)[0] + FullSlots::ChildOffset + 2,
        C.slots(false)[0] + FullSlots::ParentOffset}) {
    Bad.Word = Word;
    expectRule(TreeCacheRule::PathDeleted, State, &Bad);
    Stack[2].Word = Word;
    expectRule(TreeCacheRule::PendingDeleted, State, &Path);
    Stack[2].Word = Current;
  }
  // In the tree, but beside the path.
  const uint32_t PathSlot = Cache::slotOfWord(Current);
  for (uint32_t Slot : C.slots(true))
    if (Slot != PathSlot && Slot != Cache::slotOfWord(Stack.back().Word)) {
      Stack[2].Word = Slot + FullSlots::RestOffset;
      if (C.verify(State, &Path).isClean())
        continue; // A part of the same chain.
      expectRule(TreeCacheRule::PendingOffPath, State, &Path);
      break;
    }
  EXPECT_NE(LastSentence.find("entry 2 of the traversal's stack"),
            std::string::npos)
      << LastSentence;
}

/// An unloading that takes the path along.
TEST_F(TreeCacheVerifier, FindsPathsThatWereUnloaded) {
  const uint32_t Current = C.loadedWords().back();
  const TreeCachePath Path = {Current, nullptr, 0, 0};
  expectRule(TreeCacheRule::None, C.state(), &Path);
  C.Slots.unloadBranch(C.Slots.parent(Cache::slotOfWord(Current)));
  expectRule(TreeCacheRule::PathDeleted, C.state(), &Path);
}

namespace {

template <class Format> class EveryBit : public testing::Test {};
using Formats = testing::Types<FullSlots, QuantizedSlots>;

/// Whether some rule is about the word at \p Offset of \p Slot.
template <class Format>
bool matters(const LoadedCache<Format> &C, uint32_t Slot, uint32_t Offset,
             bool IsFree) {
  if (Offset >= Format::PolicyOffset)
    return false;
  if (Offset == Format::ParentOffset)
    return true;
  if (IsFree)
    return false;
  if (Offset == Format::SourceOffset)
    return true;
  const BvhReference Source = C.Slots.source(Slot);
  if (!isLeaf(Source))
    return Offset < Format::NodeBytes;
  const uint32_t Count = std::min(leafCount(Source), Format::TrianglesPerSlot);
  return Offset < Count * kTriangleTestBytes || Offset == Format::RestOffset;
}

} // namespace

TYPED_TEST_SUITE(EveryBit, Formats);

/// Any one bit of the cache that is wrong is found, and no more than that.
TYPED_TEST(EveryBit, ThatIsWrongIsFound) {
  std::mt19937 Generator(3);
  for (TreeShape Shape : {TreeShape::LongLeaves, TreeShape::Mixed}) {
    const RandomTree Tree(Shape, 150, 4);
    LoadedCache<TypeParam> C(Tree, 40);
    C.Slots.unloadBranch(C.loadedWords()[2]);
    ASSERT_TRUE(C.verify().isClean()) << describe(C.verify());
    std::vector<bool> IsFree(40);
    for (uint32_t Slot = C.Slots.firstFree(); Slot != kNoSlot;
         Slot = C.Slots.parent(Slot))
      IsFree[Slot / C.Slots.SlotBytes] = true;
    for (uint32_t Word = kRootWord; Word != C.Slots.firstUnused(); Word += 4)
      for (uint32_t Bit = 0; Bit != 32; ++Bit) {
        const uint32_t Slot = C.Slots.slotOfWord(Word);
        const bool Matters =
            Word == kRootWord ||
            matters(C, Slot, Word - Slot, IsFree[Slot / C.Slots.SlotBytes]);
        C.at(Word) ^= 1u << Bit;
        EXPECT_EQ(C.verify().isClean(), !Matters)
            << "bit " << Bit << " of the word at " << Word << ": "
            << describe(C.verify());
        C.at(Word) ^= 1u << Bit;
      }
  }
}

/// Whatever the memory holds, there is a verdict.
TEST_F(TreeCacheVerifier, GarbageGetsAVerdict) {
  std::mt19937 Generator(7);
  auto Word = [&] {
    const uint32_t Random = Generator();
    switch (Generator() % 4) {
    case 0:
      return Random;
    case 1:
      return Random % 64 * Cache::SlotBytes + Random % 4;
    case 2:
      return Random >> Random % 32;
    default:
      return leafReference(Random % 400, Random % 16);
    }
  };
  const std::vector<uint32_t> Good = C.Memory;
  for (int Round = 0; Round != 20000; ++Round) {
    C.Memory = Good;
    for (uint32_t Faults = Generator() % 20 + 1; Faults != 0; --Faults)
      C.Memory[Generator() % C.Memory.size()] = Word();
    TreeCacheState State = C.state();
    State.FreeSlot = Generator() % 2 ? Word() : State.FreeSlot;
    State.UsedSlots = Generator() % 4 ? State.UsedSlots : Word();
    State.SlotCount = Generator() % 4 ? State.SlotCount : Word() % 4096;
    TreeCacheSource Source = C.source();
    Source.Root = Generator() % 2 ? Source.Root : Word();
    uint32_t Pending[5];
    for (uint32_t &Entry : Pending)
      Entry = Word();
    const TreeCachePath Path = {Word(), Pending, 1, 5};
    const TreeCacheViolation Found = C.verify(State, Source, &Path);
    EXPECT_FALSE(Found.isClean());
    EXPECT_GT(describe(Found).size(), 10u);
  }
}
