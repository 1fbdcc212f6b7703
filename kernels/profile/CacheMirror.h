//===- CacheMirror.h - A thread's cache as its events tell it ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PROFILE_CACHEMIRROR_H
#define TP_KERNELS_PROFILE_CACHEMIRROR_H

#include "kernels/profile/RayProfile.h"
#include "kernels/treecache/CacheLink.h"

#include <optional>

namespace tp {

/// What an event says that cannot be after those before it, in words; null if
/// it can be.
using Contradiction = const char *;

/// The tree of slots of one thread, rebuilt from what the thread reports. Slots
/// go by their number.
class CacheMirror {
public:
  /// Slots that a mirror can have.
  static constexpr uint32_t MaxSlots = 0xFFFF;
  /// The number of no slot.
  static constexpr uint16_t None = 0xFFFF;

  struct Slot {
    enum Kind : uint8_t { Free, Inner, Leaf };
    /// What it was loaded from.
    BvhReference Source = 0;
    /// The slot above it; None for the root.
    uint16_t Parent = None;
    /// Which child of it.
    uint8_t Position = 0;
    Kind Is = Free;
    /// Slots between it and the root.
    uint16_t Depth = 0;
    /// The slots below it; of a leaf the first is the rest of its triangles.
    uint16_t Children[kWideBvhWidth] = {None, None, None, None};
  };

  /// An empty cache. \p Shape must be valid.
  explicit CacheMirror(const CacheShape &Shape);

  /// Why there can be no such cache.
  static Contradiction check(const CacheShape &Shape);

  const CacheShape &shape() const { return Shape; }
  const std::vector<Slot> &slots() const { return Slots; }
  uint32_t usedSlots() const { return Used; }
  bool isDeleting() const { return Top != None; }

  /// A node or a part of a leaf is loaded: the values of the three events.
  Contradiction load(BvhReference From, uint32_t ParentWord, CacheLink Into);
  /// What \p Link names is tested.
  Contradiction visit(CacheLink Link) const;
  /// The branch that the word at \p Word names is deleted, slot by slot.
  Contradiction beginDeletion(uint32_t Word);
  Contradiction freeSlot(uint32_t Offset);
  Contradiction endDeletion(uint32_t Count);

  /// The slot that a link names, which visit() or load() has accepted.
  uint16_t slotOf(CacheLink Link) const {
    return static_cast<uint16_t>(linkedSlot(Link) / Shape.SlotBytes);
  }
  /// Triangles in a slot with a part of a leaf.
  uint32_t trianglesIn(const Slot &S) const;
  /// What \p S, a part of a leaf, has in memory behind its triangles; kNoRest
  /// if nothing.
  BvhReference restOf(const Slot &S) const;
  /// All but the shape.
  template <class Archive> void serialize(Archive &A) {
    A(Slots);
    A(Root);
    A(Used);
    A(Top);
    A(ToFree);
    A(Freed);
  }

  /// The slots from the root to the one that holds the word at \p Word; none
  /// for the root word or a word that is in no slot in use.
  std::vector<uint16_t> pathTo(uint32_t Word) const;

private:
  /// A pointer to a slot.
  struct Place {
    uint16_t Slot;
    uint8_t Position;
  };

  /// The number of the slot at \p Offset, if there is one.
  std::optional<uint16_t> slotAt(uint32_t Offset) const;
  /// Which pointer the word at \p Word is, if it is one of a slot in use.
  std::optional<Place> placeOf(uint32_t Word) const;
  /// The variable that holds what the word at \p Word names; null if the word
  /// is none.
  uint16_t *pointerAt(uint32_t Word);
  uint32_t branchSize(uint16_t Branch) const;
  bool isInDeletedBranch(uint16_t Number) const;

  CacheShape Shape;
  std::vector<Slot> Slots;
  uint16_t Root = None;
  uint32_t Used = 0;
  /// The top of the branch that is being deleted, how many slots it has and how
  /// many of them have been freed.
  uint16_t Top = None;
  uint32_t ToFree = 0;
  uint32_t Freed = 0;
};

} // namespace tp

#endif // TP_KERNELS_PROFILE_CACHEMIRROR_H
