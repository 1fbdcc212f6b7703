//===- CacheLink.h - What a child word in the cache names -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A child word of a slot is a link:
//   node in memory:   its BvhReference, lowest two bits 0
//   leaf in memory:   its leaf reference, highest bit 1
//   node in a slot:   the slot's offset | 1
//   leaf in a slot:   the slot's offset | 3
// so that a link whose target is not loaded is the very word that memory holds.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_CACHELINK_H
#define TP_KERNELS_TREECACHE_CACHELINK_H

#include "kernels/common/SceneLayout.h"

#include <stdint.h>

namespace tp {

using CacheLink = uint32_t;

/// What the lowest bits add to the offset of a slot, for an inner node and for
/// a part of a leaf.
inline constexpr uint32_t kInnerTag = 1;
inline constexpr uint32_t kLeafTag = 3;

/// The offset of the word that names the root: right before the first slot.
inline constexpr uint32_t kRootWord = 0xFFFFFFFCu;

/// The offset of no slot.
inline constexpr uint32_t kNoSlot = 0xFFFFFFFFu;

/// The offset of no word.
inline constexpr uint32_t kNoWord = 0xFFFFFFFFu;

/// The link of a leaf's last part to the rest of the leaf.
inline constexpr CacheLink kNoRest = 0;

constexpr CacheLink innerLink(uint32_t Slot) { return Slot | kInnerTag; }
constexpr CacheLink leafLink(uint32_t Slot) { return Slot | kLeafTag; }

/// Whether \p Link names a slot.
constexpr bool isLoaded(CacheLink Link) {
  return !isLeaf(Link) && (Link & 1) != 0;
}
/// Whether \p Link names an inner node in a slot.
constexpr bool isLoadedInner(CacheLink Link) {
  return (Link & 0x80000003u) == kInnerTag;
}
/// Whether \p Link, which names a slot, names a part of a leaf.
constexpr bool isLoadedLeaf(CacheLink Link) { return (Link & 2) != 0; }
/// The offset of the slot that \p Link names.
constexpr uint32_t linkedSlot(CacheLink Link) { return Link & ~3u; }

} // namespace tp

#endif // TP_KERNELS_TREECACHE_CACHELINK_H
