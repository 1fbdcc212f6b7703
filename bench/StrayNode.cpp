//===- StrayNode.cpp - A path tracer that writes into its tree ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The fault that bench/debugger.py looks for: one of the threads writes into a
// node of the tree that all of them read.
//
//===----------------------------------------------------------------------===//

#define main renderPicture
#include "kernels/pathtracer/PathTracer.cpp"
#undef main

#include "runtime/include/tp/thread.h"

static constexpr uint32_t GuiltyThread = 2345;
static constexpr uint32_t WrittenNode = 1000;

int main() {
  if (tp::threadId() == GuiltyThread) {
    const uint32_t Scene = tp::launchBlock().Scene;
    const auto *Header = reinterpret_cast<const tp::SceneHeader *>(Scene);
    auto *Nodes = reinterpret_cast<volatile tp::WideBvhNode *>(
        Scene + Header->NodesOffset);
    Nodes[WrittenNode].Reserved[0] = 1; // guilty
  }
  return renderPicture();
}
