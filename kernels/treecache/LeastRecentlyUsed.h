//===- LeastRecentlyUsed.h - Delete what no ray asked for lately -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_LEASTRECENTLYUSED_H
#define TP_KERNELS_TREECACHE_LEASTRECENTLYUSED_H

#include "kernels/common/Inline.h"
#include "kernels/treecache/CacheLink.h"

namespace tp {

/// A policy (as HighestBranch) that stamps each slot with the ray that visited
/// it last, and deletes a branch whose stamp is the oldest of a sample. A ray
/// visits a slot through those above, so that no stamp is older than one below
/// it: a branch is as old as its top, and what the ray is in the middle of is
/// never chosen.
class LeastRecentlyUsed {
public:
  /// The stamp.
  static constexpr uint32_t BytesPerSlot = 4;

  TP_KERNEL_INLINE void beginRay() { ++Ray; }
  template <class Cache>
  TP_KERNEL_INLINE void visit(Cache &Slots, CacheLink Link) {
    Slots.setWord(linkedSlot(Link) + Cache::SlotFormat::PolicyOffset, Ray);
  }

  template <class Cache>
  uint32_t chooseBranch(const Cache &Slots, uint32_t /*Word*/) {
    uint32_t Oldest = kNoSlot;
    uint32_t OldestAge = 0;
    // Looks on beyond the sample only for as long as it has found none.
    for (uint32_t Seen = 0;
         Seen < (OldestAge == 0 ? Slots.end() : SampleSize * Cache::SlotBytes);
         Seen += Cache::SlotBytes) {
      const uint32_t Age = age(Slots, Hand);
      if (Age > OldestAge) {
        Oldest = Hand;
        OldestAge = Age;
      }
      Hand += Cache::SlotBytes;
      if (Hand == Slots.end())
        Hand = 0;
    }
    if (Oldest == kNoSlot)
      return kNoWord;
    // With what is above, if that is of the same age.
    uint32_t Word = Slots.parent(Oldest);
    while (Word != kRootWord && age(Slots, Slots.slotOfWord(Word)) == OldestAge)
      Word = Slots.parent(Slots.slotOfWord(Word));
    return Word;
  }

private:
  static constexpr uint32_t SampleSize = 16;

  /// How many rays ago the slot was visited last.
  template <class Cache> uint32_t age(const Cache &Slots, uint32_t Slot) const {
    return Ray - Slots.word(Slot + Cache::SlotFormat::PolicyOffset);
  }

  uint32_t Ray = 0;
  /// The next slot to look at.
  uint32_t Hand = 0;
};

} // namespace tp

#endif // TP_KERNELS_TREECACHE_LEASTRECENTLYUSED_H
