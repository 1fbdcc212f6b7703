//===- BuiltBvh.cpp - The tree that a kernel built ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/BuiltBvh.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <memory>

namespace tp {

namespace {

/// The scene's block in the kernel's memory.
class SceneReader {
public:
  SceneReader(const LaunchBlock &Launch, const LaunchMemory &Memory)
      : Begin(Launch.Scene), Memory(Memory),
        Header(read<SceneHeader>(0, 1).front()) {}

  /// The array of \p Count elements at \p Offset of the block.
  template <typename T>
  std::vector<T> read(uint32_t Offset, uint32_t Count) const {
    std::vector<T> Elements(Count);
    if (Count != 0)
      Memory.read(Begin + Offset, Elements.data(), Count * sizeof(T));
    return Elements;
  }
  /// Whether the block has room for that.
  template <typename T> bool holds(uint32_t Offset, uint32_t Count) const {
    return Offset <= Header.ByteCount &&
           Count <= (Header.ByteCount - Offset) / sizeof(T);
  }
  const SceneHeader &header() const { return Header; }

private:
  const DeviceAddress Begin;
  const LaunchMemory &Memory;
  const SceneHeader Header;
};

} // namespace

/// Whether the kernel has left the places of all arrays as they were.
static bool isIntact(const SceneReader &Reader) {
  const SceneHeader &Header = Reader.header();
  const uint32_t Count = Header.TriangleCount;
  if (Header.Version != kSceneVersion || Count == 0 ||
      Header.WorkspaceOffset == 0 ||
      !Reader.holds<BvhWorkspace>(Header.WorkspaceOffset, 1))
    return false;
  const auto Workspace =
      Reader.read<BvhWorkspace>(Header.WorkspaceOffset, 1).front();
  return Reader.holds<WideBvhNode>(Header.NodesOffset, Count - 1) &&
         Reader.holds<TriangleRecord>(Header.TrianglesOffset, Count) &&
         Reader.holds<TriangleRecord>(Workspace.SourcesOffset, Count) &&
         Reader.holds<BoundingBox>(Workspace.BoxesOffset, Count) &&
         Reader.holds<uint32_t>(Workspace.OrderOffset, Count) &&
         Reader.holds<BvhNode>(Workspace.BinaryNodesOffset, Count - 1);
}

/// Whether the kernel has put each triangle where its order says.
static bool areTrianglesInOrder(const SceneReader &Reader,
                                const BvhWorkspace &Workspace,
                                const std::vector<uint32_t> &Order) {
  const uint32_t Count = Reader.header().TriangleCount;
  // Bits and not floats: a NaN equals itself.
  using Words = std::array<uint32_t, sizeof(TriangleRecord) / sizeof(uint32_t)>;
  const auto Sources = Reader.read<Words>(Workspace.SourcesOffset, Count);
  const auto Triangles =
      Reader.read<Words>(Reader.header().TrianglesOffset, Count);
  for (uint32_t Position = 0; Position != Count; ++Position)
    if (Order[Position] < Count &&
        Triangles[Position] != Sources[Order[Position]])
      return false;
  return true;
}

ErrorOr<BuiltBvh> readBuiltBvh(const LaunchBlock &Launch,
                               const LaunchMemory &Memory) {
  const SceneReader Reader(Launch, Memory);
  const SceneHeader &Header = Reader.header();
  if (!isIntact(Reader))
    return Error{"the kernel has overwritten the header of its scene"};
  if (Header.Root == kNoBvh)
    return Error{
        "the kernel has built no BVH, which --bvh kernel leaves to it"};
  const auto Workspace =
      Reader.read<BvhWorkspace>(Header.WorkspaceOffset, 1).front();
  const uint32_t Count = Header.TriangleCount;
  if (Workspace.BinaryNodeCount >= Count || Header.NodeCount >= Count)
    return Error{
        "the BVH that the kernel built has " +
        std::to_string(std::max(Workspace.BinaryNodeCount, Header.NodeCount)) +
        " nodes, more than " + std::to_string(Count) + " triangles can have"};
  BuiltBvh Tree;
  Tree.Boxes = Reader.read<BoundingBox>(Workspace.BoxesOffset, Count);
  Tree.Order = Reader.read<uint32_t>(Workspace.OrderOffset, Count);
  Tree.Nodes = Reader.read<BvhNode>(Workspace.BinaryNodesOffset,
                                    Workspace.BinaryNodeCount);
  Tree.Root = Workspace.BinaryRoot;
  Tree.WideNodes =
      Reader.read<WideBvhNode>(Header.NodesOffset, Header.NodeCount);
  Tree.WideRoot = Header.Root;
  if (!areTrianglesInOrder(Reader, Workspace, Tree.Order))
    return Error{"the kernel has not put the triangles in the order of the "
                 "BVH that it built"};
  return Tree;
}

static Error brokenTree(const char *Kind, const BvhFindings &Findings) {
  char Sentence[160];
  describeViolation(Findings.First, Sentence, sizeof(Sentence));
  return Error{std::string("the ") + Kind +
               " BVH that the kernel built is broken: " + Sentence + " (" +
               std::to_string(Findings.LostPrimitives) + " triangles lost, " +
               std::to_string(Findings.RepeatedPrimitives) + " repeated)"};
}

ErrorOr<BvhSummary> verifyBuiltBvh(const BuiltBvh &Tree) {
  const uint32_t Count = uint32_t(Tree.Boxes.size());
  // The verifier only reads; the structures are those of the builder, which
  // writes.
  std::vector<uint32_t> Order = Tree.Order;
  std::vector<BvhNode> Nodes = Tree.Nodes;
  std::vector<WideBvhNode> WideNodes = Tree.WideNodes;
  const BvhStorage Storage{Tree.Boxes.data(), Count, Order.data(), Nodes.data(),
                           uint32_t(Nodes.size())};
  const WideBvhStorage WideStorage{Nodes.data(), WideNodes.data(),
                                   uint32_t(WideNodes.size())};
  std::vector<uint32_t> Scratch(bvhVerifierWords(Count, Count));
  BvhSummary Summary;
  Summary.Binary = verifyBvh(Storage, Tree.Root, Scratch.data());
  if (!Summary.Binary.isClean())
    return brokenTree("binary", Summary.Binary);
  Summary.Wide =
      verifyWideBvh(Storage, WideStorage, Tree.WideRoot, Scratch.data());
  if (!Summary.Wide.isClean())
    return brokenTree("wide", Summary.Wide);
  return Summary;
}

std::string describeBuiltBvh(const BuiltBvh &Tree, const BvhSummary &Summary) {
  char Line[200];
  std::snprintf(Line, sizeof(Line),
                "BVH of the kernel: %zu triangles, %zu nodes (%zu wide), "
                "%" PRIu32 " leaves, depth %" PRIu32 " (%" PRIu32 " wide), "
                "cost %.6g",
                Tree.Boxes.size(), Tree.Nodes.size(), Tree.WideNodes.size(),
                Summary.Binary.LeafCount, Summary.Binary.Depth,
                Summary.Wide.Depth, Summary.Binary.Cost);
  return Line;
}

namespace {

struct FileCloser {
  void operator()(std::FILE *File) const { std::fclose(File); }
};

} // namespace

template <typename T>
static void writeElements(std::FILE *File, const std::vector<T> &Elements) {
  const uint32_t Count = uint32_t(Elements.size());
  std::fwrite(&Count, sizeof(Count), 1, File);
  std::fwrite(Elements.data(), sizeof(T), Count, File);
}

Status writeBuiltBvh(const std::string &Path, const BuiltBvh &Tree) {
  const auto Failure = [&] {
    return Error{Path + ": " + std::strerror(errno)};
  };
  const std::unique_ptr<std::FILE, FileCloser> File(
      std::fopen(Path.c_str(), "wb"));
  if (!File)
    return Failure();
  writeElements(File.get(),
                std::vector<BvhReference>{Tree.Root, Tree.WideRoot});
  writeElements(File.get(), Tree.Order);
  writeElements(File.get(), Tree.Nodes);
  writeElements(File.get(), Tree.WideNodes);
  if (std::fflush(File.get()) != 0 || std::ferror(File.get()))
    return Failure();
  return success();
}

ErrorOr<std::string> checkBuiltBvh(const LaunchBlock &Launch,
                                   const LaunchMemory &Memory,
                                   const std::string &Path) {
  ErrorOr<BuiltBvh> Tree = readBuiltBvh(Launch, Memory);
  if (!Tree)
    return Tree.takeError();
  if (!Path.empty())
    if (Status Written = writeBuiltBvh(Path, *Tree); !Written)
      return Written.takeError();
  ErrorOr<BvhSummary> Summary = verifyBuiltBvh(*Tree);
  if (!Summary)
    return Summary.takeError();
  return describeBuiltBvh(*Tree, *Summary);
}

} // namespace tp
