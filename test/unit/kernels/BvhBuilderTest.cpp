//===- BvhBuilderTest.cpp - Invariants of every tree ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/BvhBuilder.h"
#include "kernels/bvh/WideBvh.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

using namespace tp;

namespace {

struct Tree {
  std::vector<BoundingBox> Boxes;
  std::vector<uint32_t> Order;
  std::vector<BvhNode> Nodes;
  BvhReference Root = 0;
};

} // namespace

static Tree build(std::vector<BoundingBox> Boxes) {
  Tree Result;
  const uint32_t Count = uint32_t(Boxes.size());
  Result.Boxes = std::move(Boxes);
  Result.Order.resize(Count);
  Result.Nodes.resize(Count - 1);
  BvhStorage Storage{Result.Boxes.data(), Count, Result.Order.data(),
                     Result.Nodes.data(), 0};
  Result.Root = buildBvh(Storage);
  EXPECT_LE(Storage.NodeCount, Count - 1);
  Result.Nodes.resize(Storage.NodeCount);
  return Result;
}

static bool contains(const BoundingBox &Outer, const BoundingBox &Inner) {
  return Outer.Lower.X <= Inner.Lower.X && Outer.Lower.Y <= Inner.Lower.Y &&
         Outer.Lower.Z <= Inner.Lower.Z && Outer.Upper.X >= Inner.Upper.X &&
         Outer.Upper.Y >= Inner.Upper.Y && Outer.Upper.Z >= Inner.Upper.Z;
}

static bool equal(const BoundingBox &A, const BoundingBox &B) {
  return contains(A, B) && contains(B, A);
}

/// Checks the subtree and returns the exact box of its primitives.
static BoundingBox check(const Tree &T, BvhReference Reference, uint32_t Depth,
                         uint32_t &NextPrimitive, uint32_t &VisitedNodes) {
  BoundingBox Box;
  if (isLeaf(Reference)) {
    // Leaves lie in the order in which a depth-first walk meets them.
    EXPECT_EQ(leafFirst(Reference), NextPrimitive);
    EXPECT_GE(leafCount(Reference), 1u);
    for (uint32_t I = 0; I != leafCount(Reference); ++I)
      Box.extend(T.Boxes[T.Order[NextPrimitive++]]);
    return Box;
  }
  EXPECT_LT(Depth, kMaxBvhDepth);
  ++VisitedNodes;
  const BvhNode &Node = T.Nodes.at(Reference);
  for (unsigned Child = 0; Child != 2; ++Child) {
    const BoundingBox Inside =
        check(T, Node.Child[Child], Depth + 1, NextPrimitive, VisitedNodes);
    EXPECT_TRUE(equal(Node.Boxes[Child], Inside));
    Box.extend(Inside);
  }
  return Box;
}

/// Checks the subtree of the wide tree and returns the box of its primitives.
static BoundingBox checkWide(const Tree &T,
                             const std::vector<WideBvhNode> &Nodes,
                             BvhReference Reference, uint32_t Depth,
                             std::vector<unsigned> &Found) {
  BoundingBox Box;
  if (isLeaf(Reference)) {
    for (uint32_t I = 0; I != leafCount(Reference); ++I) {
      const uint32_t Position = leafFirst(Reference) + I;
      ++Found.at(Position);
      Box.extend(T.Boxes[T.Order[Position]]);
    }
    return Box;
  }
  EXPECT_LT(Depth, kMaxBvhDepth);
  EXPECT_EQ(Reference % sizeof(WideBvhNode), 0u);
  const WideBvhNode &Node = Nodes.at(Reference / sizeof(WideBvhNode));
  unsigned Children = 0;
  for (unsigned Slot = 0; Slot != kWideBvhWidth; ++Slot) {
    auto Side = [&](unsigned Which) {
      return Vector3{Node.Bounds[0][Which][Slot], Node.Bounds[1][Which][Slot],
                     Node.Bounds[2][Which][Slot]};
    };
    const BoundingBox SlotBox = {Side(0), Side(1)};
    if (SlotBox.Lower.X > SlotBox.Upper.X) {
      EXPECT_TRUE(equal(SlotBox, BoundingBox())) << "an empty slot";
      continue;
    }
    ++Children;
    const BoundingBox Inside =
        checkWide(T, Nodes, Node.Child[Slot], Depth + 1, Found);
    EXPECT_TRUE(equal(SlotBox, Inside));
    Box.extend(Inside);
  }
  EXPECT_GE(Children, 2u);
  return Box;
}

static void expectValidWhenWide(const Tree &T) {
  std::vector<WideBvhNode> WideNodes(T.Nodes.size());
  WideBvhStorage Storage{T.Nodes.data(), WideNodes.data(), 0};
  const BvhReference Root = widenBvh(Storage, T.Root);
  ASSERT_LE(Storage.WideNodeCount, T.Nodes.size());
  WideNodes.resize(Storage.WideNodeCount);
  std::vector<unsigned> Found(T.Boxes.size());
  checkWide(T, WideNodes, Root, 0, Found);
  EXPECT_EQ(Found, std::vector<unsigned>(T.Boxes.size(), 1));
}

static float surface(const BvhNode &Node) {
  BoundingBox Box = Node.Boxes[0];
  Box.extend(Node.Boxes[1]);
  return Box.halfArea();
}

/// The least sum of surfaces of the wide nodes for a subtree whose parent has
/// \p Slots slots for it, by trying everything.
static float leastSurface(const Tree &T, BvhReference Subtree, uint32_t Slots) {
  if (isLeaf(Subtree))
    return 0;
  const BvhNode &Node = T.Nodes[Subtree];
  auto SplitInto = [&](uint32_t Count) {
    float Best = 3e38f;
    for (uint32_t Left = 1; Left < Count; ++Left)
      Best = std::min(Best, leastSurface(T, Node.Child[0], Left) +
                                leastSurface(T, Node.Child[1], Count - Left));
    return Best;
  };
  return std::min(surface(Node) + SplitInto(kWideBvhWidth), SplitInto(Slots));
}

static BoundingBox childBox(const WideBvhNode &Node, unsigned Slot) {
  const auto &Bounds = Node.Bounds;
  return {{Bounds[0][0][Slot], Bounds[1][0][Slot], Bounds[2][0][Slot]},
          {Bounds[0][1][Slot], Bounds[1][1][Slot], Bounds[2][1][Slot]}};
}

/// The surfaces of the nodes of the wide tree.
static float wideSurface(const Tree &T) {
  std::vector<WideBvhNode> WideNodes(T.Nodes.size());
  WideBvhStorage Storage{T.Nodes.data(), WideNodes.data(), 0};
  widenBvh(Storage, T.Root);
  WideNodes.resize(Storage.WideNodeCount);
  float Sum = 0;
  for (const WideBvhNode &Node : WideNodes) {
    BoundingBox Box;
    for (unsigned Slot = 0; Slot != kWideBvhWidth; ++Slot)
      Box.extend(childBox(Node, Slot));
    Sum += Box.halfArea();
  }
  return Sum;
}

static void expectValid(const Tree &T) {
  uint32_t NextPrimitive = 0, VisitedNodes = 0;
  check(T, T.Root, 0, NextPrimitive, VisitedNodes);
  EXPECT_EQ(NextPrimitive, T.Boxes.size());
  EXPECT_EQ(VisitedNodes, T.Nodes.size());
  std::vector<uint32_t> Sorted = T.Order;
  std::sort(Sorted.begin(), Sorted.end());
  for (uint32_t I = 0; I != Sorted.size(); ++I)
    ASSERT_EQ(Sorted[I], I) << "a permutation holds every primitive once";
  expectValidWhenWide(T);
}

/// The expected cost of a ray that hits the root's box, by the surface area
/// heuristic.
static double expectedCost(const Tree &T, BvhReference Reference,
                           const BvhCosts &Costs) {
  if (isLeaf(Reference))
    return Costs.Triangle * leafCount(Reference);
  const BvhNode &Node = T.Nodes[Reference];
  BoundingBox Box = Node.Boxes[0];
  Box.extend(Node.Boxes[1]);
  double Cost = Costs.Node;
  for (unsigned Child = 0; Child != 2; ++Child)
    Cost += Node.Boxes[Child].halfArea() / Box.halfArea() *
            expectedCost(T, Node.Child[Child], Costs);
  return Cost;
}

static std::vector<BoundingBox> randomBoxes(uint32_t Count, float Size) {
  std::mt19937 Generator(Count);
  std::uniform_real_distribution<float> Position(-100, 100), Extent(0, Size);
  std::vector<BoundingBox> Boxes;
  for (uint32_t I = 0; I != Count; ++I) {
    const Vector3 Lower = {Position(Generator), Position(Generator),
                           Position(Generator)};
    const Vector3 Upper = Lower + Vector3{Extent(Generator), Extent(Generator),
                                          Extent(Generator)};
    Boxes.push_back({Lower, Upper});
  }
  return Boxes;
}

TEST(BvhBuilder, OnePrimitiveIsALeaf) {
  const Tree T = build(randomBoxes(1, 1));
  EXPECT_EQ(T.Root, leafReference(0, 1));
  EXPECT_TRUE(T.Nodes.empty());
}

TEST(BvhBuilder, TreesOfEverySmallSizeAreValid) {
  for (uint32_t Count = 1; Count != 200; ++Count)
    expectValid(build(randomBoxes(Count, 30)));
}

TEST(WideBvh, MostNodesOfALargeTreeAreFull) {
  const Tree T = build(randomBoxes(50000, 2));
  std::vector<WideBvhNode> WideNodes(T.Nodes.size());
  WideBvhStorage Storage{T.Nodes.data(), WideNodes.data(), 0};
  widenBvh(Storage, T.Root);
  EXPECT_LT(Storage.WideNodeCount, T.Nodes.size() * 0.55);
}

TEST(BvhBuilder, LargeTreeIsValid) {
  expectValid(build(randomBoxes(50000, 2)));
}

TEST(BvhBuilder, EqualBoxesMakeABalancedTree) {
  for (uint32_t Count : {2u, 15u, 16u, 31u, 1000u})
    expectValid(build(
        std::vector<BoundingBox>(Count, BoundingBox{{1, 2, 3}, {4, 5, 6}})));
}

TEST(BvhBuilder, PointsLinesAndPlanesAreValid) {
  std::vector<BoundingBox> Points, Line, Plane;
  for (int I = 0; I != 300; ++I) {
    const Vector3 OnLine = {float(I), 0, 0};
    const int Column = I % 17, Row = I / 17;
    const Vector3 OnPlane = {float(Column), 5, float(Row)};
    Points.push_back({{7, 7, 7}, {7, 7, 7}});
    Line.push_back({OnLine, OnLine});
    Plane.push_back({OnPlane, OnPlane + Vector3{1, 0, 1}});
  }
  expectValid(build(Points));
  expectValid(build(Line));
  expectValid(build(Plane));
}

/// Each split would take one box off: without a bound on the depth the tree
/// would be thousands of levels deep.
TEST(BvhBuilder, ExponentialSizesKeepTheDepthBound) {
  std::vector<BoundingBox> Boxes;
  for (int I = 0; I != 4000; ++I) {
    const float Position = std::ldexp(1.0f, -(I % 120)) * (I < 2000 ? 1 : -1);
    Boxes.push_back({{Position, Position, Position},
                     {Position * 1.0001f, Position * 1.0001f, Position}});
    if (Boxes.back().Lower.X > Boxes.back().Upper.X)
      std::swap(Boxes.back().Lower, Boxes.back().Upper);
  }
  expectValid(build(Boxes));
}

TEST(BvhBuilder, HugeAndTinyCoordinatesAreValid) {
  std::vector<BoundingBox> Boxes = randomBoxes(500, 10);
  for (size_t I = 0; I != Boxes.size(); ++I) {
    const float Scale = I % 2 ? 1e16f : 1e-25f;
    Boxes[I] = {Boxes[I].Lower * Scale, Boxes[I].Upper * Scale};
  }
  expectValid(build(Boxes));
}

/// Centres on a regular tiling lie on the boundaries of bins: the input on
/// which inconsistent rounding loses triangles.
TEST(BvhBuilder, RegularTilingIsValid) {
  std::vector<BoundingBox> Boxes;
  for (int X = 0; X != 64; ++X)
    for (int Y = 0; Y != 64; ++Y) {
      const Vector3 Corner = {X * 0.3f, Y * 0.3f, 0};
      Boxes.push_back({Corner, Corner + Vector3{0.3f, 0.3f, 0}});
    }
  expectValid(build(Boxes));
}

TEST(BvhBuilder, BuildsTheSameTreeTwice) {
  const Tree A = build(randomBoxes(3000, 5)), B = build(randomBoxes(3000, 5));
  EXPECT_EQ(A.Order, B.Order);
  EXPECT_EQ(A.Root, B.Root);
}

TEST(BvhBuilder, HeuristicBeatsMedianSplits) {
  // A dense cluster in a sparse field: where to cut matters.
  std::vector<BoundingBox> Boxes = randomBoxes(1000, 1);
  for (size_t I = 0; I != 500; ++I)
    Boxes[I] = {Boxes[I].Lower * 0.01f, Boxes[I].Lower * 0.01f};
  const Tree Heuristic = build(Boxes);

  // A median tree over the same order has the cost of cuts in the middle.
  struct Median {
    const Tree &T;
    BvhCosts Costs;
    BoundingBox Box;
    double cost(uint32_t Begin, uint32_t End, BoundingBox &Bounds) {
      for (uint32_t I = Begin; I != End; ++I)
        Bounds.extend(T.Boxes[T.Order[I]]);
      if (End - Begin <= 2)
        return Costs.Triangle * float(End - Begin);
      const uint32_t Middle = (Begin + End) / 2;
      BoundingBox Left, Right;
      const double LeftCost = cost(Begin, Middle, Left);
      const double RightCost = cost(Middle, End, Right);
      return Costs.Node +
             (Left.halfArea() * LeftCost + Right.halfArea() * RightCost) /
                 Bounds.halfArea();
    }
  };
  BoundingBox Bounds;
  const double MedianCost =
      Median{Heuristic, {}, {}}.cost(0, uint32_t(Boxes.size()), Bounds);
  EXPECT_LT(expectedCost(Heuristic, Heuristic.Root, {}), MedianCost * 0.9);
}

TEST(WideBvh, ChildrenComeByTheirSurface) {
  const Tree T = build(randomBoxes(500, 30));
  std::vector<WideBvhNode> WideNodes(T.Nodes.size());
  WideBvhStorage Storage{T.Nodes.data(), WideNodes.data(), 0};
  widenBvh(Storage, T.Root);
  WideNodes.resize(Storage.WideNodeCount);
  for (const WideBvhNode &Node : WideNodes)
    for (unsigned Slot = 1; Slot != kWideBvhWidth && Node.Child[Slot]; ++Slot)
      EXPECT_LE(childBox(Node, Slot).halfArea(),
                childBox(Node, Slot - 1).halfArea());
}

TEST(WideBvh, HasTheLeastSurface) {
  for (uint32_t Count : {5u, 9u, 14u, 24u}) {
    const Tree T = build(randomBoxes(Count, 30));
    const float Least = leastSurface(T, T.Root, 1);
    EXPECT_NEAR(wideSurface(T), Least, Least * 1e-5f);
  }
}
