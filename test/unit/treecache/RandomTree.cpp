//===- RandomTree.cpp - Scenes with trees of every shape ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "RandomTree.h"

#include "kernels/bvh/BoundingBox.h"
#include "kernels/bvh/QuantizedBvh.h"
#include "kernels/common/SceneFlattener.h"

#include <algorithm>
#include <cstring>

namespace tp {

namespace {

constexpr float HalfSide = 10;

float uniform(std::mt19937 &Generator, float Lower, float Upper) {
  return std::uniform_real_distribution<float>(Lower, Upper)(Generator);
}

Vector3 randomVector(std::mt19937 &Generator, float Side) {
  const float X = uniform(Generator, -Side, Side);
  const float Y = uniform(Generator, -Side, Side);
  return {X, Y, uniform(Generator, -Side, Side)};
}

uint32_t upTo(std::mt19937 &Generator, uint32_t Largest) {
  return std::uniform_int_distribution<uint32_t>(1, Largest)(Generator);
}

Scene randomTriangles(uint32_t Count, std::mt19937 &Generator) {
  Scene Result;
  Result.Materials.resize(1);
  for (uint32_t Number = 0; Number != Count; ++Number) {
    const Vector3 Vertex = randomVector(Generator, HalfSide - 3);
    Result.Triangles.push_back({{Vertex, Vertex + randomVector(Generator, 3),
                                 Vertex + randomVector(Generator, 3)},
                                0});
  }
  return Result;
}

/// Grows a tree of a shape.
class Grower {
public:
  Grower(TreeShape Shape, std::mt19937 &Generator)
      : Shape(Shape), Generator(Generator) {}

  BvhReference grow(uint32_t First, uint32_t Count, uint32_t Depth);

  std::vector<WideBvhNode> Nodes;
  /// Inner nodes on the longest way so far.
  uint32_t LargestDepth = 0;

private:
  bool endsWithLeaf(uint32_t Count, uint32_t Depth);
  std::vector<uint32_t> split(uint32_t Count);
  BoundingBox randomBox();

  const TreeShape Shape;
  std::mt19937 &Generator;
};

} // namespace

bool Grower::endsWithLeaf(uint32_t Count, uint32_t Depth) {
  if (Count > kMaxLeafTriangles)
    return false;
  switch (Shape) {
  case TreeShape::Chain:
    return Count < kWideBvhWidth || Depth == kMaxBvhDepth;
  case TreeShape::Mixed:
    return Count == 1 || Depth == kMaxBvhDepth || Generator() % 3 == 0;
  default:
    return true;
  }
}

/// The sizes of the subtrees over so many triangles, at least two of them.
std::vector<uint32_t> Grower::split(uint32_t Count) {
  std::vector<uint32_t> Sizes;
  uint32_t Left = Count;
  for (uint32_t Children = upTo(Generator, kWideBvhWidth - 1); Children != 0;
       --Children) {
    if (Left == 1)
      break;
    uint32_t Size = upTo(Generator, Left - 1);
    if (Shape == TreeShape::Chain)
      Size = 1;
    else if (Shape == TreeShape::LongLeaves)
      Size = std::min(Left - 1, kMaxLeafTriangles);
    Sizes.push_back(Size);
    Left -= Size;
  }
  Sizes.push_back(Left);
  std::shuffle(Sizes.begin(), Sizes.end(), Generator);
  return Sizes;
}

/// Most are so large that many rays go on.
BoundingBox Grower::randomBox() {
  const Vector3 All = {HalfSide, HalfSide, HalfSide};
  BoundingBox Box = {-All, All};
  if (Generator() % 2 == 0) {
    Box = BoundingBox();
    for (int Corner = 0; Corner != 3; ++Corner)
      Box.extend(randomVector(Generator, HalfSide));
  }
  return Box;
}

BvhReference Grower::grow(uint32_t First, uint32_t Count, uint32_t Depth) {
  if (endsWithLeaf(Count, Depth))
    return leafReference(First, Count);
  const size_t Number = Nodes.size();
  Nodes.emplace_back();
  LargestDepth = std::max(LargestDepth, Depth + 1);
  const std::vector<uint32_t> Sizes = split(Count);
  for (uint32_t Slot = 0; Slot != kWideBvhWidth; ++Slot) {
    BoundingBox Box;
    if (Slot < Sizes.size()) {
      const BvhReference Child = grow(First, Sizes[Slot], Depth + 1);
      Nodes[Number].Child[Slot] = Child;
      First += Sizes[Slot];
      Box = randomBox();
    }
    for (unsigned Axis = 0; Axis != 3; ++Axis) {
      Nodes[Number].Bounds[Axis][0][Slot] = component(Box.Lower, Axis);
      Nodes[Number].Bounds[Axis][1][Slot] = component(Box.Upper, Axis);
    }
  }
  return BvhReference(Number * sizeof(WideBvhNode));
}

/// Replaces the tree in a flattened scene.
static void setTree(std::vector<uint8_t> &Bytes, BvhReference Root,
                    const std::vector<WideBvhNode> &Nodes, uint32_t Depth) {
  std::vector<QuantizedBvhNode> Quantized(Nodes.size());
  quantizeBvh(
      {Nodes.data(), uint32_t(Nodes.size()), 4 * HalfSide, Quantized.data()});
  auto Append = [&](const void *Data, size_t Size) {
    const size_t Offset = (Bytes.size() + kSceneAlignment - 1) /
                          kSceneAlignment * kSceneAlignment;
    Bytes.resize(Offset + Size);
    if (Size != 0)
      std::memcpy(Bytes.data() + Offset, Data, Size);
    return uint32_t(Offset);
  };
  SceneHeader Header;
  std::memcpy(&Header, Bytes.data(), sizeof(Header));
  Header.Root = Root;
  Header.BvhDepth = Depth;
  Header.NodeCount = uint32_t(Nodes.size());
  Header.NodesOffset = Append(Nodes.data(), Nodes.size() * sizeof(Nodes[0]));
  Header.QuantizedNodesOffset =
      Append(Quantized.data(), Quantized.size() * sizeof(Quantized[0]));
  Header.ByteCount = uint32_t(Bytes.size());
  std::memcpy(Bytes.data(), &Header, sizeof(Header));
}

RandomTree::RandomTree(TreeShape Shape, uint32_t TriangleCount, uint32_t Seed) {
  std::mt19937 Generator(Seed);
  std::vector<uint8_t> Bytes =
      flattenScene(randomTriangles(TriangleCount, Generator));
  if (Shape == TreeShape::Empty) {
    setTree(Bytes, kNoBvh, {}, 0);
  } else if (Shape != TreeShape::Built) {
    Grower Tree(Shape, Generator);
    const BvhReference Root = Tree.grow(0, TriangleCount, 0);
    setTree(Bytes, Root, Tree.Nodes, Tree.LargestDepth);
  }
  Block.reset(static_cast<uint8_t *>(
      ::operator new(Bytes.size(), std::align_val_t(kSceneAlignment))));
  std::memcpy(Block.get(), Bytes.data(), Bytes.size());
}

Vector3 RandomRays::vector(float Side) { return randomVector(Generator, Side); }

Ray RandomRays::next() {
  if (once(2)) {
    Last.Origin = Last.Origin + vector(0.1f);
    Last.Direction = Last.Direction + vector(0.05f);
  } else {
    Last = {vector(HalfSide + 2), vector(1)};
  }
  return Last;
}

} // namespace tp
