//===- LoadedCache.h - A cache with something in it -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_TREECACHE_LOADEDCACHE_H
#define TP_TEST_UNIT_TREECACHE_LOADEDCACHE_H

#include "RandomTree.h"
#include "kernels/treecache/TreeCache.h"
#include "kernels/treecache/TreeCacheChecker.h"

#include <string>
#include <vector>

namespace tp {

inline std::string describe(const TreeCacheViolation &Violation) {
  char Sentence[200];
  describeViolation(Violation, Sentence, sizeof(Sentence));
  return Sentence;
}

/// A cache of some slots, breadth first filled with the tree but for some slots
/// that are never used.
template <class Format> class LoadedCache {
public:
  using Cache = TreeCache<Format>;

  LoadedCache(const RandomTree &Tree, uint32_t SlotCount,
              uint32_t SpareCount = 0)
      : View(Tree.view()), Memory(Cache::bytesFor(SlotCount) / 4),
        Slots(reinterpret_cast<char *>(Memory.data()), SlotCount,
              Format::Nodes::root(View)) {
    for (std::vector<uint32_t> Words = {kRootWord}; !Words.empty();) {
      std::vector<uint32_t> Next;
      for (uint32_t Word : Words)
        load(Word, (SlotCount - SpareCount) * Cache::SlotBytes, Next);
      Words = Next;
    }
  }

  TreeCacheState state() const { return treeCacheState(Slots); }
  TreeCacheSource source() const {
    return treeCacheSource<typename Format::Nodes>(View);
  }
  static constexpr TreeCacheLayout layout() { return treeCacheLayout<Cache>(); }

  TreeCacheViolation verify() const { return verify(state()); }
  TreeCacheViolation verify(const TreeCacheState &State,
                            const TreeCachePath *Path = nullptr) const {
    return verify(State, source(), Path);
  }
  TreeCacheViolation verify(const TreeCacheState &State,
                            const TreeCacheSource &Source,
                            const TreeCachePath *Path) const {
    std::vector<uint32_t> Scratch(treeCacheVerifierWords(State.SlotCount));
    return verifyTreeCache(layout(), State, Source, Path, Scratch.data());
  }

  /// The words of the cache but for the root word.
  uint32_t &at(uint32_t Offset) {
    return Memory[(Offset - kRootWord) / sizeof(uint32_t)];
  }

  /// The loaded child words of the tree, breadth first, with the root word.
  std::vector<uint32_t> loadedWords() const {
    std::vector<uint32_t> Words;
    if (isLoaded(Slots.word(kRootWord)))
      Words.push_back(kRootWord);
    for (size_t Next = 0; Next != Words.size(); ++Next) {
      const CacheLink Link = Slots.word(Words[Next]);
      for (uint32_t Child = 0; Child != Cache::childCount(Link); ++Child) {
        const uint32_t Word = Cache::firstChildWord(Link) + Child * 4;
        if (isLoaded(Slots.word(Word)))
          Words.push_back(Word);
      }
    }
    return Words;
  }
  /// Slots of the tree: inner ones, or parts of leaves.
  std::vector<uint32_t> slots(bool Leaves) const {
    std::vector<uint32_t> Result;
    for (uint32_t Word : loadedWords())
      if (isLoadedLeaf(Slots.word(Word)) == Leaves)
        Result.push_back(linkedSlot(Slots.word(Word)));
    return Result;
  }

  const SceneView View;
  std::vector<uint32_t> Memory;
  Cache Slots;

private:
  void load(uint32_t Word, uint32_t End, std::vector<uint32_t> &Next) {
    CacheLink Link = Slots.word(Word);
    // A missing child is the root again, or nothing.
    if (Word != kRootWord && (Link == kNoRest || Link == kNoBvh))
      return;
    // The rest of a leaf may have come with its first part.
    if (!isLoaded(Link)) {
      if (Slots.firstUnused() >= End)
        return;
      Link =
          Slots.load({Format::Nodes::nodes(View), View.Triangles}, Word, Link);
    }
    for (uint32_t Child = 0; Child != Cache::childCount(Link); ++Child)
      Next.push_back(Cache::firstChildWord(Link) + Child * 4);
  }
};

} // namespace tp

#endif // TP_TEST_UNIT_TREECACHE_LOADEDCACHE_H
