//===- SlotMemory.h - The words of a cache ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_SLOTMEMORY_H
#define TP_KERNELS_TREECACHE_SLOTMEMORY_H

#include "kernels/common/Inline.h"

#include <stdint.h>

namespace tp {

/// A word of the cache, which may be of any type.
using CacheWord [[gnu::may_alias]] = uint32_t;

/// The memory of a cache, in which offsets in bytes from the first slot say
/// where things are. A traversal keeps a copy of this, which stays in a
/// register.
class SlotMemory {
public:
  /// The first slot is at \p Base.
  explicit SlotMemory(char *Base) : Base(Base) {}

  TP_KERNEL_INLINE char *at(uint32_t Offset) const {
    // The word that names the root lies before the first slot; and on the host
    // pointers have more bits.
    return Base + static_cast<int32_t>(Offset);
  }
  TP_KERNEL_INLINE uint32_t word(uint32_t Offset) const {
    return *reinterpret_cast<const CacheWord *>(at(Offset));
  }
  TP_KERNEL_INLINE void setWord(uint32_t Offset, uint32_t Value) const {
    *reinterpret_cast<CacheWord *>(at(Offset)) = Value;
  }

private:
  char *Base;
};

} // namespace tp

#endif // TP_KERNELS_TREECACHE_SLOTMEMORY_H
