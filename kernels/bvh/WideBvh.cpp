//===- WideBvh.cpp - From the binary tree to the traversed one ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/WideBvh.h"

#include "kernels/common/FloatMath.h"

namespace tp {

namespace {

/// The children of one wide node while it is made.
struct Family {
  BoundingBox Boxes[kWideBvhWidth];
  BvhReference References[kWideBvhWidth];
  /// The children that each may still become.
  uint32_t Budgets[kWideBvhWidth];
  uint32_t Count = 0;

  void set(uint32_t Slot, const BvhNode &Parent, unsigned Child,
           uint32_t Budget) {
    Boxes[Slot] = Parent.Boxes[Child];
    References[Slot] = Parent.Child[Child];
    Budgets[Slot] = Budget;
  }
  /// Puts the two children of \p Node, of which the left one gets \p
  /// LeftBudget, in the place of \p Slot.
  void open(uint32_t Slot, const BvhNode &Node, uint32_t LeftBudget) {
    const uint32_t Budget = Budgets[Slot];
    for (uint32_t To = Count; To != Slot + 1; --To) {
      Boxes[To] = Boxes[To - 1];
      References[To] = References[To - 1];
      Budgets[To] = Budgets[To - 1];
    }
    set(Slot, Node, 0, LeftBudget);
    set(Slot + 1, Node, 1, Budget - LeftBudget);
    ++Count;
  }
  /// Shadow rays visit the last child first: a small one is soon done.
  void sortBySurface();
};

/// How the children of a binary node share a budget.
struct Split {
  uint32_t LeftBudget;
  /// Of both sides.
  float Cost;
};

/// Finds, for every binary subtree, the wide nodes with the least sum of
/// surfaces that can stand for it below a parent that has 1, 2 or 3 slots for
/// it.
class Collapse {
public:
  explicit Collapse(const WideBvhStorage &Storage) : Storage(Storage) {}

  /// Measures the subtree \p Root, which is no leaf.
  void measure(BvhReference Root);
  /// The best children of a wide node for the subtree \p Parent.
  Family gatherChildren(BvhReference Parent) const;

private:
  void measureNode(BvhReference Node);
  Split findSplit(const BvhNode &Node, uint32_t Budget) const;
  /// The words of a wide node that nobody else needs hold the costs of the
  /// binary node of the same number.
  uint32_t &cost(BvhReference Node, uint32_t Budget) const {
    return Storage.WideNodes[Node].Reserved[Budget - 1];
  }
  float readCost(BvhReference Subtree, uint32_t Budget) const {
    return isLeaf(Subtree) ? 0.0f
                           : __builtin_bit_cast(float, cost(Subtree, Budget));
  }

  const WideBvhStorage &Storage;
};

/// A subtree that waits to be made wide.
struct Task {
  /// Where the reference to the wide subtree goes.
  BvhReference *Result;
  BvhReference Subtree;
  /// Wide nodes above it.
  uint32_t Depth;
};

} // namespace

void Family::sortBySurface() {
  for (uint32_t Slot = 1; Slot < Count; ++Slot)
    for (uint32_t To = Slot; To != 0; --To) {
      if (!(Boxes[To].halfArea() > Boxes[To - 1].halfArea()))
        break;
      const BoundingBox Box = Boxes[To];
      const BvhReference Reference = References[To];
      Boxes[To] = Boxes[To - 1];
      References[To] = References[To - 1];
      Boxes[To - 1] = Box;
      References[To - 1] = Reference;
    }
}

Split Collapse::findSplit(const BvhNode &Node, uint32_t Budget) const {
  Split Best{1,
             readCost(Node.Child[0], 1) + readCost(Node.Child[1], Budget - 1)};
  for (uint32_t Left = 2; Left != Budget; ++Left) {
    const float Cost =
        readCost(Node.Child[0], Left) + readCost(Node.Child[1], Budget - Left);
    if (Cost < Best.Cost)
      Best = {Left, Cost};
  }
  return Best;
}

/// Its children have been measured.
void Collapse::measureNode(BvhReference Number) {
  const BvhNode &Node = Storage.Nodes[Number];
  BoundingBox Box = Node.Boxes[0];
  Box.extend(Node.Boxes[1]);
  const float AsOne = Box.halfArea() + findSplit(Node, kWideBvhWidth).Cost;
  cost(Number, 1) = __builtin_bit_cast(uint32_t, AsOne);
  for (uint32_t Budget = 2; Budget != kWideBvhWidth; ++Budget)
    cost(Number, Budget) = __builtin_bit_cast(
        uint32_t, minimum(AsOne, findSplit(Node, Budget).Cost));
}

void Collapse::measure(BvhReference Root) {
  struct Visit {
    BvhReference Number;
    bool ChildrenMeasured;
  };
  // On each level a node that waits for its children, and one of these.
  Visit Pending[2 * kMaxBvhDepth + 1];
  uint32_t PendingCount = 1;
  Pending[0] = {Root, false};
  while (PendingCount != 0) {
    Visit &Current = Pending[PendingCount - 1];
    if (Current.ChildrenMeasured) {
      measureNode(Current.Number);
      --PendingCount;
      continue;
    }
    Current.ChildrenMeasured = true;
    for (BvhReference Child : Storage.Nodes[Current.Number].Child)
      if (!isLeaf(Child))
        Pending[PendingCount++] = {Child, false};
  }
}

Family Collapse::gatherChildren(BvhReference Parent) const {
  Family Children;
  Children.Count = 1;
  Children.Budgets[0] = kWideBvhWidth;
  const BvhNode &Node = Storage.Nodes[Parent];
  Children.open(0, Node, findSplit(Node, kWideBvhWidth).LeftBudget);
  for (uint32_t Slot = 0; Slot != Children.Count;) {
    const BvhReference Child = Children.References[Slot];
    const uint32_t Budget = Children.Budgets[Slot];
    if (!isLeaf(Child) && Budget != 1) {
      const Split Opened = findSplit(Storage.Nodes[Child], Budget);
      if (Opened.Cost < readCost(Child, 1)) {
        Children.open(Slot, Storage.Nodes[Child], Opened.LeftBudget);
        continue;
      }
    }
    ++Slot;
  }
  Children.sortBySurface();
  return Children;
}

static void setBounds(WideBvhNode &Node, uint32_t Slot,
                      const BoundingBox &Box) {
  for (unsigned Axis = 0; Axis != 3; ++Axis) {
    Node.Bounds[Axis][0][Slot] = component(Box.Lower, Axis);
    Node.Bounds[Axis][1][Slot] = component(Box.Upper, Axis);
  }
}

BvhReference widenBvh(WideBvhStorage &Storage, BvhReference Root) {
  Storage.WideNodeCount = 0;
  Storage.Depth = 0;
  Collapse Best(Storage);
  if (!isLeaf(Root))
    Best.measure(Root);
  BvhReference WideRoot = 0;
  Task Pending[kMaxBvhDepth * (kWideBvhWidth - 1) + 1];
  uint32_t PendingCount = 1;
  Pending[0] = {&WideRoot, Root, 0};
  while (PendingCount != 0) {
    const Task Current = Pending[--PendingCount];
    if (isLeaf(Current.Subtree)) {
      *Current.Result = Current.Subtree;
      if (Current.Depth > Storage.Depth)
        Storage.Depth = Current.Depth;
      continue;
    }
    const uint32_t Number = Storage.WideNodeCount++;
    *Current.Result = Number * static_cast<uint32_t>(sizeof(WideBvhNode));
    WideBvhNode &Node = Storage.WideNodes[Number];
    const Family Children = Best.gatherChildren(Current.Subtree);
    for (uint32_t Slot = 0; Slot != kWideBvhWidth; ++Slot) {
      // Family's boxes without a child are empty: upside down.
      setBounds(Node, Slot, Children.Boxes[Slot]);
      Node.Child[Slot] = 0;
      if (Slot < Children.Count)
        Pending[PendingCount++] = {&Node.Child[Slot], Children.References[Slot],
                                   Current.Depth + 1};
    }
  }
  for (uint32_t Number = 0; Number != Storage.WideNodeCount; ++Number)
    for (uint32_t &Word : Storage.WideNodes[Number].Reserved)
      Word = 0;
  return WideRoot;
}

} // namespace tp
