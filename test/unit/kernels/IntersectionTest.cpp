//===- IntersectionTest.cpp - Our traversal against Embree ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Embree shares nothing with our code. Both round differently, so a ray that
// grazes an edge may hit one triangle here and its neighbour, or nothing,
// there: such differences must be rare, and equal in distance when both hit.
//
//===----------------------------------------------------------------------===//

#include "kernels/common/SceneFlattener.h"
#include "kernels/embree/EmbreeScene.h"
#include "kernels/embree/ExactHits.h"
#include "kernels/pathtracer/MemoryRayTracer.h"
#include "scenes/loader/SceneLoader.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <new>
#include <random>

using namespace tp;

namespace {

/// A flattened scene at the alignment that it asks for.
class FlatScene {
public:
  explicit FlatScene(const Scene &Source) {
    const std::vector<uint8_t> Bytes = flattenScene(Source);
    Block.reset(static_cast<uint8_t *>(
        ::operator new(Bytes.size(), std::align_val_t(kSceneAlignment))));
    std::memcpy(Block.get(), Bytes.data(), Bytes.size());
  }
  SceneView view() const { return SceneView(Block.get()); }

private:
  struct Free {
    void operator()(uint8_t *Memory) const {
      ::operator delete(Memory, std::align_val_t(kSceneAlignment));
    }
  };
  std::unique_ptr<uint8_t, Free> Block;
};

struct Comparison {
  unsigned Rays = 0;
  unsigned Hits = 0;
  unsigned Disagreements = 0;
};

} // namespace

template <typename MakeRay>
static Comparison compare(const Scene &Source, unsigned Count,
                          float RelativeError, MakeRay Make) {
  const FlatScene Flat(Source);
  const EmbreeScene Oracle(Flat.view());
  TraversalStack::Entry Entries[TraversalStack::Capacity];
  MemoryRayTracer<> Rays(Flat.view(), Entries);
  Comparison Result;
  for (; Result.Rays != Count; ++Result.Rays) {
    const Ray R = Make();
    const Hit Expected = Oracle.findClosestHit(R);
    const Hit Found = Rays.findClosestHit(R, 1e30f);
    const bool IsHit = Found.Triangle != kNoTriangle;
    Result.Hits += IsHit;
    const bool Agrees =
        IsHit ? std::abs(Found.Distance - Expected.Distance) <=
                    RelativeError * (std::abs(Expected.Distance) + 1)
              : Expected.Triangle == kNoTriangle;
    Result.Disagreements += !Agrees;

    const float End = IsHit ? Found.Distance * 1.5f : 1000.0f;
    for (float MaxDistance : {End * 0.5f, End}) {
      const bool Blocked = Rays.isBlocked(R, MaxDistance);
      Result.Disagreements += Blocked != Oracle.isBlocked(R, MaxDistance);
      EXPECT_EQ(Blocked, IsHit && Found.Distance < MaxDistance)
          << "both queries find the same";
    }
  }
  return Result;
}

static Vector3 randomVector(std::mt19937 &Generator, float Lower, float Upper) {
  std::uniform_real_distribution<float> Range(Lower, Upper);
  const float X = Range(Generator), Y = Range(Generator);
  return {X, Y, Range(Generator)};
}

static Scene randomTriangles(uint32_t Count, float Size) {
  std::mt19937 Generator(Count);
  Scene Result;
  Result.Materials.resize(1);
  for (uint32_t I = 0; I != Count; ++I) {
    const Vector3 Vertex = randomVector(Generator, -10, 10);
    Result.Triangles.push_back(
        {{Vertex, Vertex + randomVector(Generator, -Size, Size),
          Vertex + randomVector(Generator, -Size, Size)},
         0});
  }
  return Result;
}

TEST(Intersection, CornellBoxAgreesWithEmbree) {
  const ErrorOr<Scene> Box =
      loadScene(std::string(TP_SCENES_FOLDER) + "/cornell/cornell.gltf");
  ASSERT_TRUE(Box) << Box.message();
  std::mt19937 Generator(1);
  const Comparison Camera = compare(*Box, 20000, 1e-4f, [&] {
    const Vector3 Target = randomVector(Generator, -0.36f, 0.36f);
    return Ray{Box->Camera.Position, {Target.X, Target.Y, 1}};
  });
  EXPECT_GT(Camera.Hits, 18000u);
  EXPECT_LE(Camera.Disagreements, 5u);
  const Comparison Inside = compare(*Box, 50000, 1e-4f, [&] {
    return Ray{randomVector(Generator, 1, 540), randomVector(Generator, -1, 1)};
  });
  EXPECT_GT(Inside.Hits, 30000u);
  EXPECT_LE(Inside.Disagreements, 10u);
}

TEST(Intersection, RandomTrianglesAgreeWithEmbree) {
  for (uint32_t Count : {1u, 2u, 7u, 100u, 5000u}) {
    std::mt19937 Generator(Count + 1);
    const Comparison Result =
        compare(randomTriangles(Count, 3), 20000, 1e-3f, [&] {
          return Ray{randomVector(Generator, -12, 12),
                     randomVector(Generator, -1, 1)};
        });
    EXPECT_GT(Result.Hits, Count >= 5000 ? 10000u : 10u);
    EXPECT_LE(Result.Disagreements, 20u) << Count << " triangles";
  }
}

/// Directions with zero components make the box test's worst case.
TEST(Intersection, AxisParallelRaysAgreeWithEmbree) {
  const float Axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::mt19937 Generator(5);
  unsigned Next = 0;
  const Comparison Result = compare(randomTriangles(500, 4), 12000, 1e-3f, [&] {
    const float Sign = Next & 1 ? -1.0f : 1.0f;
    const float *Axis = Axes[Next++ / 2 % 3];
    return Ray{randomVector(Generator, -12, 12),
               {Sign * Axis[0], Sign * Axis[1], Sign * Axis[2]}};
  });
  EXPECT_GT(Result.Hits, 6000u);
  EXPECT_LE(Result.Disagreements, 12u);
}

/// A sphere about the origin, of radius 10 with bumps, without a hole.
static Scene bumpySphere(std::mt19937 &Generator) {
  constexpr unsigned Rows = 24, Columns = 48;
  std::uniform_real_distribution<float> Radius(9, 11);
  std::vector<Vector3> Points;
  for (unsigned Row = 0; Row <= Rows; ++Row)
    for (unsigned Column = 0; Column != Columns; ++Column) {
      // All points of the first and last row are one.
      const bool IsPole = Row == 0 || Row == Rows;
      if (IsPole && Column != 0) {
        Points.push_back(Points.back());
        continue;
      }
      const double Polar = M_PI * Row / Rows,
                   Turn = 2 * M_PI * Column / Columns;
      const float R = Radius(Generator);
      Points.push_back({R * float(std::sin(Polar) * std::cos(Turn)),
                        R * float(std::sin(Polar) * std::sin(Turn)),
                        R * float(std::cos(Polar))});
    }
  Scene Result;
  Result.Materials.resize(1);
  for (unsigned Row = 0; Row != Rows; ++Row)
    for (unsigned Column = 0; Column != Columns; ++Column) {
      const unsigned Next = (Column + 1) % Columns;
      const Vector3 A = Points[Row * Columns + Column];
      const Vector3 B = Points[Row * Columns + Next];
      const Vector3 C = Points[(Row + 1) * Columns + Column];
      const Vector3 D = Points[(Row + 1) * Columns + Next];
      if (Row != 0)
        Result.Triangles.push_back({{A, B, C}, 0});
      if (Row + 1 != Rows)
        Result.Triangles.push_back({{B, D, C}, 0});
    }
  return Result;
}

/// No ray from inside a closed surface escapes, also where it meets edges and
/// corners as exactly as floats allow.
TEST(Intersection, RaysAtSharedEdgesDoNotLeak) {
  std::mt19937 Generator(9);
  const Scene Sphere = bumpySphere(Generator);
  const FlatScene Flat(Sphere);
  TraversalStack::Entry Entries[TraversalStack::Capacity];
  MemoryRayTracer<> Rays(Flat.view(), Entries);
  std::uniform_int_distribution<size_t> Number(0, Sphere.Triangles.size() - 1);
  std::uniform_real_distribution<float> Share(0, 1);
  for (unsigned I = 0; I != 300000; ++I) {
    const Vector3(&Corners)[3] = Sphere.Triangles[Number(Generator)].Vertices;
    const Vector3 Along = Corners[(I + 1) % 3] - Corners[I % 3];
    const Vector3 Target =
        Corners[I % 3] + Along * (I % 4 == 0 ? 0.0f : Share(Generator));
    const Vector3 Origin = randomVector(Generator, -4, 4);
    ASSERT_NE(Rays.findClosestHit({Origin, Target - Origin}, 1e30f).Triangle,
              kNoTriangle);
    ASSERT_TRUE(Rays.isBlocked({Origin, Target - Origin}, 2.0f));
  }
}

/// Two walls in one place: the first in number is hit, whatever the order.
TEST(Intersection, EqualDistancesGoToTheLowerNumber) {
  Hit Found{1e30f, kNoTriangle};
  for (uint32_t Triangle : {7u, 3u, 5u})
    Found.take(2.0f, Triangle);
  EXPECT_EQ(Found.Triangle, 3u);
  Found.take(1.5f, 9);
  EXPECT_EQ(Found.Triangle, 9u);
}

TEST(ExactHits, TellHowFarARayPassesFromTheEdge) {
  TriangleRecord Triangle{};
  Triangle.Corners[1] = {4, 0, 0};
  Triangle.Corners[2] = {0, 4, 0};
  const Ray Inside{{1, 0.25f, -3}, {0, 0, 2}};
  EXPECT_EQ(passTriangle(Triangle, Inside).Distance, 1.5);
  EXPECT_EQ(passTriangle(Triangle, Inside).Margin, 0.25);
  const Ray Outside{{1, -0.5f, 3}, {0, 0, -1}};
  EXPECT_EQ(passTriangle(Triangle, Outside).Margin, -0.5);
}
