//===- HighestBranch.h - Delete as much as possible, far away ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The final project report's policy. A policy of deletion has the members of
// HighestBranch.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_HIGHESTBRANCH_H
#define TP_KERNELS_TREECACHE_HIGHESTBRANCH_H

#include "kernels/common/Inline.h"
#include "kernels/treecache/CacheLink.h"
#include "kernels/treecache/SlotMemory.h"

namespace tp {

/// Deletes the highest loaded branch that is not on the current path.
class HighestBranch {
public:
  /// What each slot keeps for the policy, at SlotFormat::PolicyOffset.
  static constexpr uint32_t BytesPerSlot = 0;

  /// Called before each ray.
  TP_KERNEL_INLINE void beginRay() {}
  /// Called when the loaded \p Link is visited, also right after its load.
  template <class Cache>
  TP_KERNEL_INLINE void visit(Cache &, CacheLink /*Link*/) {}

  /// The word that names the branch to be unloaded so that what \p Word names
  /// can be loaded: none on the way from the root to \p Word. kNoWord if there
  /// is none.
  template <class Cache>
  uint32_t chooseBranch(const Cache &Slots, uint32_t Word) {
    const SlotMemory Words = Slots.memory();
    uint32_t Highest = kNoWord;
    for (uint32_t OnPath = Word; OnPath != kRootWord;) {
      const uint32_t Slot = Slots.slotOfWord(OnPath);
      const uint32_t SlotWord =
          Words.word(Slot + Cache::SlotFormat::ParentOffset);
      const CacheLink Link = Words.word(SlotWord);
      const uint32_t First = Slots.firstChildWord(Link);
      for (uint32_t Child = 0; Child != Slots.childCount(Link); ++Child) {
        const uint32_t Candidate = First + Child * 4;
        if (Candidate != OnPath && isLoaded(Words.word(Candidate)))
          Highest = Candidate;
      }
      OnPath = SlotWord;
    }
    return Highest;
  }
};

} // namespace tp

#endif // TP_KERNELS_TREECACHE_HIGHESTBRANCH_H
