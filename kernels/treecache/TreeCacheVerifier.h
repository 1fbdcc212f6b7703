//===- TreeCacheVerifier.h - Is the cache part of the tree? -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiles for the host and for the TP: the caller gives all memory. Trusts
// nothing that it reads: any bytes get a verdict.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_TREECACHEVERIFIER_H
#define TP_KERNELS_TREECACHE_TREECACHEVERIFIER_H

#include "kernels/common/BitSet.h"
#include "kernels/common/SceneLayout.h"

#include <stddef.h>
#include <stdint.h>

namespace tp {

/// What every cache must keep, in the order in which it is verified.
/// describeViolation() says each as a sentence.
enum class TreeCacheRule : uint8_t {
  /// Not a rule: nothing is broken.
  None,
  /// All slots lie in the cache's memory.
  SlotsInMemory,
  /// No more slots have been used than there are.
  UsedSlots,
  /// A link of the free list names a slot that has been used.
  FreeLink,
  /// The free list does not come back to one of its slots.
  FreeListEnds,
  /// A loaded link names a slot that has been used.
  LoadedLink,
  /// A link to a leaf stands where memory has a leaf, another one where it has
  /// a node.
  LinkKind,
  /// Any other child word is the reference that memory has there.
  UnloadedLink,
  /// The child word of a leaf slot is the leaf's remaining triangles, or a link
  /// to the slot of the first of them.
  LeafRest,
  /// No slot is both free and reached from the root.
  ReachedSlotFree,
  /// No slot is reached twice.
  SlotOnce,
  /// A slot's Parent is the offset of the child word that names the slot.
  ParentWord,
  /// A slot's Source is the reference that memory has where the slot hangs.
  SourceWord,
  /// Memory has what the slot was loaded from.
  SourceInMemory,
  /// The words of a node are those of memory.
  NodeWord,
  /// The words of a leaf's triangles are those of memory.
  TriangleWord,
  /// Every used slot is free or reached.
  SlotLost,
  /// The traversal's current child word is one of a slot that is reached.
  PathDeleted,
  /// So is the child word of every pending entry of the traversal's stack.
  PendingDeleted,
  /// And it belongs to a slot on the way from the root to the current word.
  PendingOffPath,
};

/// How a cache cuts its memory into slots. All figures are bytes and multiples
/// of 4; offsets are from the start of a slot.
struct TreeCacheLayout {
  uint32_t SlotBytes;
  uint32_t ParentOffset;
  uint32_t SourceOffset;
  /// From one node to the next in memory.
  uint32_t MemoryNodeBytes;
  /// The kWideBvhWidth child words of a node, which end what a slot keeps of it
  /// from its start.
  uint32_t ChildOffset;
  /// Words of a triangle that a slot keeps, from the start of its record; those
  /// of a leaf slot follow each other from its start.
  uint32_t TriangleBytes;
  /// Triangles of a leaf that one slot keeps. This one is a number.
  uint32_t LeafTriangles;
  /// The child word of a leaf slot.
  uint32_t RestOffset;
};

/// A cache. Offsets of slots and words are bytes from Slots; see CacheLink.h.
struct TreeCacheState {
  /// At a multiple of 4.
  const char *Slots;
  /// How much memory there is at Slots.
  uint32_t Bytes;
  uint32_t SlotCount;
  /// Slots that have ever been used: the first ones.
  uint32_t UsedSlots;
  /// The first slot of the free list, whose links are Parent words, or kNoSlot.
  uint32_t FreeSlot;
  /// The word that names the tree's root.
  uint32_t RootWord;
};

/// What the cache holds a part of.
struct TreeCacheSource {
  const char *Nodes;
  uint32_t NodeCount;
  const TriangleRecord *Triangles;
  uint32_t TriangleCount;
  BvhReference Root;
};

/// What a traversal relies on. Words are given by their offsets in the cache,
/// as Parent does.
struct TreeCachePath {
  /// The child word that the traversal follows, or kRootWord.
  uint32_t Word;
  /// The child words of the stack's pending entries; one every PendingStride
  /// words.
  const uint32_t *Pending;
  uint32_t PendingStride;
  uint32_t PendingCount;
};

/// Which rule is broken, and where.
struct TreeCacheViolation {
  /// Not a slot: the word at the root, or the cache as a whole.
  static constexpr uint32_t NoSlot = 0xFFFFFFFFu;

  TreeCacheRule Rule = TreeCacheRule::None;
  /// Number of the slot at fault, or whose word is.
  uint32_t Slot = NoSlot;
  /// Number of that word in the slot.
  uint32_t Word = 0;
  /// What is there, and what should be.
  uint32_t Value = 0;
  uint32_t Expected = 0;

  bool isClean() const { return Rule == TreeCacheRule::None; }
};

/// Words of scratch memory that a verifier of a cache of so many slots needs.
constexpr uint32_t treeCacheVerifierWords(uint32_t SlotCount) {
  return 2 * BitSet::wordCount(SlotCount);
}

/// The first violation of a rule; of \p Path's rules only if \p Path is not
/// null. \p Scratch has treeCacheVerifierWords(SlotCount) words. Follows the
/// tree without a stack, so that no depth is too deep.
TreeCacheViolation verifyTreeCache(const TreeCacheLayout &Layout,
                                   const TreeCacheState &State,
                                   const TreeCacheSource &Source,
                                   const TreeCachePath *Path,
                                   uint32_t *Scratch);

/// Writes the violation as a sentence without a full stop into \p Buffer, which
/// holds \p Bytes, and returns the length that it has in full.
int describeViolation(const TreeCacheViolation &Violation, char *Buffer,
                      size_t Bytes);

} // namespace tp

#endif // TP_KERNELS_TREECACHE_TREECACHEVERIFIER_H
