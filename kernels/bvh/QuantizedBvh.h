//===- QuantizedBvh.h - From full nodes to quantized ones -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiles for the host and for the TP: the caller gives all memory.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_QUANTIZEDBVH_H
#define TP_KERNELS_BVH_QUANTIZEDBVH_H

#include "kernels/common/SceneLayout.h"

#include <stdint.h>

namespace tp {

/// The reference to the quantized node, or the leaf, that \p Reference names
/// among the full nodes.
constexpr BvhReference quantizedReference(BvhReference Reference) {
  constexpr uint32_t Ratio = sizeof(WideBvhNode) / sizeof(QuantizedBvhNode);
  return isLeaf(Reference) ? Reference : Reference / Ratio;
}

/// What quantizeBvh() reads and writes.
struct QuantizedBvhStorage {
  const WideBvhNode *Nodes;
  uint32_t NodeCount;
  /// No smaller than the magnitude of any coordinate of a box or of a ray's
  /// origin.
  float LargestCoordinate;
  /// Room for NodeCount nodes.
  QuantizedBvhNode *QuantizedNodes;
};

/// Makes the quantized nodes, in the order of the full ones. For every ray from
/// within LargestCoordinate, QuantizedBoxTester's Enter is no larger and Leave
/// no smaller than RayBoxTester's, rounding errors of both included.
void quantizeBvh(const QuantizedBvhStorage &Storage);

} // namespace tp

#endif // TP_KERNELS_BVH_QUANTIZEDBVH_H
