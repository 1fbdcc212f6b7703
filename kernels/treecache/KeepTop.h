//===- KeepTop.h - Keep what was loaded first -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_KEEPTOP_H
#define TP_KERNELS_TREECACHE_KEEPTOP_H

#include "kernels/common/Inline.h"
#include "kernels/treecache/CacheLink.h"

namespace tp {

/// A policy (as HighestBranch) that deletes nothing: once the cache is full,
/// what is not in it is visited in memory.
class KeepTop {
public:
  static constexpr uint32_t BytesPerSlot = 0;

  TP_KERNEL_INLINE void beginRay() {}
  template <class Cache>
  TP_KERNEL_INLINE void visit(Cache &, CacheLink /*Link*/) {}
  template <class Cache>
  uint32_t chooseBranch(const Cache &, uint32_t /*Word*/) {
    return kNoWord;
  }
};

} // namespace tp

#endif // TP_KERNELS_TREECACHE_KEEPTOP_H
