//===- SlotFormat.h - What a slot of the cache holds ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A slot holds an inner node or a part of a leaf, and behind it a header:
//
//   inner node:  the node's bytes as in memory; its four child words are links
//   leaf:        the words of its first triangles that a test needs
//                a link to the rest of the leaf, or kNoRest
//   header:      Parent: offset of the word that names this slot
//                Source: the BvhReference that it was loaded from
//                what the policy keeps
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_SLOTFORMAT_H
#define TP_KERNELS_TREECACHE_SLOTFORMAT_H

#include "kernels/bvh/BvhTraversal.h"
#include "kernels/bvh/QuantizedNodes.h"
#include "kernels/common/SceneLayout.h"

#include <stdint.h>

namespace tp {

/// Bytes of a TriangleRecord that a test reads.
inline constexpr uint32_t kTriangleTestBytes =
    __builtin_offsetof(TriangleRecord, UnitNormal);

/// Slots for nodes of \p NodeFormat (as FullNodes) and for leaf parts of up to
/// \p Triangles triangles.
template <class NodeFormat, uint32_t Triangles> struct SlotFormat {
  using Nodes = NodeFormat;
  /// What is kept of a node: all up to its last reference.
  static constexpr uint32_t NodeBytes =
      Nodes::ChildOffset +
      kWideBvhWidth * static_cast<uint32_t>(sizeof(BvhReference));
  static constexpr uint32_t TrianglesPerSlot = Triangles;

  // Offsets in bytes from the start of a slot.
  static constexpr uint32_t ChildOffset = Nodes::ChildOffset;
  static constexpr uint32_t RestOffset = Triangles * kTriangleTestBytes;
  static constexpr uint32_t ParentOffset =
      NodeBytes > RestOffset + 4 ? NodeBytes : RestOffset + 4;
  static constexpr uint32_t SourceOffset = ParentOffset + 4;
  static constexpr uint32_t PolicyOffset = ParentOffset + 8;
};

/// Nodes with float boxes; 120 bytes without the policy's.
using FullSlots = SlotFormat<FullNodes, 2>;
/// Nodes with quantized boxes; 84 bytes without the policy's. Most leaves have
/// two triangles: two slots for them would wait for memory twice.
using QuantizedSlots = SlotFormat<QuantizedNodes, 2>;

} // namespace tp

#endif // TP_KERNELS_TREECACHE_SLOTFORMAT_H
