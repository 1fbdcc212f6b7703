//===- TreeCacheVerifier.cpp - Is the cache part of the tree? -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/treecache/TreeCacheVerifier.h"

#include "kernels/treecache/CacheLink.h"

#include <stdio.h>

namespace tp {

static constexpr uint32_t WordBytes = sizeof(uint32_t);

static uint32_t wordAt(const char *Memory, uint32_t Offset) {
  uint32_t Word;
  __builtin_memcpy(&Word, __builtin_assume_aligned(Memory + Offset, 4),
                   sizeof(Word));
  return Word;
}

namespace {

/// A depth-first walk over the slots that climbs back along the Parent words,
/// each of which is verified on the way down.
class Walk {
public:
  Walk(const TreeCacheLayout &Layout, const TreeCacheState &State,
       const TreeCacheSource &Source, uint32_t *Scratch)
      : Layout(Layout), State(State), Source(Source),
        Reached(Scratch, State.SlotCount),
        Marked(Scratch + BitSet::wordCount(State.SlotCount), State.SlotCount) {}

  TreeCacheViolation run(const TreeCachePath *Path);

private:
  /// Each returns whether its rules are kept.
  bool verifyFreeList();
  bool verifyTree();
  bool verifyNothingLost();
  bool verifyPath(const TreeCachePath &Path);

  bool verifyUnloaded(uint32_t Word, uint32_t Value, uint32_t Expected);
  bool verifyLoaded(uint32_t Word, uint32_t Value, uint32_t Expected);
  bool verifyContents(uint32_t Slot, BvhReference Loaded);
  bool verifyWords(TreeCacheRule Rule, uint32_t Slot, uint32_t Begin,
                   uint32_t End, const void *Memory);

  /// What a slot was loaded from.
  BvhReference sourceOf(uint32_t Slot) const {
    return word(Slot * Layout.SlotBytes + Layout.SourceOffset);
  }
  uint32_t parentOf(uint32_t Slot) const {
    return word(Slot * Layout.SlotBytes + Layout.ParentOffset);
  }
  uint32_t word(uint32_t Offset) const { return wordAt(State.Slots, Offset); }
  uint32_t firstChildWord(uint32_t Slot) const;
  uint32_t lastChildWord(uint32_t Slot) const;
  bool isRestWord(uint32_t Word) const {
    return Word != kRootWord && isLeaf(sourceOf(Word / Layout.SlotBytes));
  }
  bool isReachedChildWord(uint32_t Word) const;
  uint32_t expectedAt(uint32_t Word) const;
  bool isUsedSlot(uint32_t Offset) const {
    return Offset % Layout.SlotBytes == 0 &&
           Offset / Layout.SlotBytes < State.UsedSlots;
  }

  bool fail(TreeCacheRule Rule, uint32_t Slot, uint32_t Word, uint32_t Value,
            uint32_t Expected) {
    Result = {Rule, Slot, Word, Value, Expected};
    return false;
  }
  /// At the word of that offset, or kRootWord.
  bool failAt(TreeCacheRule Rule, uint32_t Word, uint32_t Value,
              uint32_t Expected) {
    if (Word == kRootWord)
      return fail(Rule, TreeCacheViolation::NoSlot, 0, Value, Expected);
    return fail(Rule, Word / Layout.SlotBytes,
                Word % Layout.SlotBytes / WordBytes, Value, Expected);
  }

  bool failAtSource(uint32_t Slot, BvhReference Loaded) {
    return fail(TreeCacheRule::SourceInMemory, Slot,
                Layout.SourceOffset / WordBytes, Loaded, 0);
  }

  const TreeCacheLayout &Layout;
  const TreeCacheState &State;
  const TreeCacheSource &Source;
  BitSet Reached;
  /// The free slots, and later also those on the path, which are not free.
  BitSet Marked;
  TreeCacheViolation Result;
};

} // namespace

uint32_t Walk::firstChildWord(uint32_t Slot) const {
  return Slot * Layout.SlotBytes +
         (isLeaf(sourceOf(Slot)) ? Layout.RestOffset : Layout.ChildOffset);
}

uint32_t Walk::lastChildWord(uint32_t Slot) const {
  const uint32_t Words = isLeaf(sourceOf(Slot)) ? 1 : kWideBvhWidth;
  return firstChildWord(Slot) + (Words - 1) * WordBytes;
}

/// Whether the offset is that of a child word of a slot that is reached.
bool Walk::isReachedChildWord(uint32_t Word) const {
  const uint32_t Slot = Word / Layout.SlotBytes;
  return Slot < State.UsedSlots && Reached.contains(Slot) &&
         Word >= firstChildWord(Slot) && Word <= lastChildWord(Slot) &&
         Word % WordBytes == 0;
}

/// What memory has where the child word of a verified slot stands.
uint32_t Walk::expectedAt(uint32_t Word) const {
  if (Word == kRootWord)
    return Source.Root;
  const BvhReference Owner = sourceOf(Word / Layout.SlotBytes);
  if (isLeaf(Owner))
    return leafCount(Owner) > Layout.LeafTriangles
               ? leafReference(leafFirst(Owner) + Layout.LeafTriangles,
                               leafCount(Owner) - Layout.LeafTriangles)
               : kNoRest;
  return wordAt(Source.Nodes + Owner, Word % Layout.SlotBytes);
}

/// What the sets and the walk rely on.
static TreeCacheViolation verifySlots(const TreeCacheLayout &Layout,
                                      const TreeCacheState &State) {
  const uint32_t Room = State.Bytes / Layout.SlotBytes;
  if (State.SlotCount > Room)
    return {TreeCacheRule::SlotsInMemory, TreeCacheViolation::NoSlot, 0,
            State.SlotCount, Room};
  if (State.UsedSlots > State.SlotCount)
    return {TreeCacheRule::UsedSlots, TreeCacheViolation::NoSlot, 0,
            State.UsedSlots, State.SlotCount};
  return {};
}

bool Walk::verifyFreeList() {
  uint32_t Before = kRootWord;
  uint32_t Offset = State.FreeSlot;
  while (Offset != kNoSlot) {
    if (!isUsedSlot(Offset))
      return failAt(TreeCacheRule::FreeLink, Before, Offset, 0);
    const uint32_t Slot = Offset / Layout.SlotBytes;
    if (!Marked.insert(Slot))
      return failAt(TreeCacheRule::FreeListEnds, Before, Slot, 0);
    Before = Offset + Layout.ParentOffset;
    Offset = word(Before);
  }
  return true;
}

bool Walk::verifyTree() {
  uint32_t Word = kRootWord;
  for (;;) {
    const uint32_t Value = Word == kRootWord ? State.RootWord : word(Word);
    const uint32_t Expected = expectedAt(Word);
    if (isLoaded(Value)) {
      if (!verifyLoaded(Word, Value, Expected))
        return false;
      Word = firstChildWord(linkedSlot(Value) / Layout.SlotBytes);
      continue;
    }
    if (!verifyUnloaded(Word, Value, Expected))
      return false;
    while (Word != kRootWord && Word == lastChildWord(Word / Layout.SlotBytes))
      Word = parentOf(Word / Layout.SlotBytes);
    if (Word == kRootWord)
      return true;
    Word += WordBytes;
  }
}

bool Walk::verifyUnloaded(uint32_t Word, uint32_t Value, uint32_t Expected) {
  if (Value == Expected)
    return true;
  return failAt(isRestWord(Word) ? TreeCacheRule::LeafRest
                                 : TreeCacheRule::UnloadedLink,
                Word, Value, Expected);
}

bool Walk::verifyLoaded(uint32_t Word, uint32_t Value, uint32_t Expected) {
  const uint32_t Offset = linkedSlot(Value);
  if (!isUsedSlot(Offset))
    return failAt(TreeCacheRule::LoadedLink, Word, Value, Expected);
  if (Expected == kNoRest && isRestWord(Word))
    return failAt(TreeCacheRule::LeafRest, Word, Value, Expected);
  if (isLoadedLeaf(Value) != isLeaf(Expected))
    return failAt(TreeCacheRule::LinkKind, Word, Value, Expected);
  const uint32_t Slot = Offset / Layout.SlotBytes;
  if (Marked.contains(Slot))
    return failAt(TreeCacheRule::ReachedSlotFree, Word, Slot, 0);
  if (!Reached.insert(Slot))
    return failAt(TreeCacheRule::SlotOnce, Word, Slot, 0);
  if (parentOf(Slot) != Word)
    return fail(TreeCacheRule::ParentWord, Slot,
                Layout.ParentOffset / WordBytes, parentOf(Slot), Word);
  if (sourceOf(Slot) != Expected)
    return fail(TreeCacheRule::SourceWord, Slot,
                Layout.SourceOffset / WordBytes, sourceOf(Slot), Expected);
  return verifyContents(Slot, Expected);
}

/// Everything in the slot but its child words and header.
bool Walk::verifyContents(uint32_t Slot, BvhReference Loaded) {
  if (isLeaf(Loaded)) {
    const uint32_t First = leafFirst(Loaded), Count = leafCount(Loaded);
    if (First > Source.TriangleCount || Count > Source.TriangleCount - First)
      return failAtSource(Slot, Loaded);
    for (uint32_t Triangle = 0;
         Triangle != Count && Triangle != Layout.LeafTriangles; ++Triangle) {
      const uint32_t Begin = Triangle * Layout.TriangleBytes;
      if (!verifyWords(TreeCacheRule::TriangleWord, Slot, Begin,
                       Begin + Layout.TriangleBytes,
                       Source.Triangles + First + Triangle))
        return false;
    }
    return true;
  }
  if (Loaded % Layout.MemoryNodeBytes != 0 ||
      Loaded / Layout.MemoryNodeBytes >= Source.NodeCount)
    return failAtSource(Slot, Loaded);
  return verifyWords(TreeCacheRule::NodeWord, Slot, 0, Layout.ChildOffset,
                     Source.Nodes + Loaded);
}

/// Compares the bytes from \p Begin to \p End of a slot with \p Memory.
bool Walk::verifyWords(TreeCacheRule Rule, uint32_t Slot, uint32_t Begin,
                       uint32_t End, const void *Memory) {
  for (uint32_t At = Begin; At < End; At += WordBytes) {
    const uint32_t Value = word(Slot * Layout.SlotBytes + At);
    const uint32_t Expected =
        wordAt(static_cast<const char *>(Memory), At - Begin);
    if (Value != Expected)
      return fail(Rule, Slot, At / WordBytes, Value, Expected);
  }
  return true;
}

bool Walk::verifyNothingLost() {
  for (uint32_t Slot = 0; Slot != State.UsedSlots; ++Slot)
    if (!Reached.contains(Slot) && !Marked.contains(Slot))
      return fail(TreeCacheRule::SlotLost, Slot, 0, 0, 0);
  return true;
}

bool Walk::verifyPath(const TreeCachePath &Path) {
  if (Path.Word != kRootWord && !isReachedChildWord(Path.Word))
    return fail(TreeCacheRule::PathDeleted, TreeCacheViolation::NoSlot, 0,
                Path.Word, 0);
  for (uint32_t Word = Path.Word; Word != kRootWord;) {
    const uint32_t Slot = Word / Layout.SlotBytes;
    Marked.insert(Slot);
    Word = parentOf(Slot);
  }
  const uint32_t *Next = Path.Pending;
  for (uint32_t Entry = 0; Entry != Path.PendingCount; ++Entry) {
    const uint32_t Word = *Next;
    Next += Path.PendingStride;
    if (Word == kRootWord)
      continue;
    if (!isReachedChildWord(Word))
      return fail(TreeCacheRule::PendingDeleted, TreeCacheViolation::NoSlot, 0,
                  Word, Entry);
    if (!Marked.contains(Word / Layout.SlotBytes))
      return failAt(TreeCacheRule::PendingOffPath, Word, Entry, 0);
  }
  return true;
}

TreeCacheViolation Walk::run(const TreeCachePath *Path) {
  if (verifyFreeList() && verifyTree() && verifyNothingLost() && Path)
    verifyPath(*Path);
  return Result;
}

TreeCacheViolation verifyTreeCache(const TreeCacheLayout &Layout,
                                   const TreeCacheState &State,
                                   const TreeCacheSource &Source,
                                   const TreeCachePath *Path,
                                   uint32_t *Scratch) {
  TreeCacheViolation InMemory = verifySlots(Layout, State);
  if (!InMemory.isClean())
    return InMemory;
  return Walk(Layout, State, Source, Scratch).run(Path);
}

/// What is wrong: %u for the violation's value, %u for what was expected.
static const char *violationFormat(TreeCacheRule Rule) {
  switch (Rule) {
  case TreeCacheRule::None:
    break;
  case TreeCacheRule::SlotsInMemory:
    return "the cache has %u slots in memory for %u";
  case TreeCacheRule::UsedSlots:
    return "%u slots have been used of %u";
  case TreeCacheRule::FreeLink:
    return "the free list goes on at %u, where no used slot begins";
  case TreeCacheRule::FreeListEnds:
    return "the free list comes back to slot %u";
  case TreeCacheRule::LoadedLink:
    return "the link 0x%x names no used slot";
  case TreeCacheRule::LinkKind:
    return "the link 0x%x is of another kind than memory's reference 0x%x";
  case TreeCacheRule::UnloadedLink:
    return "0x%x is neither a link to a slot nor memory's reference 0x%x";
  case TreeCacheRule::LeafRest:
    return "0x%x stands where the rest of the leaf is 0x%x";
  case TreeCacheRule::ReachedSlotFree:
    return "slot %u is named here and is in the free list, too";
  case TreeCacheRule::SlotOnce:
    return "slot %u is named here and in another place";
  case TreeCacheRule::ParentWord:
    return "the parent is said to be the word at %u, and is the one at %u";
  case TreeCacheRule::SourceWord:
    return "the source is said to be 0x%x, and is 0x%x";
  case TreeCacheRule::SourceInMemory:
    return "the source 0x%x is not in memory";
  case TreeCacheRule::NodeWord:
    return "the node has 0x%x where memory has 0x%x";
  case TreeCacheRule::TriangleWord:
    return "the triangle has 0x%x where memory has 0x%x";
  case TreeCacheRule::SlotLost:
    return "the slot is neither free nor reached from the root";
  case TreeCacheRule::PathDeleted:
    return "the traversal stands at %u, which is no child word of the tree";
  case TreeCacheRule::PendingDeleted:
    return "the traversal is to go on at %u, which is no child word of the "
           "tree (entry %u of its stack)";
  case TreeCacheRule::PendingOffPath:
    return "entry %u of the traversal's stack is not on its path";
  }
  return "every rule is kept";
}

int describeViolation(const TreeCacheViolation &Violation, char *Buffer,
                      size_t Bytes) {
  char What[112];
  snprintf(What, sizeof(What), violationFormat(Violation.Rule), Violation.Value,
           Violation.Expected);
  switch (Violation.Rule) {
  case TreeCacheRule::None:
  case TreeCacheRule::SlotsInMemory:
  case TreeCacheRule::UsedSlots:
  case TreeCacheRule::PathDeleted:
  case TreeCacheRule::PendingDeleted:
    return snprintf(Buffer, Bytes, "%s", What);
  default:
    break;
  }
  if (Violation.Rule == TreeCacheRule::SlotLost)
    return snprintf(Buffer, Bytes, "slot %u: %s", Violation.Slot, What);
  const bool IsFree = Violation.Rule == TreeCacheRule::FreeLink ||
                      Violation.Rule == TreeCacheRule::FreeListEnds;
  if (Violation.Slot == TreeCacheViolation::NoSlot)
    return snprintf(Buffer, Bytes, "at the %s: %s",
                    IsFree ? "head of the free list" : "root", What);
  return snprintf(Buffer, Bytes, "word %u of slot %u: %s", Violation.Word,
                  Violation.Slot, What);
}

} // namespace tp
