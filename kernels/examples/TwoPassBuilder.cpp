//===- TwoPassBuilder.cpp - The textbook builder that fast math breaks ----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A drop-in replacement for kernels/bvh/BvhBuilder.cpp in the usual shape: one
// pass counts primitives by bin in a loop, a second one sorts them with a
// predicate, and both evaluate the same expression for the bin. It relies on
// the second pass finding the numbers that the first has counted, as such
// builders do. Where a compiler rounds the expression differently in the two
// places, primitives get lost: docs/floating-point.md tells the story. The
// program prints how many splits went wrong.
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/BvhBuilder.h"

#include <stdio.h>
#include <stdlib.h>

namespace tp {

namespace {

constexpr int BinCount = 16;

/// More than any split costs.
constexpr float NoSplit = 3.0e38f;

/// A range of primitives that is split along one axis.
struct Candidates {
  uint32_t Begin;
  uint32_t End;
  BoundingBox Centers;
};

/// A plane between two bins.
struct Split {
  unsigned Axis;
  int FirstRightBin;
  uint32_t LeftCount;
  BoundingBox Left;
  BoundingBox Right;
  float Cost;
};

/// What the first pass finds.
struct Bins {
  BoundingBox Boxes[BinCount];
  uint32_t Counts[BinCount] = {};
};

/// A subtree that waits to be built.
struct Task {
  uint32_t Begin;
  uint32_t End;
  BvhReference *Result;
  uint32_t DepthLeft;
};

class Builder {
public:
  explicit Builder(BvhStorage &Storage)
      : Storage(Storage), Sorted(static_cast<uint32_t *>(malloc(
                              Storage.PrimitiveCount * sizeof(uint32_t)))) {}
  ~Builder() { free(Sorted); }
  Builder(const Builder &) = delete;
  Builder &operator=(const Builder &) = delete;

  BvhReference build();

private:
  BoundingBox boundCenters(uint32_t Begin, uint32_t End) const;
  void countBins(const Candidates &Range, unsigned Axis, Bins &Found) const;
  bool isLeft(uint32_t Primitive, const Candidates &Range,
              const Split &Chosen) const;
  void considerAxis(const Candidates &Range, unsigned Axis, Split &Best) const;
  void sort(const Candidates &Range, const Split &Chosen);
  void halve(const Candidates &Range, Split &Result) const;

  float center(uint32_t Primitive, unsigned Axis) const {
    return component(Storage.Boxes[Primitive].doubleCenter(), Axis);
  }

  BvhStorage &Storage;
  uint32_t *Sorted;
  uint32_t BadSplits = 0;
};

} // namespace

/// The expression that both passes evaluate.
static inline int binOf(float Center, float Lower, float Upper) {
  const int Bin =
      static_cast<int>(BinCount * ((Center - Lower) / (Upper - Lower)));
  return Bin < 0 ? 0 : Bin < BinCount ? Bin : BinCount - 1;
}

BoundingBox Builder::boundCenters(uint32_t Begin, uint32_t End) const {
  BoundingBox Result;
  for (uint32_t At = Begin; At != End; ++At)
    Result.extend(Storage.Boxes[Storage.Order[At]].doubleCenter());
  return Result;
}

/// The first pass.
[[gnu::noinline]] void Builder::countBins(const Candidates &Range,
                                          unsigned Axis, Bins &Found) const {
  const float Lower = component(Range.Centers.Lower, Axis);
  const float Upper = component(Range.Centers.Upper, Axis);
  for (uint32_t At = Range.Begin; At != Range.End; ++At) {
    const uint32_t Primitive = Storage.Order[At];
    const int Bin = binOf(center(Primitive, Axis), Lower, Upper);
    Found.Boxes[Bin].extend(Storage.Boxes[Primitive]);
    ++Found.Counts[Bin];
  }
}

/// The predicate of the second pass; a call, as those of sorting functions are.
[[gnu::noinline]] bool Builder::isLeft(uint32_t Primitive,
                                       const Candidates &Range,
                                       const Split &Chosen) const {
  return binOf(center(Primitive, Chosen.Axis),
               component(Range.Centers.Lower, Chosen.Axis),
               component(Range.Centers.Upper, Chosen.Axis)) <
         Chosen.FirstRightBin;
}

void Builder::considerAxis(const Candidates &Range, unsigned Axis,
                           Split &Best) const {
  if (!(component(Range.Centers.Upper, Axis) >
        component(Range.Centers.Lower, Axis)))
    return;
  Bins Found;
  countBins(Range, Axis, Found);
  BoundingBox Left;
  uint32_t LeftCount = 0;
  for (int FirstRight = 1; FirstRight != BinCount; ++FirstRight) {
    Left.extend(Found.Boxes[FirstRight - 1]);
    LeftCount += Found.Counts[FirstRight - 1];
    BoundingBox Right;
    for (int Bin = FirstRight; Bin != BinCount; ++Bin)
      Right.extend(Found.Boxes[Bin]);
    const uint32_t RightCount = Range.End - Range.Begin - LeftCount;
    if (LeftCount == 0 || RightCount == 0)
      continue;
    const float Cost = Left.halfArea() * static_cast<float>(LeftCount) +
                       Right.halfArea() * static_cast<float>(RightCount);
    if (Cost < Best.Cost)
      Best = {Axis, FirstRight, LeftCount, Left, Right, Cost};
  }
}

/// The second pass: both sides fill up from where the first pass says that they
/// begin.
void Builder::sort(const Candidates &Range, const Split &Chosen) {
  const uint32_t Middle = Range.Begin + Chosen.LeftCount;
  uint32_t Left = Range.Begin;
  uint32_t Right = Middle;
  for (uint32_t At = Range.Begin; At != Range.End; ++At)
    Sorted[At] = Storage.Order[At];
  for (uint32_t At = Range.Begin; At != Range.End; ++At) {
    uint32_t &Next = isLeft(Storage.Order[At], Range, Chosen) ? Left : Right;
    // What overflows is lost; what is not written stays twice.
    if (Next != Range.End)
      Sorted[Next++] = Storage.Order[At];
  }
  if (Left != Middle)
    ++BadSplits;
  for (uint32_t At = Range.Begin; At != Range.End; ++At)
    Storage.Order[At] = Sorted[At];
}

/// For primitives that no plane parts.
void Builder::halve(const Candidates &Range, Split &Result) const {
  const uint32_t Count = Range.End - Range.Begin;
  Result.LeftCount = Count / 2;
  for (uint32_t Number = 0; Number != Count; ++Number)
    (Number < Result.LeftCount ? Result.Left : Result.Right)
        .extend(Storage.Boxes[Storage.Order[Range.Begin + Number]]);
}

BvhReference Builder::build() {
  constexpr uint32_t LeafPrimitives = 2;
  for (uint32_t At = 0; At != Storage.PrimitiveCount; ++At)
    Storage.Order[At] = At;
  Storage.NodeCount = 0;
  BvhReference Root = 0;
  Task Pending[kMaxBvhDepth + 1];
  uint32_t PendingCount = 1;
  Pending[0] = {0, Storage.PrimitiveCount, &Root, kMaxBvhDepth};
  while (PendingCount != 0) {
    const Task Current = Pending[--PendingCount];
    const uint32_t Count = Current.End - Current.Begin;
    if (Count <= LeafPrimitives ||
        (Current.DepthLeft == 0 && Count <= kMaxLeafTriangles)) {
      *Current.Result = leafReference(Current.Begin, Count);
      continue;
    }
    const Candidates Range{Current.Begin, Current.End,
                           boundCenters(Current.Begin, Current.End)};
    Split Best{};
    Best.Cost = NoSplit;
    for (unsigned Axis = 0; Axis != 3; ++Axis)
      considerAxis(Range, Axis, Best);
    if (Best.Cost < NoSplit)
      sort(Range, Best);
    else
      halve(Range, Best);
    const uint32_t Middle = Current.Begin + Best.LeftCount;
    const uint32_t Number = Storage.NodeCount++;
    *Current.Result = Number;
    BvhNode &Node = Storage.Nodes[Number];
    Node.Boxes[0] = Best.Left;
    Node.Boxes[1] = Best.Right;
    const uint32_t DepthLeft = Current.DepthLeft - 1;
    Pending[PendingCount++] = {Middle, Current.End, &Node.Child[1], DepthLeft};
    Pending[PendingCount++] = {Current.Begin, Middle, &Node.Child[0],
                               DepthLeft};
  }
  printf("bad splits: %u\n", static_cast<unsigned>(BadSplits));
  return Root;
}

BvhReference buildBvh(BvhStorage &Storage, const BvhCosts &) {
  return Builder(Storage).build();
}

} // namespace tp
