//===- SceneFilesTest.cpp - The scenes that come with the project ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "scenes/loader/SceneLoader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

using namespace tp;

static float areaOf(const Triangle &Shape) {
  const Vector3 Normal = cross(Shape.Vertices[1] - Shape.Vertices[0],
                               Shape.Vertices[2] - Shape.Vertices[0]);
  return std::sqrt(dot(Normal, Normal)) / 2;
}

static void expectNear(Vector3 Actual, Vector3 Expected, float Tolerance) {
  EXPECT_NEAR(Actual.X, Expected.X, Tolerance);
  EXPECT_NEAR(Actual.Y, Expected.Y, Tolerance);
  EXPECT_NEAR(Actual.Z, Expected.Z, Tolerance);
}

TEST(CornellBox, HasTheMeasuredCameraAndLight) {
  const ErrorOr<Scene> Box =
      loadScene(TP_SCENES_FOLDER "/cornell/cornell.gltf");
  ASSERT_TRUE(Box) << Box.message();
  EXPECT_TRUE(Box->Warnings.empty());
  // Floor, back, two walls and light of 2 triangles, ceiling 8, blocks 10 each.
  EXPECT_EQ(Box->Triangles.size(), 38u);
  expectNear(Box->Camera.Position, {278, 273, -800}, 0);
  expectNear(Box->Camera.Forward, {0, 0, 1}, 1e-6f);
  expectNear(Box->Camera.Up, {0, 1, 0}, 1e-6f);
  // Looking along +z with y up, larger x (the red wall) is on the left.
  expectNear(Box->Camera.Right, {-1, 0, 0}, 1e-6f);
  EXPECT_NEAR(std::tan(Box->Camera.VerticalFieldOfView / 2), 0.0125 / 0.035,
              1e-6);

  float LightArea = 0, WhiteArea = 0;
  for (const Triangle &Shape : Box->Triangles) {
    const Material &Surface = Box->Materials[Shape.Material];
    if (Surface.isEmissive()) {
      expectNear(Surface.Emission, {17, 12, 4}, 0);
      LightArea += areaOf(Shape);
    }
    if (Surface.Name == "white")
      WhiteArea += areaOf(Shape);
    if (Surface.Name == "red")
      EXPECT_GT(Shape.Vertices[0].X, 500);
    if (Surface.Name == "green")
      EXPECT_EQ(Shape.Vertices[0].X, 0);
  }
  EXPECT_FLOAT_EQ(LightArea, 130 * 105);
  EXPECT_GT(WhiteArea, 0);
}

TEST(CornellBox, CeilingAndLightFillTheMeasuredCeiling) {
  const ErrorOr<Scene> Box =
      loadScene(TP_SCENES_FOLDER "/cornell/cornell.gltf");
  ASSERT_TRUE(Box) << Box.message();
  float Area = 0;
  for (const Triangle &Shape : Box->Triangles)
    if (std::all_of(std::begin(Shape.Vertices), std::end(Shape.Vertices),
                    [](Vector3 V) { return V.Y == 548.8f; })) {
      Area += areaOf(Shape);
      const Vector3 Normal = cross(Shape.Vertices[1] - Shape.Vertices[0],
                                   Shape.Vertices[2] - Shape.Vertices[0]);
      EXPECT_LT(Normal.Y, 0) << "the front looks down into the room";
    }
  EXPECT_NEAR(Area, 556 * 559.2, 0.1);
}

TEST(Instances, PlacesEveryInstance) {
  const ErrorOr<Scene> Loaded =
      loadScene(TP_SCENES_FOLDER "/instances/instances.glb");
  ASSERT_TRUE(Loaded) << Loaded.message();
  EXPECT_TRUE(Loaded->Warnings.empty());
  // Fan 2, strip 2, three pyramids of 4, one bare triangle.
  ASSERT_EQ(Loaded->Triangles.size(), 17u);
  auto HasVertex = [&](Vector3 Wanted) {
    for (const Triangle &Shape : Loaded->Triangles)
      for (Vector3 Vertex : Shape.Vertices) {
        const Vector3 Away = Vertex - Wanted;
        if (dot(Away, Away) < 1e-8f)
          return true;
      }
    return false;
  };
  EXPECT_TRUE(HasVertex({-3, 2, 0})) << "tip of the translated pyramid";
  EXPECT_TRUE(HasVertex({0, 3, -1})) << "tip of the scaled pyramid";
  EXPECT_TRUE(HasVertex({3, 1, 0})) << "tip of the mirrored pyramid";
  EXPECT_TRUE(HasVertex({-2, 2.5f, 0})) << "flag under the translated node";
  // (1, 0, 1) turned by 30 degrees about +y, then moved by -1 in z.
  const float C = std::cos(M_PI / 6), S = std::sin(M_PI / 6);
  EXPECT_TRUE(HasVertex({C + S, 0, C - S - 1})) << "turned corner";
}

TEST(Instances, MirroringKeepsFrontsOutside) {
  const ErrorOr<Scene> Loaded =
      loadScene(TP_SCENES_FOLDER "/instances/instances.glb");
  ASSERT_TRUE(Loaded) << Loaded.message();
  unsigned Sides = 0;
  for (const Triangle &Shape : Loaded->Triangles) {
    if (Loaded->Materials[Shape.Material].Name != "blue")
      continue;
    ++Sides;
    const Vector3 Normal = cross(Shape.Vertices[1] - Shape.Vertices[0],
                                 Shape.Vertices[2] - Shape.Vertices[0]);
    EXPECT_GT(Normal.Y, 0) << "a pyramid's sides look up";
  }
  EXPECT_EQ(Sides, 12u);
}

TEST(Instances, CameraFollowsItsParents) {
  const ErrorOr<Scene> Loaded =
      loadScene(TP_SCENES_FOLDER "/instances/instances.glb");
  ASSERT_TRUE(Loaded) << Loaded.message();
  const float C = std::cos(M_PI / 9), S = std::sin(M_PI / 9);
  expectNear(Loaded->Camera.Position, {0, 1 + 12 * S, 12 * C}, 1e-5f);
  expectNear(Loaded->Camera.Forward, {0, -S, -C}, 1e-6f);
  expectNear(Loaded->Camera.Up, {0, C, -S}, 1e-6f);
  expectNear(Loaded->Camera.Right, {1, 0, 0}, 1e-6f);
}

/// Every prefix of a GLB must be refused, not crash.
TEST(Instances, TruncatedBinaryIsAnErrorAtEveryLength) {
  std::ifstream File(TP_SCENES_FOLDER "/instances/instances.glb",
                     std::ios::binary);
  const std::string Whole{std::istreambuf_iterator<char>(File), {}};
  ASSERT_GT(Whole.size(), 1000u);
  const std::string Path = testing::TempDir() + "tp-truncated.glb";
  for (size_t Length = 0; Length < Whole.size();
       Length += Length < 64 ? 1 : 37) {
    std::ofstream(Path, std::ios::binary).write(Whole.data(), Length);
    const ErrorOr<Scene> Loaded = loadScene(Path);
    ASSERT_FALSE(Loaded) << Length << " bytes";
    EXPECT_EQ(Loaded.message().rfind(Path + ": ", 0), 0u) << Loaded.message();
  }
  std::remove(Path.c_str());
}
