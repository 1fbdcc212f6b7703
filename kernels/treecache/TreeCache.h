//===- TreeCache.h - The part of a BVH that a thread keeps ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A tree of slots that hangs at the root word. A node is in the cache only if
// its parent is, so unloading a node takes its whole branch along. Everything
// is offsets from the first slot.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_TREECACHE_H
#define TP_KERNELS_TREECACHE_TREECACHE_H

#include "kernels/common/RayEvents.h"
#include "kernels/treecache/CacheLink.h"
#include "kernels/treecache/SlotFormat.h"
#include "kernels/treecache/SlotMemory.h"
#include "kernels/treecache/WordsInFlight.h"

#include <stddef.h>
#include <stdint.h>

namespace tp {

/// \p Format is a SlotFormat; each slot has \p PolicyBytes more for the policy.
template <class Format, uint32_t PolicyBytes = 0> class TreeCache {
public:
  using SlotFormat = Format;
  static constexpr uint32_t SlotBytes = Format::PolicyOffset + PolicyBytes;

  /// Bytes of a cache of \p Slots slots.
  static constexpr uint32_t bytesFor(uint32_t Slots) {
    return RootWordBytes + Slots * SlotBytes;
  }
  /// Slots of a cache of \p Bytes.
  static constexpr uint32_t slotsIn(uint32_t Bytes) {
    return Bytes < RootWordBytes ? 0 : (Bytes - RootWordBytes) / SlotBytes;
  }

  /// An empty cache of the tree \p Root in the bytesFor(\p Slots) bytes at
  /// \p Memory, which is aligned to 4.
  TreeCache(char *Memory, uint32_t Slots, BvhReference Root)
      : Memory(Memory + RootWordBytes), End(Slots * SlotBytes) {
    setWord(kRootWord, Root);
  }

  /// Where the slots and the root word are.
  SlotMemory memory() const { return Memory; }
  /// The first slot; offsets count from here.
  char *base() const { return Memory.at(0); }
  /// The offset behind the last slot.
  uint32_t end() const { return End; }
  /// The offset of the first slot that was never used; end() if there is none.
  uint32_t firstUnused() const { return Unused; }
  /// The first slot of the free list, which goes on through parent(), or
  /// kNoSlot. A slot is in use, in the list, or behind firstUnused().
  uint32_t firstFree() const { return Free; }

  /// The word at an offset, for instance a link.
  uint32_t word(uint32_t Offset) const { return Memory.word(Offset); }
  void setWord(uint32_t Offset, uint32_t Value) {
    Memory.setWord(Offset, Value);
  }

  /// The offset of the word that names \p Slot.
  uint32_t parent(uint32_t Slot) const {
    return word(Slot + Format::ParentOffset);
  }
  /// What \p Slot was loaded from.
  BvhReference source(uint32_t Slot) const {
    return word(Slot + Format::SourceOffset);
  }
  /// The offset of the first link of what the loaded \p Link names, and how
  /// many links there are.
  static constexpr uint32_t firstChildWord(CacheLink Link) {
    return linkedSlot(Link) +
           (isLoadedLeaf(Link) ? Format::RestOffset : Format::ChildOffset);
  }
  static constexpr uint32_t childCount(CacheLink Link) {
    return isLoadedLeaf(Link) ? 1 : kWideBvhWidth;
  }
  /// The slot that holds the word at \p Word, which is not the root word.
  static constexpr uint32_t slotOfWord(uint32_t Word) {
    return Word - Word % SlotBytes;
  }

  /// Whether load() would find a slot.
  bool hasFreeSlot() const { return Free != kNoSlot || Unused != End; }

  /// Copies what the link at \p Word names into a free slot, of which there
  /// must be one, and returns the new link. The former link is \p Reference. Of
  /// a leaf with more than one part it also loads the next ones, as far as the
  /// words of one wait for memory and the free slots go.
  TP_KERNEL_INLINE CacheLink load(const BvhMemory &From, uint32_t Word,
                                  BvhReference Reference) {
    if (!isLeaf(Reference))
      return loadNode(From, Word, Reference);
    const uint32_t Count = leafCount(Reference);
    if (Count > Format::TrianglesPerSlot)
      return loadParts(From, Word, Reference);
    return loadPart<Format::TrianglesPerSlot>(From, Word, Reference, Count);
  }

  /// Unloads what the loaded link at \p Word names with all below it, and
  /// returns the number of slots that this freed.
  uint32_t unloadBranch(uint32_t Word);

private:
  static constexpr uint32_t RootWordBytes = 4;

  TP_KERNEL_INLINE uint32_t takeSlot() {
    const uint32_t Slot = Free;
    if (Slot != kNoSlot) {
      Free = parent(Slot);
      return Slot;
    }
    Unused += SlotBytes;
    return Unused - SlotBytes;
  }

  /// Whether there are at least \p Count free slots.
  bool hasFreeSlots(uint32_t Count) const {
    if (Unused + Count * SlotBytes <= End)
      return true;
    uint32_t Slot = Free;
    while (Count != 0 && Slot != kNoSlot) {
      Slot = parent(Slot);
      --Count;
    }
    return Count == 0;
  }

  /// Takes a slot for \p Reference, which the link at \p Word names, and hangs
  /// it there; returns its link.
  TP_KERNEL_INLINE CacheLink hang(uint32_t Word, BvhReference Reference,
                                  uint32_t Tag) {
    const uint32_t Slot = takeSlot();
    const CacheLink Link = Slot | Tag;
    setWord(Word, Link);
    setWord(Slot + Format::ParentOffset, Word);
    setWord(Slot + Format::SourceOffset, Reference);
    for (uint32_t Byte = 0; Byte != PolicyBytes; Byte += 4)
      setWord(Slot + Format::PolicyOffset + Byte, 0);
    rayEvent(RayEvent::SlotLoadFrom, Reference);
    rayEvent(RayEvent::SlotLoadParent, Word);
    rayEvent(RayEvent::SlotLoadInto, Link);
    return Link;
  }

  TP_KERNEL_INLINE CacheLink loadNode(const BvhMemory &From, uint32_t Word,
                                      BvhReference Node) {
    constexpr uint32_t Count = Format::NodeBytes / 4;
    const char *Source = From.Nodes + Node;
    const WordsInFlight<Count> Words([&](uint32_t Index) TP_LAMBDA_INLINE {
      return Source + size_t(4) * Index;
    });
    const CacheLink Link = hang(Word, Node, kInnerTag);
    char *Target = Memory.at(Link - kInnerTag);
    Words.store([&](uint32_t Index)
                    TP_LAMBDA_INLINE { return Target + size_t(4) * Index; });
    return Link;
  }

  /// Triangles that are loaded in one wait for memory, at most.
  static constexpr uint32_t MaxTogether = 6;
  static_assert(MaxTogether > Format::TrianglesPerSlot &&
                    MaxTogether % Format::TrianglesPerSlot == 0,
                "a part that is not the last one is full");

  /// Slots for so many triangles of a leaf.
  static constexpr uint32_t partCount(uint32_t Triangles) {
    return (Triangles + Format::TrianglesPerSlot - 1) /
           Format::TrianglesPerSlot;
  }

  /// Loads of \p Leaf, which has more than one part, as much as load()
  /// promises. Not inlined, because it takes all registers.
  [[gnu::noinline]] CacheLink loadParts(const BvhMemory &From, uint32_t Word,
                                        BvhReference Leaf) {
    const uint32_t Count =
        leafCount(Leaf) < MaxTogether ? leafCount(Leaf) : MaxTogether;
    if (!hasFreeSlots(partCount(Count)))
      return loadTriangles<Format::TrianglesPerSlot>(From, Word, Leaf);
    return loadUpTo<MaxTogether>(From, Word, Leaf, Count);
  }

  /// loadTriangles() of \p Count, at most \p Most, which fit into a slot.
  template <uint32_t Most>
  TP_KERNEL_INLINE CacheLink loadPart(const BvhMemory &From, uint32_t Word,
                                      BvhReference Leaf, uint32_t Count) {
    if constexpr (Most == 0) {
      const CacheLink Link = hang(Word, Leaf, kLeafTag);
      setWord(linkedSlot(Link) + Format::RestOffset, kNoRest);
      return Link;
    } else {
      if (Count != Most)
        return loadPart<Most - 1>(From, Word, Leaf, Count);
      return loadTriangles<Most>(From, Word, Leaf);
    }
  }

  /// The same of more than fit into a slot.
  template <uint32_t Most>
  TP_KERNEL_INLINE CacheLink loadUpTo(const BvhMemory &From, uint32_t Word,
                                      BvhReference Leaf, uint32_t Count) {
    if constexpr (Most > Format::TrianglesPerSlot + 1)
      if (Count != Most)
        return loadUpTo<Most - 1>(From, Word, Leaf, Count);
    return loadTriangles<Most>(From, Word, Leaf);
  }

  /// Loads the first \p Triangles of \p Leaf.
  template <uint32_t Triangles>
  TP_KERNEL_INLINE CacheLink loadTriangles(const BvhMemory &From, uint32_t Word,
                                           BvhReference Leaf);

  const SlotMemory Memory;
  const uint32_t End;
  uint32_t Unused = 0;
  uint32_t Free = kNoSlot;
};

template <class Format, uint32_t PolicyBytes>
template <uint32_t Triangles>
TP_KERNEL_INLINE CacheLink TreeCache<Format, PolicyBytes>::loadTriangles(
    const BvhMemory &From, uint32_t Word, BvhReference Leaf) {
  constexpr uint32_t PerSlot = Format::TrianglesPerSlot;
  constexpr uint32_t PerTriangle = kTriangleTestBytes / 4;
  const char *Records =
      reinterpret_cast<const char *>(From.Triangles + leafFirst(Leaf));
  const WordsInFlight<Triangles * PerTriangle> Words(
      [&](uint32_t Index) TP_LAMBDA_INLINE {
        return Records + Index / PerTriangle * sizeof(TriangleRecord) +
               size_t(4) * (Index % PerTriangle);
      });

  // Each part but the first hangs at the one before it.
  uint32_t Slots[partCount(Triangles)];
  for (uint32_t Part = 0; Part != partCount(Triangles); ++Part) {
    Slots[Part] = linkedSlot(hang(Word, Leaf, kLeafTag));
    Word = Slots[Part] + Format::RestOffset;
    Leaf =
        leafCount(Leaf) > PerSlot ? Leaf + (PerSlot << 4) - PerSlot : kNoRest;
    setWord(Word, Leaf);
  }
  Words.store([&](uint32_t Index) TP_LAMBDA_INLINE {
    constexpr uint32_t PerPart = PerSlot * PerTriangle;
    return Memory.at(Slots[Index / PerPart]) + size_t(4) * (Index % PerPart);
  });
  return leafLink(Slots[0]);
}

template <class Format, uint32_t PolicyBytes>
uint32_t TreeCache<Format, PolicyBytes>::unloadBranch(uint32_t Word) {
  rayEvent(RayEvent::DeletionBegin, Word);
  const SlotMemory Words = Memory;
  const CacheLink Top = Words.word(Word);
  Words.setWord(Word, Words.word(linkedSlot(Top) + Format::SourceOffset));
  // The branch in breadth-first order, a queue through Parent, which nobody
  // reads of a slot in it: the queue, once complete, becomes the free list's
  // start. Queued words are links, as childCount() needs them.
  uint32_t Count = 0;
  CacheLink Last = Top;
  for (CacheLink Link = Top;;) {
    const uint32_t Child = firstChildWord(Link);
    for (uint32_t Index = 0; Index != childCount(Link); ++Index) {
      const CacheLink ChildLink = Words.word(Child + Index * 4);
      if (!isLoaded(ChildLink))
        continue;
      Words.setWord(linkedSlot(Last) + Format::ParentOffset, ChildLink);
      Last = ChildLink;
    }
    ++Count;
    const uint32_t Slot = linkedSlot(Link);
    rayEvent(RayEvent::SlotFreed, Slot);
    if (Link == Last) {
      Words.setWord(Slot + Format::ParentOffset, Free);
      break;
    }
    Link = Words.word(Slot + Format::ParentOffset);
    Words.setWord(Slot + Format::ParentOffset, linkedSlot(Link));
  }
  Free = linkedSlot(Top);
  rayEvent(RayEvent::DeletionEnd, Count);
  return Count;
}

} // namespace tp

#endif // TP_KERNELS_TREECACHE_TREECACHE_H
