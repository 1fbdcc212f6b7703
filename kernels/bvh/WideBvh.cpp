//===- WideBvh.cpp - From the binary tree to the traversed one ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/WideBvh.h"

namespace tp {

namespace {

/// The children of one wide node while it is made.
struct Family {
  BoundingBox Boxes[kWideBvhWidth];
  BvhReference References[kWideBvhWidth];
  uint32_t Count = 0;

  void set(uint32_t Slot, const BvhNode &Parent, unsigned Child) {
    Boxes[Slot] = Parent.Boxes[Child];
    References[Slot] = Parent.Child[Child];
  }
};

/// A subtree that waits to be made wide.
struct Task {
  BvhReference Subtree;
  /// Where the reference to the wide subtree goes.
  BvhReference *Result;
  /// Wide nodes above it.
  uint32_t Depth;
};

} // namespace

/// The inner node among the children that rays are most likely to hit;
/// kWideBvhWidth if all are leaves.
static uint32_t findLargestInnerChild(const Family &Children) {
  uint32_t Largest = kWideBvhWidth;
  float LargestArea = -1.0f;
  for (uint32_t Slot = 0; Slot != Children.Count; ++Slot) {
    const float Area = Children.Boxes[Slot].halfArea();
    if (!isLeaf(Children.References[Slot]) && Area > LargestArea) {
      Largest = Slot;
      LargestArea = Area;
    }
  }
  return Largest;
}

static Family gatherChildren(const BvhNode *Nodes, BvhReference Parent) {
  Family Children;
  Children.set(0, Nodes[Parent], 0);
  Children.set(1, Nodes[Parent], 1);
  Children.Count = 2;
  while (Children.Count != kWideBvhWidth) {
    const uint32_t Opened = findLargestInnerChild(Children);
    if (Opened == kWideBvhWidth)
      break;
    const BvhNode &Node = Nodes[Children.References[Opened]];
    Children.set(Opened, Node, 0);
    Children.set(Children.Count++, Node, 1);
  }
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
  BvhReference WideRoot = 0;
  Task Pending[kMaxBvhDepth * (kWideBvhWidth - 1) + 1];
  uint32_t PendingCount = 1;
  Pending[0] = {Root, &WideRoot, 0};
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
    const Family Children = gatherChildren(Storage.Nodes, Current.Subtree);
    Node = WideBvhNode();
    for (uint32_t Slot = 0; Slot != kWideBvhWidth; ++Slot) {
      // Family's boxes without a child are empty: upside down.
      setBounds(Node, Slot, Children.Boxes[Slot]);
      if (Slot < Children.Count)
        Pending[PendingCount++] = {Children.References[Slot], &Node.Child[Slot],
                                   Current.Depth + 1};
    }
  }
  return WideRoot;
}

} // namespace tp
