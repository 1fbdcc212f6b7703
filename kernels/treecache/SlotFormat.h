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

/// Slots for nodes of \p NodeFormat (as FullNodes), of which they keep the
/// first \p Bytes, and for leaf parts of up to \p Triangles triangles.
template <class NodeFormat, uint32_t Bytes, uint32_t Triangles>
struct SlotFormat {
  using Nodes = NodeFormat;
  static constexpr uint32_t NodeBytes = Bytes;
  static constexpr uint32_t TrianglesPerSlot = Triangles;

  // Offsets in bytes from the start of a slot.
  static constexpr uint32_t ChildOffset = Nodes::ChildOffset;
  static constexpr uint32_t RestOffset = Triangles * kTriangleTestBytes;
  static constexpr uint32_t ParentOffset = NodeBytes;
  static constexpr uint32_t SourceOffset = NodeBytes + 4;
  static constexpr uint32_t PolicyOffset = NodeBytes + 8;

  static_assert(ChildOffset + kWideBvhWidth * 4 <= NodeBytes &&
                    RestOffset + 4 <= NodeBytes && NodeBytes % 4 == 0,
                "a slot holds a node's links and a leaf's triangles");
};

/// Nodes with float boxes; 120 bytes without the policy's.
using FullSlots = SlotFormat<FullNodes, 112, 2>;
/// Nodes with quantized boxes; 64 bytes without the policy's.
using QuantizedSlots = SlotFormat<QuantizedNodes, 56, 1>;

} // namespace tp

#endif // TP_KERNELS_TREECACHE_SLOTFORMAT_H
