//===- BrokenPolicies.h - Deletions that must be caught ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_TREECACHE_INPUTS_BROKENPOLICIES_H
#define TP_TEST_TREECACHE_INPUTS_BROKENPOLICIES_H

#include "kernels/treecache/HighestBranch.h"

namespace tp {

/// Deletes what the traversal stands in: all.
class DeletesPath : public HighestBranch {
public:
  template <class Cache> uint32_t chooseBranch(const Cache &, uint32_t) {
    return kRootWord;
  }
};

/// Unlinks a branch before it deletes another: its slots are lost.
class LosesSlots : public HighestBranch {
public:
  template <class Cache> uint32_t chooseBranch(Cache &Slots, uint32_t Word) {
    const uint32_t Lost = HighestBranch::chooseBranch(Slots, Word);
    if (Lost == kNoWord)
      return kNoWord;
    Slots.setWord(Lost, Slots.source(linkedSlot(Slots.word(Lost))));
    return HighestBranch::chooseBranch(Slots, Word);
  }
};

/// Marks the slots that it visits in their contents.
class SpoilsContents : public HighestBranch {
public:
  template <class Cache> void visit(Cache &Slots, CacheLink Link) {
    const uint32_t Last = Cache::SlotFormat::ChildOffset - sizeof(uint32_t);
    if (!isLoadedLeaf(Link))
      Slots.setWord(linkedSlot(Link) + Last, 0);
  }
};

} // namespace tp

#endif // TP_TEST_TREECACHE_INPUTS_BROKENPOLICIES_H
