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
#include "kernels/pathtracer/MemoryRayTracer.h"
#include "scenes/loader/SceneLoader.h"

#include <cmath>
#include <cstring>
#include <embree3/rtcore.h>
#include <gtest/gtest.h>
#include <memory>
#include <new>
#include <random>

using namespace tp;

namespace {

/// The scene as Embree sees it.
class EmbreeOracle {
public:
  explicit EmbreeOracle(const Scene &Source)
      : Device(rtcNewDevice("threads=1")), World(rtcNewScene(Device)) {
    RTCGeometry Geometry = rtcNewGeometry(Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const size_t Count = Source.Triangles.size();
    auto *Vertices = static_cast<float *>(rtcSetNewGeometryBuffer(
        Geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
        3 * sizeof(float), 3 * Count));
    auto *Indices = static_cast<uint32_t *>(
        rtcSetNewGeometryBuffer(Geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), Count));
    for (size_t Corner = 0; Corner != 3 * Count; ++Corner) {
      std::memcpy(Vertices + 3 * Corner,
                  &Source.Triangles[Corner / 3].Vertices[Corner % 3],
                  sizeof(Vector3));
      Indices[Corner] = uint32_t(Corner);
    }
    rtcCommitGeometry(Geometry);
    rtcAttachGeometry(World, Geometry);
    rtcReleaseGeometry(Geometry);
    rtcSetSceneFlags(World, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(World);
  }
  ~EmbreeOracle() {
    rtcReleaseScene(World);
    rtcReleaseDevice(Device);
  }

  /// The distance of the first hit, or a negative number.
  float distance(const Ray &R, float MaxDistance) const {
    RTCRayHit Query{};
    setRay(Query.ray, R, MaxDistance);
    Query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext Context;
    rtcInitIntersectContext(&Context);
    rtcIntersect1(World, &Context, &Query);
    return Query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : Query.ray.tfar;
  }

  bool isBlocked(const Ray &R, float MaxDistance) const {
    RTCRay Query{};
    setRay(Query, R, MaxDistance);
    RTCIntersectContext Context;
    rtcInitIntersectContext(&Context);
    rtcOccluded1(World, &Context, &Query);
    return Query.tfar < 0;
  }

private:
  static void setRay(RTCRay &Query, const Ray &R, float MaxDistance) {
    Query.org_x = R.Origin.X;
    Query.org_y = R.Origin.Y;
    Query.org_z = R.Origin.Z;
    Query.dir_x = R.Direction.X;
    Query.dir_y = R.Direction.Y;
    Query.dir_z = R.Direction.Z;
    Query.tfar = MaxDistance;
    Query.mask = ~0u;
  }

  RTCDevice Device;
  RTCScene World;
};

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
  const EmbreeOracle Oracle(Source);
  const FlatScene Flat(Source);
  TraversalStack::Entry Entries[TraversalStack::Capacity];
  MemoryRayTracer<> Rays(Flat.view(), Entries);
  Comparison Result;
  for (; Result.Rays != Count; ++Result.Rays) {
    const Ray R = Make();
    const float Expected = Oracle.distance(R, 1e30f);
    const Hit Found = Rays.findClosestHit(R, 1e30f);
    const bool IsHit = Found.Triangle != kNoTriangle;
    Result.Hits += IsHit;
    const bool Agrees = IsHit ? std::abs(Found.Distance - Expected) <=
                                    RelativeError * (std::abs(Expected) + 1)
                              : Expected < 0;
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

/// A closed box: no ray from inside may escape but through an edge.
TEST(Intersection, RaysInTheCornellBoxDoNotLeak) {
  const ErrorOr<Scene> Box =
      loadScene(std::string(TP_SCENES_FOLDER) + "/cornell/cornell.gltf");
  ASSERT_TRUE(Box) << Box.message();
  const FlatScene Flat(*Box);
  TraversalStack::Entry Entries[TraversalStack::Capacity];
  MemoryRayTracer<> Rays(Flat.view(), Entries);
  std::mt19937 Generator(9);
  unsigned Escaped = 0;
  for (unsigned I = 0; I != 200000; ++I) {
    // From the middle, away from the open front.
    Vector3 Direction = randomVector(Generator, -1, 1);
    Direction.Z = std::abs(Direction.Z) + 0.5f;
    const Ray R{{278, 400, 100}, Direction};
    Escaped += Rays.findClosestHit(R, 1e30f).Triangle == kNoTriangle;
  }
  EXPECT_LE(Escaped, 2u);
}
