//===- QuantizedBvh.cpp - From full nodes to quantized ones ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Why no ray notices: let u = 2^-24 be the relative error of one operation, M
// the largest coordinate and s a node's scale, and measure errors along an axis
// (a distance divided by the inverse direction, which both tests share).
//   RayBoxTester, (plane - origin) * inverse: 2u of at most 2M.
//   QuantizedBoxTester, number * (scale * inverse) + start with
//   start = (Origin - origin) * inverse: start 2u of at most 2M + 257s, the
//   product 2u of at most 512s, the sum u of at most 2M + 255s.
// Together that is less than 10uM + 1800us. Planes are rounded outwards by more
// than 16uM + 2048us.
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/QuantizedBvh.h"

#include "kernels/bvh/QuantizedPlanes.h"

namespace tp {

namespace {

/// What the boxes of one axis of a node span.
struct Span {
  double Lower;
  double Upper;
};

/// Where the planes of one axis can be.
struct Grid {
  float Origin;
  float Scale;

  double position(double Number) const {
    return double(Origin) + Number * double(Scale);
  }
  /// How far a plane must be from that of the full box.
  double margin(double MarginOfAll) const {
    return MarginOfAll + 0x1p-13 * double(Scale);
  }
};

} // namespace

/// Products with smaller scales could lose bits to underflow.
static constexpr double SmallestScale = 0x1p-60;

static bool isMissing(const WideBvhNode &Node, unsigned Child) {
  return Node.Bounds[0][0][Child] > Node.Bounds[0][1][Child];
}

static Span spanOfChildren(const WideBvhNode &Node, unsigned Axis) {
  Span Result = {double(Node.Bounds[Axis][0][0]),
                 double(Node.Bounds[Axis][1][0])};
  for (unsigned Child = 1; Child != kWideBvhWidth; ++Child) {
    if (isMissing(Node, Child))
      continue;
    const double Lower = double(Node.Bounds[Axis][0][Child]);
    const double Upper = double(Node.Bounds[Axis][1][Child]);
    Result.Lower = Lower < Result.Lower ? Lower : Result.Lower;
    Result.Upper = Upper > Result.Upper ? Upper : Result.Upper;
  }
  return Result;
}

/// The largest float that is not above \p Value.
static float roundDown(double Value) {
  const float Nearest = float(Value);
  if (double(Nearest) <= Value)
    return Nearest;
  const uint32_t Bits = __builtin_bit_cast(uint32_t, Nearest);
  if (Bits == 0)
    return -0x1p-149f;
  return __builtin_bit_cast(float, Nearest > 0.0f ? Bits - 1 : Bits + 1);
}

/// Sets the scale of \p Axis to the smallest that is not below \p Least; what
/// follows it in the word is set already.
static void setScale(uint32_t &Scales, unsigned Axis, double Least) {
  // The last axis has a bit less.
  const unsigned Lowest = 32 - kScaleBits + Axis / 2;
  const unsigned Place = Lowest - Axis * kScaleBits;
  uint32_t Field = __builtin_bit_cast(uint32_t, roundDown(Least)) >> Lowest;
  while (double(quantizedScale(Scales | Field << Place, Axis)) < Least)
    ++Field;
  Scales |= Field << Place;
}

/// The largest byte whose plane is not above \p Limit, or with \p Above the
/// smallest whose plane is not below. \p Fraction adds to the byte.
static uint32_t roundPlane(const Grid &Planes, double Limit, double Fraction,
                           bool Above) {
  const double First = kFirstPlane + Fraction;
  uint32_t Byte = Above ? 255 : 0;
  uint32_t Step = 128;
  for (; Step != 0; Step /= 2) {
    const uint32_t Next = Above ? Byte - Step : Byte + Step;
    const double Position = Planes.position(First + Next);
    if (Above ? Position >= Limit : Position <= Limit)
      Byte = Next;
  }
  return Byte;
}

namespace {

/// Makes one node.
class NodeQuantizer {
public:
  NodeQuantizer(const WideBvhNode &Node, double MarginOfAll)
      : Node(Node), MarginOfAll(MarginOfAll) {}

  QuantizedBvhNode quantize() {
    // The last axis first: its bits continue those of the axes before.
    for (unsigned Axis = 3; Axis-- != 0;)
      setAxis(Axis);
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
      Result.Child[Child] = isMissing(Node, Child)
                                ? kNoBvh
                                : quantizedReference(Node.Child[Child]);
    return Result;
  }

private:
  void setAxis(unsigned Axis);
  uint32_t roundPlanes(const Grid &Planes, unsigned Axis, bool Upper) const;

  const WideBvhNode &Node;
  const double MarginOfAll;
  QuantizedBvhNode Result = {};
};

} // namespace

void NodeQuantizer::setAxis(unsigned Axis) {
  const Span All = spanOfChildren(Node, Axis);
  // From below the last byte's plane 255 to above the first one's 0 with the
  // largest fraction are 254 scales: one and a bit of them are for the margins
  // that grow with the scale and for the rounding of Origin.
  const double Size = All.Upper - All.Lower + 3 * MarginOfAll;
  const double Least = Size / 253 > SmallestScale ? Size / 253 : SmallestScale;
  setScale(Result.Scales, Axis, Least);
  Grid Planes = {0, quantizedScale(Result.Scales, Axis)};
  Planes.Origin = roundDown(All.Lower - Planes.margin(MarginOfAll) -
                            (kFirstPlane + 1) * double(Planes.Scale));
  Result.Origin[Axis] = Planes.Origin;
  Result.Planes[Axis][0] = roundPlanes(Planes, Axis, false);
  Result.Planes[Axis][1] = roundPlanes(Planes, Axis, true);
}

uint32_t NodeQuantizer::roundPlanes(const Grid &Planes, unsigned Axis,
                                    bool Upper) const {
  const double Margin = Planes.margin(MarginOfAll);
  uint32_t Word = 0;
  uint32_t Byte = 0;
  for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
    // As PlaneNumbers decodes it.
    const double Fraction = Child % 2 == 1 ? Byte / 256.0 : 0.0;
    const double Plane = double(Node.Bounds[Axis][Upper][Child]);
    if (isMissing(Node, Child))
      Byte = Upper ? 0 : 255;
    else
      Byte = roundPlane(Planes, Upper ? Plane + Margin : Plane - Margin,
                        Fraction, Upper);
    Word |= Byte << (8 * Child);
  }
  return Word;
}

void quantizeBvh(const QuantizedBvhStorage &Storage) {
  const double MarginOfAll = 0x1p-20 * double(Storage.LargestCoordinate);
  for (uint32_t Number = 0; Number != Storage.NodeCount; ++Number)
    Storage.QuantizedNodes[Number] =
        NodeQuantizer(Storage.Nodes[Number], MarginOfAll).quantize();
}

} // namespace tp
