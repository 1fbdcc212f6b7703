//===- QuantizedBvhTest.cpp - Quantized boxes against full ones -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/QuantizedNodes.h"
#include "kernels/common/SceneFlattener.h"
#include "kernels/pathtracer/MemoryRayTracer.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <new>
#include <random>

using namespace tp;

namespace {

using Generator = std::mt19937;

/// How to make the boxes of a node.
struct NodeKind {
  const char *Name;
  float LargestCoordinate;
  /// Of the children, along each axis.
  float Size[3];
};

/// A box as PlaneNumbers decodes it, exactly but for the last bit of a double.
struct DecodedBox {
  double Side[3][2];
};

} // namespace

static float uniform(Generator &Random, float Lower, float Upper) {
  return std::uniform_real_distribution<float>(Lower, Upper)(Random);
}

static Vector3 randomVector(Generator &Random, float Lower, float Upper) {
  const float X = uniform(Random, Lower, Upper);
  const float Y = uniform(Random, Lower, Upper);
  return {X, Y, uniform(Random, Lower, Upper)};
}

/// Children of up to the kind's size, near a point within the largest
/// coordinate.
static WideBvhNode randomNode(Generator &Random, const NodeKind &Kind,
                              unsigned Children) {
  constexpr float Far = 1e20f;
  WideBvhNode Node = {};
  for (unsigned Axis = 0; Axis != 3; ++Axis) {
    const float Range = Kind.LargestCoordinate;
    const float Size = Kind.Size[Axis];
    const float Center = uniform(Random, -Range, Range);
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      const float A = uniform(Random, Center - Size, Center + Size);
      const float B = uniform(Random, Center - Size, Center + Size);
      auto Clamp = [&](float Side) {
        return std::min(std::max(Side, -Range), Range);
      };
      const bool Missing = Child >= Children;
      Node.Bounds[Axis][0][Child] = Missing ? Far : Clamp(std::min(A, B));
      Node.Bounds[Axis][1][Child] = Missing ? -Far : Clamp(std::max(A, B));
    }
  }
  for (unsigned Child = 0; Child != Children; ++Child)
    Node.Child[Child] =
        Child % 2 ? leafReference(Child, 3) : 5 * sizeof(WideBvhNode);
  return Node;
}

static QuantizedBvhNode quantize(const WideBvhNode &Node, float Largest) {
  QuantizedBvhNode Result;
  quantizeBvh({&Node, 1, Largest, &Result});
  return Result;
}

static DecodedBox decode(const QuantizedBvhNode &Node, unsigned Child) {
  DecodedBox Box;
  PlaneNumbers Decoder;
  for (unsigned Axis = 0; Axis != 3; ++Axis)
    for (unsigned Side : {0, 1})
      Box.Side[Axis][Side] =
          double(Node.Origin[Axis]) +
          double(Decoder.decode(Node.Planes[Axis][Side]).Of[Child]) *
              double(quantizedScale(Node.Scales, Axis));
  return Box;
}

static const NodeKind Kinds[] = {
    {"common", 10, {3, 2, 1}},
    {"whole scene", 100, {100, 100, 100}},
    {"flat", 10, {3, 0, 1}},
    {"points", 10, {0, 0, 0}},
    {"needles", 10, {5, 1e-4f, 1e-5f}},
    {"tiny", 1e-20f, {1e-21f, 1e-22f, 1e-23f}},
    {"huge", 1e18f, {1e18f, 3e17f, 1e15f}},
    {"small and far away", 1e6f, {1e-3f, 1e-2f, 1}},
    {"nothing", 0, {0, 0, 0}},
};

/// Rays of all sorts from within the scene, some of them along an axis, some
/// straight at a corner of a box.
static Ray randomRay(Generator &Random, const NodeKind &Kind,
                     const WideBvhNode &Node) {
  const float Range = Kind.LargestCoordinate;
  Ray R = {randomVector(Random, -Range, Range), randomVector(Random, -1, 1)};
  switch (Random() % 4) {
  case 0:
    R.Direction = {0, 0, 0};
    (Random() % 2 ? R.Direction.X : R.Direction.Z) = Random() % 2 ? -1 : 1;
    break;
  case 1: {
    const auto Corner = [&](unsigned Axis) {
      return Node.Bounds[Axis][Random() % 2][0];
    };
    R.Direction = Vector3{Corner(0), Corner(1), Corner(2)} - R.Origin;
    if (dot(R.Direction, R.Direction) == 0)
      R.Direction.Y = 1;
    break;
  }
  case 2:
    R.Direction = R.Direction * 1e-6f;
    break;
  default:
    break;
  }
  return R;
}

template <typename Check> static void forRandomNodes(Check CheckNode) {
  for (const NodeKind &Kind : Kinds) {
    Generator Random(1);
    for (unsigned Round = 0; Round != 300; ++Round) {
      const unsigned Children = 2 + Random() % 3;
      const WideBvhNode Node = randomNode(Random, Kind, Children);
      const QuantizedBvhNode Quantized = quantize(Node, Kind.LargestCoordinate);
      CheckNode(Random, Kind, Children, Node, Quantized);
      if (testing::Test::HasFailure()) {
        ADD_FAILURE() << Kind.Name << ", round " << Round;
        return;
      }
    }
  }
}

TEST(QuantizedBvh, BytesOfAWordAreThePlanesOfTheChildren) {
  PlaneNumbers Decoder;
  for (uint32_t Word : {0u, 0xFFFFFFFFu, 0x80FF01u, 0x12345678u, 0xFF00FF00u}) {
    const PlaneNumbers::Numbers Numbers = Decoder.decode(Word);
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      const double Fraction =
          Child % 2 ? (Word >> (8 * Child - 8) & 0xFF) / 256.0 : 0.0;
      EXPECT_EQ(double(Numbers.Of[Child]),
                256 + (Word >> (8 * Child) & 0xFF) + Fraction);
    }
  }
}

TEST(QuantizedBvh, BoxContainsTheFullBoxAndHardlyMore) {
  forRandomNodes([](Generator &, const NodeKind &Kind, unsigned Children,
                    const WideBvhNode &Node, const QuantizedBvhNode &Q) {
    for (unsigned Axis = 0; Axis != 3; ++Axis) {
      double Lower = 1e30, Upper = -1e30;
      for (unsigned Child = 0; Child != Children; ++Child) {
        Lower = std::min(Lower, double(Node.Bounds[Axis][0][Child]));
        Upper = std::max(Upper, double(Node.Bounds[Axis][1][Child]));
      }
      const double Scale = double(quantizedScale(Q.Scales, Axis));
      const double Margin = double(Kind.LargestCoordinate) * 0x1p-20;
      // A scale of the last axis keeps one bit: it may be half too large.
      EXPECT_LE(Scale,
                1.51 * (Upper - Lower + 3 * Margin) / 253 + 1.1 * 0x1p-60);
      for (unsigned Child = 0; Child != Children; ++Child) {
        const DecodedBox Box = decode(Q, Child);
        const double Below =
            double(Node.Bounds[Axis][0][Child]) - Box.Side[Axis][0];
        const double Above =
            Box.Side[Axis][1] - double(Node.Bounds[Axis][1][Child]);
        EXPECT_GE(Below, Margin);
        EXPECT_GE(Above, Margin);
        EXPECT_LE(Below, 2.1 * Scale + 1.1 * Margin);
        EXPECT_LE(Above, 1.1 * Scale + 1.1 * Margin);
      }
    }
  });
}

TEST(QuantizedBvh, ReferencesNameTheSameNodesAndLeaves) {
  forRandomNodes([](Generator &, const NodeKind &, unsigned Children,
                    const WideBvhNode &Node, const QuantizedBvhNode &Q) {
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
      if (Child >= Children)
        EXPECT_EQ(Q.Child[Child], kNoBvh);
      else if (isLeaf(Node.Child[Child]))
        EXPECT_EQ(Q.Child[Child], Node.Child[Child]);
      else
        EXPECT_EQ(Q.Child[Child] / sizeof(QuantizedBvhNode),
                  Node.Child[Child] / sizeof(WideBvhNode));
  });
}

/// Then traversal misses nothing that it finds in full nodes.
TEST(QuantizedBvh, RaysEnterNoLaterAndLeaveNoEarlierThanFullBoxes) {
  unsigned Hits = 0, FullHits = 0;
  forRandomNodes([&](Generator &Random, const NodeKind &Kind, unsigned Children,
                     const WideBvhNode &Node, const QuantizedBvhNode &Q) {
    const bool IsCommon = &Kind == Kinds;
    for (unsigned Round = 0; Round != 100; ++Round) {
      const Ray R = randomRay(Random, Kind, Node);
      const BoxDistances Full =
          RayBoxTester(R).test(reinterpret_cast<const char *>(&Node), kNoChild);
      const BoxDistances Rounded = QuantizedBoxTester(R).test(
          reinterpret_cast<const char *>(&Q), kNoChild);
      for (unsigned Child = 0; Child != Children; ++Child) {
        EXPECT_LE(Rounded.Enter[Child], Full.Enter[Child]);
        EXPECT_GE(Rounded.Leave[Child], Full.Leave[Child]);
        Hits += IsCommon && Rounded.isHit(Child);
        FullHits += IsCommon && Full.isHit(Child);
      }
      for (unsigned Child = Children; Child != kWideBvhWidth; ++Child)
        EXPECT_FALSE(Rounded.isHit(Child))
            << "child " << Child << " is missing";
    }
  });
  EXPECT_GT(FullHits, 5000u);
  EXPECT_LT(Hits, 1.2 * FullHits) << "else the test says little";
}

namespace {

/// A flattened scene at the alignment that it asks for.
class FlatScene {
public:
  explicit FlatScene(const std::vector<uint8_t> &Bytes)
      : Block(static_cast<uint8_t *>(
            ::operator new(Bytes.size(), std::align_val_t(kSceneAlignment)))) {
    std::memcpy(Block, Bytes.data(), Bytes.size());
  }
  FlatScene(const FlatScene &) = delete;
  FlatScene &operator=(const FlatScene &) = delete;
  ~FlatScene() { ::operator delete(Block, std::align_val_t(kSceneAlignment)); }
  SceneView view() const { return SceneView(Block); }

private:
  uint8_t *const Block;
};

} // namespace

static Scene randomTriangles(uint32_t Count, float Size) {
  Generator Random(Count);
  Scene Result;
  Result.Materials.resize(1);
  for (uint32_t I = 0; I != Count; ++I) {
    const Vector3 Vertex = randomVector(Random, -10, 10);
    Result.Triangles.push_back(
        {{Vertex, Vertex + randomVector(Random, -Size, Size),
          Vertex + randomVector(Random, -Size, Size)},
         0});
    // Twins tie at every hit.
    if (I % 5 == 0)
      Result.Triangles.push_back(Result.Triangles.back());
  }
  return Result;
}

TEST(QuantizedBvh, TraversalFindsTheSameAsThroughFullNodes) {
  for (uint32_t Count : {1u, 3u, 40u, 3000u}) {
    const FlatScene Flat(flattenScene(randomTriangles(Count, 2)));
    const SceneView View = Flat.view();
    TraversalStack::Entry Entries[TraversalStack::Capacity];
    MemoryRayTracer<FullNodes> Full(View, Entries);
    MemoryRayTracer<QuantizedNodes> Quantized(View, Entries);
    Generator Random(Count);
    for (unsigned Round = 0; Round != 20000; ++Round) {
      const Ray R = {randomVector(Random, -10, 10),
                     randomVector(Random, -1, 1)};
      const Hit Expected = Full.findClosestHit(R, 1e30f);
      const Hit Found = Quantized.findClosestHit(R, 1e30f);
      ASSERT_EQ(Found.Triangle, Expected.Triangle);
      ASSERT_EQ(Found.Distance, Expected.Distance);
      const float End = uniform(Random, 0, 20);
      ASSERT_EQ(Quantized.isBlocked(R, End), Full.isBlocked(R, End));
    }
  }
}

TEST(QuantizedBvhDeathTest, SceneWhoseTreeTheKernelBuildsHasNone) {
  const FlatScene Flat(flattenScene(randomTriangles(9, 2), BvhOrigin::Kernel));
  EXPECT_EQ(Flat.view().QuantizedNodes, nullptr);
  EXPECT_EXIT(QuantizedNodes::nodes(Flat.view()), testing::ExitedWithCode(1),
              "error: the scene has no quantized nodes, .*--bvh host");
}
