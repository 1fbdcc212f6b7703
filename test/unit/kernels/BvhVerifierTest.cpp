//===- BvhVerifierTest.cpp - A seeded fault for each rule -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/BvhVerifier.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace tp;

namespace {

/// Both trees over a grid of cubes.
struct Trees {
  std::vector<BoundingBox> Boxes;
  std::vector<uint32_t> Order;
  std::vector<BvhNode> Nodes;
  std::vector<WideBvhNode> WideNodes;
  BvhReference Root = 0;
  BvhReference WideRoot = 0;
  uint32_t WideDepth = 0;

  Trees();

  BvhFindings verifyBinary(const BvhLimits &Limits = BvhLimits()) {
    const BvhStorage Storage = storage();
    std::vector<uint32_t> Scratch(
        bvhVerifierWords(Storage.PrimitiveCount, Storage.NodeCount));
    return verifyBvh(Storage, Root, Scratch.data(), BvhCosts(), Limits);
  }
  BvhFindings verifyWide(const BvhLimits &Limits = BvhLimits()) {
    const WideBvhStorage Wide{Nodes.data(), WideNodes.data(),
                              uint32_t(WideNodes.size())};
    std::vector<uint32_t> Scratch(
        bvhVerifierWords(uint32_t(Boxes.size()), Wide.WideNodeCount));
    return verifyWideBvh(storage(), Wide, WideRoot, Scratch.data(), BvhCosts(),
                         Limits);
  }

  /// The node and child of some reference to a leaf.
  BvhReference &someLeaf() {
    for (BvhNode &Node : Nodes)
      for (BvhReference &Child : Node.Child)
        if (isLeaf(Child))
          return Child;
    ADD_FAILURE() << "a tree has leaves";
    return Root;
  }

private:
  BvhStorage storage() {
    return {Boxes.data(), uint32_t(Boxes.size()), Order.data(), Nodes.data(),
            uint32_t(Nodes.size())};
  }
};

} // namespace

Trees::Trees() {
  for (int X = 0; X != 10; ++X)
    for (int Y = 0; Y != 10; ++Y)
      for (int Z = 0; Z != 5; ++Z) {
        const Vector3 Corner = {float(3 * X), float(3 * Y), float(3 * Z)};
        Boxes.push_back({Corner, Corner + Vector3{1, 1, 1}});
      }
  Order.resize(Boxes.size());
  Nodes.resize(Boxes.size() - 1);
  BvhStorage Storage = storage();
  Root = buildBvh(Storage);
  Nodes.resize(Storage.NodeCount);
  WideNodes.resize(Nodes.size());
  WideBvhStorage Wide{Nodes.data(), WideNodes.data(), 0};
  WideRoot = widenBvh(Wide, Root);
  WideNodes.resize(Wide.WideNodeCount);
  WideDepth = Wide.Depth;
}

static std::string describe(const BvhFindings &Findings) {
  char Sentence[160];
  describeViolation(Findings.First, Sentence, sizeof(Sentence));
  return Sentence;
}

static void expectRule(const BvhFindings &Findings, BvhRule Rule) {
  EXPECT_EQ(Findings.First.Rule, Rule) << describe(Findings);
}

TEST(BvhVerifier, BuiltTreesAreClean) {
  Trees T;
  const BvhFindings Binary = T.verifyBinary(), Wide = T.verifyWide();
  EXPECT_TRUE(Binary.isClean()) << describe(Binary);
  EXPECT_TRUE(Wide.isClean()) << describe(Wide);
  EXPECT_EQ(describe(Binary), "every rule is kept");
  EXPECT_EQ(Binary.LeafCount, T.Nodes.size() + 1);
  EXPECT_EQ(Wide.LeafCount, Binary.LeafCount);
  EXPECT_LT(Wide.Depth, Binary.Depth);
  EXPECT_EQ(T.WideDepth, Wide.Depth);
  EXPECT_EQ(Binary.LostPrimitives + Binary.RepeatedPrimitives, 0u);
}

/// Two unit cubes, two apart, in two leaves: the cost by hand.
TEST(BvhVerifier, CostIsThatOfTheHeuristic) {
  const BoundingBox Boxes[2] = {{{0, 0, 0}, {1, 1, 1}}, {{3, 0, 0}, {4, 1, 1}}};
  uint32_t Order[2] = {0, 1};
  BvhNode Node = {{Boxes[0], Boxes[1]},
                  {leafReference(0, 1), leafReference(1, 1)}};
  uint32_t Scratch[bvhVerifierWords(2, 1)];
  const BvhFindings Findings =
      verifyBvh({Boxes, 2, Order, &Node, 1}, 0, Scratch, {10, 7});
  EXPECT_TRUE(Findings.isClean()) << describe(Findings);
  EXPECT_DOUBLE_EQ(Findings.Cost, 10 + 2 * 7 * 3.0 / 9.0);
  EXPECT_EQ(Findings.Depth, 1u);
  EXPECT_EQ(Findings.LeafCount, 2u);
}

TEST(BvhVerifier, FindsReferencesOutOfRange) {
  Trees T;
  T.someLeaf() = uint32_t(T.Nodes.size());
  expectRule(T.verifyBinary(), BvhRule::ReferenceInRange);
  T.WideNodes[0].Child[0] = 64;
  expectRule(T.verifyWide(), BvhRule::ReferenceInRange);
  T.WideRoot = uint32_t(T.WideNodes.size() * sizeof(WideBvhNode));
  expectRule(T.verifyWide(), BvhRule::ReferenceInRange);
}

TEST(BvhVerifier, FindsNodesReachedTwice) {
  Trees T;
  T.someLeaf() = T.Root;
  expectRule(T.verifyBinary(), BvhRule::NodeOnce);
}

TEST(BvhVerifier, FindsNodesThatAreNotReached) {
  Trees T;
  T.Nodes.push_back(T.Nodes.back());
  expectRule(T.verifyBinary(), BvhRule::NodeReached);
  EXPECT_EQ(describe(T.verifyBinary()), "node " +
                                            std::to_string(T.Nodes.size() - 1) +
                                            " is not reached from the root");
}

TEST(BvhVerifier, FindsPathsThatAreTooLong) {
  Trees T;
  BvhLimits Limits;
  Limits.Depth = T.verifyBinary().Depth;
  EXPECT_TRUE(T.verifyBinary(Limits).isClean());
  --Limits.Depth;
  expectRule(T.verifyBinary(Limits), BvhRule::Depth);
}

TEST(BvhVerifier, FindsWideNodesWithOneChild) {
  Trees T;
  const BoundingBox Empty;
  for (unsigned Slot = 1; Slot != kWideBvhWidth; ++Slot)
    for (unsigned Axis = 0; Axis != 3; ++Axis) {
      T.WideNodes[0].Bounds[Axis][0][Slot] = component(Empty.Lower, Axis);
      T.WideNodes[0].Bounds[Axis][1][Slot] = component(Empty.Upper, Axis);
    }
  expectRule(T.verifyWide(), BvhRule::TwoChildren);
}

TEST(BvhVerifier, FindsBoxesOutsideTheirParents) {
  Trees T;
  ASSERT_FALSE(isLeaf(T.Nodes[0].Child[0]));
  T.Nodes[T.Nodes[0].Child[0]].Boxes[1].Upper.Z += 0.5f;
  expectRule(T.verifyBinary(), BvhRule::ChildInParent);
  T.WideNodes[0].Bounds[1][0][2] = -1;
  expectRule(T.verifyWide(), BvhRule::ChildInParent);
}

TEST(BvhVerifier, FindsBoxesThatAreNotNumbers) {
  Trees T;
  T.Nodes[0].Boxes[0].Lower.X = std::nanf("");
  expectRule(T.verifyBinary(), BvhRule::ChildInParent);
}

TEST(BvhVerifier, FindsEmptyLeaves) {
  Trees T;
  BvhReference &Leaf = T.someLeaf();
  Leaf = leafReference(leafFirst(Leaf), 0);
  const BvhFindings Findings = T.verifyBinary();
  expectRule(Findings, BvhRule::LeafNotEmpty);
  EXPECT_GT(Findings.LostPrimitives, 0u);
  T.Root = kNoBvh;
  EXPECT_EQ(describe(T.verifyBinary()), "at the root: the leaf is empty");
}

TEST(BvhVerifier, FindsLeavesThatAreTooLarge) {
  Trees T;
  BvhLimits Limits;
  Limits.LeafPrimitives = 0;
  expectRule(T.verifyBinary(Limits), BvhRule::LeafSize);
}

TEST(BvhVerifier, FindsLeavesBehindTheEnd) {
  Trees T;
  T.someLeaf() = leafReference(uint32_t(T.Boxes.size()) - 1, 2);
  expectRule(T.verifyBinary(), BvhRule::LeafInRange);
}

TEST(BvhVerifier, FindsNumbersThatAreNoPrimitives) {
  Trees T;
  T.Order[17] = uint32_t(T.Boxes.size());
  expectRule(T.verifyBinary(), BvhRule::PrimitiveNumber);
  expectRule(T.verifyWide(), BvhRule::PrimitiveNumber);
}

TEST(BvhVerifier, FindsRepeatedPrimitives) {
  Trees T;
  T.Order[18] = T.Order[17];
  // The repeated one may lie outside the other's leaf, which is another rule.
  for (BvhNode &Node : T.Nodes)
    for (BoundingBox &Box : Node.Boxes)
      Box = {{0, 0, 0}, {28, 28, 13}};
  const BvhFindings Findings = T.verifyBinary();
  expectRule(Findings, BvhRule::PrimitiveOnce);
  EXPECT_EQ(Findings.First.Value, T.Order[17]);
  EXPECT_EQ(Findings.RepeatedPrimitives, 1u);
  EXPECT_EQ(Findings.LostPrimitives, 1u);
}

TEST(BvhVerifier, FindsLostPrimitives) {
  Trees T;
  // One more primitive that no leaf names.
  T.Boxes.push_back({{5, 5, 5}, {6, 6, 6}});
  T.Order.push_back(uint32_t(T.Order.size()));
  for (const BvhFindings &Findings : {T.verifyBinary(), T.verifyWide()}) {
    expectRule(Findings, BvhRule::PrimitiveInLeaf);
    EXPECT_EQ(describe(Findings), "primitive 500 is in no leaf");
    EXPECT_EQ(Findings.LostPrimitives, 1u);
  }
}

TEST(BvhVerifier, FindsPrimitivesOutsideTheirLeaf) {
  Trees T;
  std::swap(T.Order.front(), T.Order.back());
  expectRule(T.verifyBinary(), BvhRule::PrimitiveInBox);
  expectRule(T.verifyWide(), BvhRule::PrimitiveInBox);
}

/// Whatever the memory holds, there is a verdict.
TEST(BvhVerifier, GarbageGetsAVerdict) {
  Trees T;
  uint32_t State = 1;
  auto Next = [&] { return State = State * 1664525u + 1013904223u; };
  for (int Round = 0; Round != 200; ++Round) {
    for (BvhNode &Node : T.Nodes)
      for (BvhReference &Child : Node.Child)
        Child = Next() >> Next() % 32;
    for (uint32_t &Number : T.Order)
      Number = Next() >> 22;
    EXPECT_FALSE(T.verifyBinary().isClean());
  }
}
