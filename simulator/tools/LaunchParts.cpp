//===- LaunchParts.cpp - What a program finds at its start ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/LaunchParts.h"

#include "kernels/bvh/BoundingBox.h"
#include "kernels/bvh/BvhBuilder.h"
#include "kernels/common/SceneLayout.h"

#include <algorithm>

namespace tp {

template <class T>
static T readAt(const RunSetup &Loaded, DeviceAddress Address) {
  T Value;
  Loaded.Launch.read(Address, &Value, sizeof(Value));
  return Value;
}

/// The arrays of a BvhWorkspace.
static void addWorkspace(const RunSetup &Loaded, DeviceAddress Scene,
                         const SceneHeader &Header,
                         std::vector<LaunchPart> &Parts) {
  const DeviceAddress At = Scene + Header.WorkspaceOffset;
  const auto Workspace = readAt<BvhWorkspace>(Loaded, At);
  const uint64_t Count = Header.TriangleCount;
  Parts.push_back({At, sizeof(Workspace), "the workspace for the tree"});
  Parts.push_back({Scene + Workspace.SourcesOffset,
                   Count * sizeof(TriangleRecord), "the source triangles"});
  Parts.push_back({Scene + Workspace.BoxesOffset, Count * sizeof(BoundingBox),
                   "the triangles' boxes"});
  Parts.push_back({Scene + Workspace.OrderOffset, Count * sizeof(uint32_t),
                   "the triangles' order"});
  Parts.push_back({Scene + Workspace.BinaryNodesOffset,
                   (Count - 1) * sizeof(BvhNode), "the binary tree"});
}

static void addScene(const RunSetup &Loaded, DeviceAddress Scene,
                     std::vector<LaunchPart> &Parts) {
  const auto Header = readAt<SceneHeader>(Loaded, Scene);
  const uint64_t Lights = std::max(Header.LightCount, 1u);
  // A kernel that builds the tree has room for as many as there can be.
  const uint64_t Nodes =
      Header.WorkspaceOffset != 0 ? Header.TriangleCount - 1 : Header.NodeCount;
  Parts.push_back({Scene, sizeof(Header), "the scene's header"});
  Parts.push_back({Scene + Header.NodesOffset, Nodes * sizeof(WideBvhNode),
                   "the scene's nodes"});
  if (Header.QuantizedNodesOffset != 0)
    Parts.push_back({Scene + Header.QuantizedNodesOffset,
                     Nodes * sizeof(QuantizedBvhNode),
                     "the scene's quantized nodes"});
  Parts.push_back({Scene + Header.TrianglesOffset,
                   uint64_t(Header.TriangleCount) * sizeof(TriangleRecord),
                   "the scene's triangles"});
  Parts.push_back({Scene + Header.MaterialsOffset,
                   uint64_t(Header.MaterialCount) * sizeof(MaterialRecord),
                   "the scene's materials"});
  Parts.push_back({Scene + Header.LightsOffset, Lights * sizeof(LightRecord),
                   "the scene's lights"});
  Parts.push_back({Scene + Header.LightChoicesOffset,
                   Lights * sizeof(LightChoice), "the choice of lights"});
  if (Header.WorkspaceOffset != 0)
    addWorkspace(Loaded, Scene, Header, Parts);
}

std::vector<LaunchPart> launchParts(const RunSetup &Loaded) {
  const LaunchBlock &Block = Loaded.Block;
  std::vector<LaunchPart> Parts;
  if (Block.Scene) {
    addScene(Loaded, Block.Scene, Parts);
    Parts.push_back({Block.Framebuffer,
                     uint64_t(Block.Width) * Block.Height * sizeof(uint32_t),
                     "the framebuffer"});
    Parts.push_back({Block.RayCounts,
                     uint64_t(Loaded.ThreadCount) * sizeof(uint32_t),
                     "the ray counts"});
    Parts.push_back({Block.WorkCounter, sizeof(uint32_t), "the work counter"});
  }
  if (Block.Arguments) {
    const auto Strings = readAt<DeviceAddress>(Loaded, Block.Arguments);
    Parts.push_back({Strings, Block.Arguments - Strings, "the arguments"});
    Parts.push_back({Block.Arguments,
                     (uint64_t(Block.ArgumentCount) + 1) * sizeof(uint32_t),
                     "argv"});
  }
  std::sort(Parts.begin(), Parts.end(),
            [](const LaunchPart &A, const LaunchPart &B) {
              return A.Address < B.Address;
            });
  return Parts;
}

} // namespace tp
