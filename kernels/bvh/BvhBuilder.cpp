//===- BvhBuilder.cpp - Binned surface-area-heuristic builder -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/BvhBuilder.h"

namespace tp {

namespace {

constexpr unsigned BinCount = 32;

/// Maps primitives to bins by their centres. The scale is computed once, so
/// that counting and partitioning round alike, and the bin is clamped, as in
/// Embree's BinMapping.
class BinMapping {
public:
  explicit BinMapping(const BoundingBox &DoubleCenters)
      : Origin(DoubleCenters.Lower),
        Scale{scale(DoubleCenters.size().X), scale(DoubleCenters.size().Y),
              scale(DoubleCenters.size().Z)} {}

  unsigned bin(Vector3 DoubleCenter, unsigned Axis) const {
    const float Position =
        (component(DoubleCenter, Axis) - component(Origin, Axis)) *
        component(Scale, Axis);
    const int32_t Bin = static_cast<int32_t>(Position);
    if (Bin < 0)
      return 0;
    return Bin < static_cast<int32_t>(BinCount) ? Bin : BinCount - 1;
  }

  /// Whether all centres share their coordinate along \p Axis.
  bool isFlat(unsigned Axis) const { return component(Scale, Axis) == 0.0f; }

private:
  /// A little less than full, so that the largest centre rounds into the last
  /// bin.
  static float scale(float Extent) {
    return Extent > 1e-30f ? 0.99f * BinCount / Extent : 0.0f;
  }

  Vector3 Origin;
  Vector3 Scale;
};

struct Bin {
  BoundingBox Box;
  uint32_t Count = 0;
};

/// The primitives Order[Begin..End) that a child of a node stands for.
struct Range {
  uint32_t Begin;
  uint32_t End;
  BoundingBox Box;
  /// Of the doubled centres.
  BoundingBox Centers;

  uint32_t count() const { return End - Begin; }
};

struct Split {
  unsigned Axis;
  /// The last bin of the left child.
  unsigned LastLeftBin;
  float Cost;
};

/// A subtree that waits to be built.
struct Task {
  Range Primitives;
  /// Where the reference to the subtree goes.
  BvhReference *Result;
  /// Inner nodes that its paths may still have.
  uint32_t DepthLeft;
};

class Builder {
public:
  Builder(BvhStorage &Storage, const BvhCosts &Costs)
      : Storage(Storage), Costs(Costs) {}

  BvhReference build();

private:
  Range measure(uint32_t Begin, uint32_t End) const;
  bool findSplit(const Range &Primitives, const BinMapping &Mapping,
                 Split &Best) const;
  void sweep(const Bin *Bins, unsigned Axis, float InverseArea,
             Split &Best) const;
  uint32_t partition(const Range &Primitives, const BinMapping &Mapping,
                     const Split &Chosen);
  uint32_t chooseMiddle(const Range &Primitives, uint32_t DepthLeft);
  float leafCost(uint32_t Count) const {
    return Costs.Triangle * static_cast<float>(Count);
  }

  BvhStorage &Storage;
  const BvhCosts &Costs;
};

} // namespace

/// Levels of inner nodes that \p Count primitives need when split in halves.
static uint32_t balancedDepth(uint32_t Count) {
  uint32_t Depth = 0;
  while (Count > kMaxLeafTriangles << Depth)
    ++Depth;
  return Depth;
}

Range Builder::measure(uint32_t Begin, uint32_t End) const {
  Range Result{Begin, End, {}, {}};
  for (uint32_t Position = Begin; Position != End; ++Position) {
    const BoundingBox &Box = Storage.Boxes[Storage.Order[Position]];
    Result.Box.extend(Box);
    Result.Centers.extend(Box.doubleCenter());
  }
  return Result;
}

/// Considers the splits between the bins of one axis.
void Builder::sweep(const Bin *Bins, unsigned Axis, float InverseArea,
                    Split &Best) const {
  float RightCosts[BinCount];
  Bin Right;
  for (unsigned Last = BinCount - 1; Last != 0; --Last) {
    Right.Box.extend(Bins[Last].Box);
    Right.Count += Bins[Last].Count;
    RightCosts[Last] =
        Right.Count == 0 ? -1.0f : Right.Box.halfArea() * leafCost(Right.Count);
  }
  Bin Left;
  for (unsigned Last = 0; Last != BinCount - 1; ++Last) {
    Left.Box.extend(Bins[Last].Box);
    Left.Count += Bins[Last].Count;
    if (Left.Count == 0 || RightCosts[Last + 1] < 0.0f)
      continue;
    const float Children =
        Left.Box.halfArea() * leafCost(Left.Count) + RightCosts[Last + 1];
    const float Cost = Costs.Node + Children * InverseArea;
    if (Cost < Best.Cost)
      Best = {Axis, Last, Cost};
  }
}

/// The cheapest split between bins; false if there is none, as when all centres
/// are equal.
bool Builder::findSplit(const Range &Primitives, const BinMapping &Mapping,
                        Split &Best) const {
  const float Area = Primitives.Box.halfArea();
  if (!(Area > 0.0f))
    return false;
  constexpr float NoSplit = 3.0e38f;
  Best = {0, 0, NoSplit};
  Bin Bins[3][BinCount];
  for (uint32_t At = Primitives.Begin; At != Primitives.End; ++At) {
    const BoundingBox &Box = Storage.Boxes[Storage.Order[At]];
    const Vector3 Center = Box.doubleCenter();
    for (unsigned Axis = 0; Axis != 3; ++Axis) {
      Bin &Target = Bins[Axis][Mapping.bin(Center, Axis)];
      Target.Box.extend(Box);
      ++Target.Count;
    }
  }
  for (unsigned Axis = 0; Axis != 3; ++Axis)
    if (!Mapping.isFlat(Axis))
      sweep(Bins[Axis], Axis, 1.0f / Area, Best);
  return Best.Cost < NoSplit;
}

/// Sorts the range by side; returns where the right side begins.
uint32_t Builder::partition(const Range &Primitives, const BinMapping &Mapping,
                            const Split &Chosen) {
  uint32_t *Order = Storage.Order;
  uint32_t Left = Primitives.Begin;
  uint32_t Right = Primitives.End;
  while (Left != Right) {
    const Vector3 Center = Storage.Boxes[Order[Left]].doubleCenter();
    if (Mapping.bin(Center, Chosen.Axis) <= Chosen.LastLeftBin) {
      ++Left;
      continue;
    }
    --Right;
    const uint32_t Moved = Order[Left];
    Order[Left] = Order[Right];
    Order[Right] = Moved;
  }
  return Left;
}

/// Where to divide the range, or its end to make it a leaf.
uint32_t Builder::chooseMiddle(const Range &Primitives, uint32_t DepthLeft) {
  const uint32_t Count = Primitives.count();
  const bool MayBeLeaf = Count <= kMaxLeafTriangles;
  if (Count == 1 || (MayBeLeaf && DepthLeft == 0))
    return Primitives.End;
  const uint32_t Half = Primitives.Begin + (Count + 1) / 2;
  if (!MayBeLeaf && balancedDepth(Count) >= DepthLeft)
    return Half;

  const BinMapping Mapping(Primitives.Centers);
  Split Best;
  const bool Found = findSplit(Primitives, Mapping, Best);
  if (MayBeLeaf && (!Found || leafCost(Count) <= Best.Cost))
    return Primitives.End;
  if (!Found)
    return Half;
  // Nothing relies on the partition finding the numbers that the bins counted:
  // with other float rules, both may round differently.
  const uint32_t Middle = partition(Primitives, Mapping, Best);
  const bool OneSided = Middle == Primitives.Begin || Middle == Primitives.End;
  return OneSided ? Half : Middle;
}

BvhReference Builder::build() {
  for (uint32_t Position = 0; Position != Storage.PrimitiveCount; ++Position)
    Storage.Order[Position] = Position;
  Storage.NodeCount = 0;

  BvhReference Root = 0;
  // One right sibling waits on each level.
  Task Pending[kMaxBvhDepth + 1];
  uint32_t PendingCount = 1;
  Pending[0] = {measure(0, Storage.PrimitiveCount), &Root, kMaxBvhDepth};
  while (PendingCount != 0) {
    const Task Current = Pending[--PendingCount];
    const Range &Primitives = Current.Primitives;
    const uint32_t Middle = chooseMiddle(Primitives, Current.DepthLeft);
    if (Middle == Primitives.End) {
      *Current.Result = leafReference(Primitives.Begin, Primitives.count());
      continue;
    }
    const uint32_t Number = Storage.NodeCount++;
    *Current.Result = Number;
    BvhNode &Node = Storage.Nodes[Number];
    const Range Left = measure(Primitives.Begin, Middle);
    const Range Right = measure(Middle, Primitives.End);
    Node.Boxes[0] = Left.Box;
    Node.Boxes[1] = Right.Box;
    Pending[PendingCount++] = {Right, &Node.Child[1], Current.DepthLeft - 1};
    Pending[PendingCount++] = {Left, &Node.Child[0], Current.DepthLeft - 1};
  }
  return Root;
}

BvhReference buildBvh(BvhStorage &Storage, const BvhCosts &Costs) {
  return Builder(Storage, Costs).build();
}

} // namespace tp
