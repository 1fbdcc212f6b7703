//===- BvhVerifier.cpp - Is this tree a tree? -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/BvhVerifier.h"

#include <stdio.h>

namespace tp {

namespace {

/// How the walk sees the nodes of buildBvh().
struct BinaryNodes {
  static constexpr unsigned Width = 2;
  const BvhNode *Nodes;
  uint32_t Count;

  bool find(BvhReference Reference, uint32_t &Number) const {
    Number = Reference;
    return Number < Count;
  }
  bool child(uint32_t Number, unsigned Slot, BoundingBox &Box,
             BvhReference &Reference) const {
    Box = Nodes[Number].Boxes[Slot];
    Reference = Nodes[Number].Child[Slot];
    return true;
  }
};

/// How the walk sees the nodes of widenBvh().
struct WideNodes {
  static constexpr unsigned Width = kWideBvhWidth;
  const WideBvhNode *Nodes;
  uint32_t Count;

  bool find(BvhReference Reference, uint32_t &Number) const {
    Number = Reference / static_cast<uint32_t>(sizeof(WideBvhNode));
    return Reference % sizeof(WideBvhNode) == 0 && Number < Count;
  }
  /// False for an empty slot.
  bool child(uint32_t Number, unsigned Slot, BoundingBox &Box,
             BvhReference &Reference) const {
    const auto &Bounds = Nodes[Number].Bounds;
    Box.Lower = {Bounds[0][0][Slot], Bounds[1][0][Slot], Bounds[2][0][Slot]};
    Box.Upper = {Bounds[0][1][Slot], Bounds[1][1][Slot], Bounds[2][1][Slot]};
    Reference = Nodes[Number].Child[Slot];
    return !(Box.Lower.X > Box.Upper.X && Box.Lower.Y > Box.Upper.Y &&
             Box.Lower.Z > Box.Upper.Z);
  }
};

/// A subtree that waits to be verified.
struct Visit {
  BvhReference Reference;
  /// What the parent says of the subtree.
  BoundingBox Box;
  /// Where the reference stands.
  uint32_t Node;
  uint32_t Child;
  /// Inner nodes above.
  uint32_t Depth;
};

/// A depth-first walk over the nodes that a \p NodesType finds.
template <typename NodesType> class Walk {
public:
  Walk(const BvhStorage &Primitives, NodesType Nodes, uint32_t *Scratch,
       const BvhCosts &Costs, const BvhLimits &Limits)
      : Primitives(Primitives), Nodes(Nodes), Costs(Costs), Limits(Limits),
        Found(Scratch, Primitives.PrimitiveCount),
        Reached(Scratch + BitSet::wordCount(Primitives.PrimitiveCount),
                Nodes.Count) {}

  BvhFindings run(BvhReference Root);

private:
  void fail(BvhRule Rule, const Visit &At, uint32_t Value);
  void visitLeaf(const Visit &At);
  void visitNode(const Visit &At);
  void finish();

  const BvhStorage &Primitives;
  const NodesType Nodes;
  const BvhCosts Costs;
  const BvhLimits Limits;
  BitSet Found;
  BitSet Reached;
  BvhFindings Result;
  double RootArea = 0;
  Visit Pending[kMaxBvhDepth * (NodesType::Width - 1) + 1];
  uint32_t PendingCount = 0;
};

} // namespace

/// False also if a coordinate is NaN.
static bool contains(const BoundingBox &Outer, const BoundingBox &Inner) {
  return Outer.Lower.X <= Inner.Lower.X && Outer.Lower.Y <= Inner.Lower.Y &&
         Outer.Lower.Z <= Inner.Lower.Z && Outer.Upper.X >= Inner.Upper.X &&
         Outer.Upper.Y >= Inner.Upper.Y && Outer.Upper.Z >= Inner.Upper.Z;
}

/// In double precision, so that the cost of a large tree is exact enough to
/// compare.
static double halfArea(const BoundingBox &Box) {
  const double X = double(Box.Upper.X) - double(Box.Lower.X);
  const double Y = double(Box.Upper.Y) - double(Box.Lower.Y);
  const double Z = double(Box.Upper.Z) - double(Box.Lower.Z);
  return X * Y + Y * Z + Z * X;
}

template <typename NodesType>
void Walk<NodesType>::fail(BvhRule Rule, const Visit &At, uint32_t Value) {
  if (Result.isClean())
    Result.First = {Rule, At.Node, At.Child, Value};
}

template <typename NodesType> void Walk<NodesType>::visitLeaf(const Visit &At) {
  const uint32_t First = leafFirst(At.Reference);
  const uint32_t Count = leafCount(At.Reference);
  ++Result.LeafCount;
  Result.Cost +=
      halfArea(At.Box) / RootArea * double(Costs.Triangle) * double(Count);
  if (Count == 0)
    fail(BvhRule::LeafNotEmpty, At, 0);
  if (Count > Limits.LeafPrimitives)
    fail(BvhRule::LeafSize, At, Count);
  if (First > Primitives.PrimitiveCount ||
      Count > Primitives.PrimitiveCount - First)
    return fail(BvhRule::LeafInRange, At, First);
  for (uint32_t Position = First; Position != First + Count; ++Position) {
    const uint32_t Number = Primitives.Order[Position];
    if (Number >= Primitives.PrimitiveCount) {
      fail(BvhRule::PrimitiveNumber, At, Number);
      continue;
    }
    if (!Found.insert(Number)) {
      ++Result.RepeatedPrimitives;
      fail(BvhRule::PrimitiveOnce, At, Number);
    }
    if (!contains(At.Box, Primitives.Boxes[Number]))
      fail(BvhRule::PrimitiveInBox, At, Number);
  }
}

template <typename NodesType> void Walk<NodesType>::visitNode(const Visit &At) {
  uint32_t Number;
  if (!Nodes.find(At.Reference, Number))
    return fail(BvhRule::ReferenceInRange, At, At.Reference);
  if (!Reached.insert(Number))
    return fail(BvhRule::NodeOnce, At, Number);
  if (At.Depth == Limits.Depth)
    return fail(BvhRule::Depth, At, At.Depth + 1);
  if (At.Depth + 1 > Result.Depth)
    Result.Depth = At.Depth + 1;
  Result.Cost += halfArea(At.Box) / RootArea * double(Costs.Node);
  uint32_t ChildCount = 0;
  // The first child is visited first.
  for (uint32_t Slot = NodesType::Width; Slot-- != 0;) {
    Visit Child{0, {}, Number, Slot, At.Depth + 1};
    if (!Nodes.child(Number, Slot, Child.Box, Child.Reference))
      continue;
    ++ChildCount;
    if (!contains(At.Box, Child.Box))
      fail(BvhRule::ChildInParent, Child, 0);
    Pending[PendingCount++] = Child;
  }
  if (ChildCount < 2)
    fail(BvhRule::TwoChildren, At, ChildCount);
}

/// What shows only when all has been walked.
template <typename NodesType> void Walk<NodesType>::finish() {
  const Visit Nowhere{0, {}, BvhViolation::AtRoot, 0, 0};
  for (uint32_t Number = 0; Number != Primitives.PrimitiveCount; ++Number)
    if (!Found.contains(Number)) {
      ++Result.LostPrimitives;
      fail(BvhRule::PrimitiveInLeaf, Nowhere, Number);
    }
  for (uint32_t Number = 0; Number != Nodes.Count; ++Number)
    if (!Reached.contains(Number))
      fail(BvhRule::NodeReached, Nowhere, Number);
}

template <typename NodesType>
BvhFindings Walk<NodesType>::run(BvhReference Root) {
  BoundingBox All;
  for (uint32_t Number = 0; Number != Primitives.PrimitiveCount; ++Number)
    All.extend(Primitives.Boxes[Number]);
  RootArea = halfArea(All);
  Pending[PendingCount++] = {Root, All, BvhViolation::AtRoot, 0, 0};
  while (PendingCount != 0) {
    const Visit At = Pending[--PendingCount];
    if (isLeaf(At.Reference))
      visitLeaf(At);
    else
      visitNode(At);
  }
  finish();
  return Result;
}

BvhFindings verifyBvh(const BvhStorage &Storage, BvhReference Root,
                      uint32_t *Scratch, const BvhCosts &Costs,
                      const BvhLimits &Limits) {
  const BinaryNodes Nodes{Storage.Nodes, Storage.NodeCount};
  return Walk(Storage, Nodes, Scratch, Costs, Limits).run(Root);
}

BvhFindings verifyWideBvh(const BvhStorage &Storage, const WideBvhStorage &Wide,
                          BvhReference Root, uint32_t *Scratch,
                          const BvhCosts &Costs, const BvhLimits &Limits) {
  const WideNodes Nodes{Wide.WideNodes, Wide.WideNodeCount};
  return Walk(Storage, Nodes, Scratch, Costs, Limits).run(Root);
}

/// What is wrong, with one %u for the violation's value.
static const char *violationFormat(BvhRule Rule) {
  switch (Rule) {
  case BvhRule::None:
    break;
  case BvhRule::ReferenceInRange:
    return "the reference 0x%x names no node";
  case BvhRule::NodeOnce:
    return "node %u has been reached before";
  case BvhRule::NodeReached:
    return "node %u is not reached from the root";
  case BvhRule::Depth:
    return "%u inner nodes follow each other, more than allowed";
  case BvhRule::TwoChildren:
    return "a node has %u children, fewer than 2";
  case BvhRule::ChildInParent:
    return "the box is not inside its parent's";
  case BvhRule::LeafNotEmpty:
    return "the leaf is empty";
  case BvhRule::LeafSize:
    return "the leaf has %u primitives, more than allowed";
  case BvhRule::LeafInRange:
    return "the leaf begins at %u and ends behind the last primitive";
  case BvhRule::PrimitiveNumber:
    return "the leaf names the primitive %u, which does not exist";
  case BvhRule::PrimitiveOnce:
    return "primitive %u is here and in another place";
  case BvhRule::PrimitiveInLeaf:
    return "primitive %u is in no leaf";
  case BvhRule::PrimitiveInBox:
    return "primitive %u is not inside the box of its leaf";
  }
  return "every rule is kept";
}

int describeViolation(const BvhViolation &Violation, char *Buffer,
                      size_t Bytes) {
  char What[80];
  snprintf(What, sizeof(What), violationFormat(Violation.Rule),
           Violation.Value);
  switch (Violation.Rule) {
  case BvhRule::None:
  case BvhRule::NodeReached:
  case BvhRule::PrimitiveInLeaf:
    return snprintf(Buffer, Bytes, "%s", What);
  default:
    break;
  }
  if (Violation.Node == BvhViolation::AtRoot)
    return snprintf(Buffer, Bytes, "at the root: %s", What);
  return snprintf(Buffer, Bytes, "child %u of node %u: %s", Violation.Child,
                  Violation.Node, What);
}

} // namespace tp
