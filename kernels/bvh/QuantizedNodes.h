//===- QuantizedNodes.h - The quantized format of nodes ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_QUANTIZEDNODES_H
#define TP_KERNELS_BVH_QUANTIZEDNODES_H

#include "kernels/bvh/QuantizedBoxTester.h"
#include "kernels/bvh/QuantizedBvh.h"
#include "tp/thread.h"

#include <stdio.h>
#include <stdlib.h>

namespace tp {

/// The scene's QuantizedBvhNodes, as FullNodes of BvhTraversal.h are its full
/// ones.
struct QuantizedNodes {
  static constexpr uint32_t NodeBytes = sizeof(QuantizedBvhNode);
  static constexpr uint32_t ChildOffset =
      __builtin_offsetof(QuantizedBvhNode, Child);
  using BoxTester = QuantizedBoxTester;

  /// Ends the program with a message if the scene has none.
  static const char *nodes(const SceneView &Scene) {
    if (!Scene.QuantizedNodes) {
      if (threadId() == 0)
        fputs("error: the scene has no quantized nodes, which this "
              "kernel wants; let the host build the BVH (--bvh host) "
              "or compile it for full nodes\n",
              stderr);
      exit(1);
    }
    return Scene.QuantizedNodes;
  }
  static BvhReference root(const SceneView &Scene) {
    return quantizedReference(Scene.Header->Root);
  }
};

} // namespace tp

#endif // TP_KERNELS_BVH_QUANTIZEDNODES_H
