//===- SceneBvh.cpp - Building a scene's tree in place --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvhbuilder/SceneBvh.h"

#include "kernels/bvh/BvhBuilder.h"
#include "kernels/bvh/WideBvh.h"
#include "kernels/common/SceneLayout.h"
#include "tp/barrier.h"
#include "tp/thread.h"

#include <stdio.h>

namespace tp {

namespace {

/// The arrays of a scene and of its workspace, to be written.
struct BuildView {
  SceneHeader *Header;
  BvhWorkspace *Workspace;

  explicit BuildView(void *SceneBlock)
      : Header(static_cast<SceneHeader *>(SceneBlock)),
        Workspace(at<BvhWorkspace>(Header->WorkspaceOffset)) {}

  template <typename T> T *at(uint32_t Offset) const {
    return reinterpret_cast<T *>(reinterpret_cast<char *>(Header) + Offset);
  }
};

} // namespace

static void buildTrees(const BuildView &View) {
  SceneHeader &Header = *View.Header;
  BvhWorkspace &Workspace = *View.Workspace;
  BvhStorage Storage{View.at<const BoundingBox>(Workspace.BoxesOffset),
                     Header.TriangleCount,
                     View.at<uint32_t>(Workspace.OrderOffset),
                     View.at<BvhNode>(Workspace.BinaryNodesOffset), 0};
  Workspace.BinaryRoot = buildBvh(Storage);
  Workspace.BinaryNodeCount = Storage.NodeCount;
  WideBvhStorage Wide{Storage.Nodes, View.at<WideBvhNode>(Header.NodesOffset),
                      0};
  Header.Root = widenBvh(Wide, Workspace.BinaryRoot);
  Header.NodeCount = Wide.WideNodeCount;
  Header.BvhDepth = Wide.Depth;
}

/// Copies this thread's share of the triangles to their places in the order of
/// the tree.
static void placeTriangles(const BuildView &View) {
  const auto *Order = View.at<const uint32_t>(View.Workspace->OrderOffset);
  const auto *Sources =
      View.at<const TriangleRecord>(View.Workspace->SourcesOffset);
  auto *Triangles = View.at<TriangleRecord>(View.Header->TrianglesOffset);
  const uint32_t Count = View.Header->TriangleCount;
  const uint32_t Step = threadCount();
  for (uint32_t Position = threadId(); Position < Count; Position += Step)
    Triangles[Position] = Sources[Order[Position]];
}

bool buildSceneBvh(void *SceneBlock) {
  const bool IsFirst = threadId() == 0;
  const BuildView View(SceneBlock);
  if (View.Header->WorkspaceOffset == 0) {
    if (IsFirst)
      fprintf(stderr, "error: the host has built the scene's BVH; leave it to "
                      "the kernel with --bvh kernel\n");
    return false;
  }
  // The builder is serial: its numbering of the nodes depends on nothing else.
  if (IsFirst)
    buildTrees(View);
  barrier();
  placeTriangles(View);
  barrier();
  return true;
}

} // namespace tp
