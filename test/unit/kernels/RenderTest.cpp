//===- RenderTest.cpp - What the path tracer computes ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/native/HostMemory.h"
#include "scenes/loader/SceneLoader.h"

#include <cmath>
#include <gtest/gtest.h>

/// The path tracer's `main`.
int tpKernelMain();

using namespace tp;

namespace {

struct Rendering {
  Image Picture;
  std::vector<uint32_t> RayCounts;
};

} // namespace

static Rendering render(const Scene &Source, const RenderOptions &Options,
                        uint32_t Threads) {
  host::resetMemory();
  HostMemory Memory;
  const ErrorOr<LaunchBlock> Launch =
      setUpLaunch(Source, Options, Threads, Memory);
  EXPECT_TRUE(Launch) << Launch.message();
  EXPECT_EQ(runOnHost(tpKernelMain, Threads, *Launch), 0);
  EXPECT_EQ(readPixelsTaken(*Launch, Threads, Memory),
            Options.Width * Options.Height);
  return {readFramebuffer(*Launch, Memory),
          readRayCounts(*Launch, Threads, Memory)};
}

static uint64_t totalRays(const Rendering &R) {
  uint64_t Total = 0;
  for (uint32_t Count : R.RayCounts)
    Total += Count;
  return Total;
}

/// The mean of a channel over the picture, before its encoding.
static double meanLinear(const Image &Picture, unsigned Channel) {
  double Sum = 0;
  for (uint32_t Pixel : Picture.Pixels) {
    const double Encoded = (Pixel >> (8 * Channel) & 0xFF) / 255.0;
    Sum += Encoded <= 0.04045 ? Encoded / 12.92
                              : std::pow((Encoded + 0.055) / 1.055, 2.4);
  }
  return Sum / double(Picture.Pixels.size());
}

/// A cube of side 2 about the camera, all of one material.
static Scene makeCube(Vector3 BaseColor, Vector3 Emission) {
  Scene Cube;
  Cube.Materials = {{"all", BaseColor, Emission}};
  Cube.Camera.VerticalFieldOfView = 1.5f;
  for (int Axis = 0; Axis != 3; ++Axis)
    for (float Side : {-1.0f, 1.0f}) {
      auto Corner = [&](float U, float V) {
        const float Coordinates[3] = {Side, U, V};
        return Vector3{Coordinates[(3 - Axis) % 3], Coordinates[(4 - Axis) % 3],
                       Coordinates[(5 - Axis) % 3]};
      };
      Cube.Triangles.push_back(
          {{Corner(-1, -1), Corner(1, -1), Corner(1, 1)}, 0});
      Cube.Triangles.push_back(
          {{Corner(-1, -1), Corner(1, 1), Corner(-1, 1)}, 0});
    }
  return Cube;
}

static Scene loadCornell() {
  ErrorOr<Scene> Loaded =
      loadScene(std::string(TP_SCENES_FOLDER) + "/cornell/cornell.gltf");
  EXPECT_TRUE(Loaded) << Loaded.message();
  return std::move(*Loaded);
}

/// In a closed room whose walls all emit E and reflect a share s, each further
/// vertex of the paths adds the next term of E (1 + s + s^2 + ...): light
/// sampling, bounces, throughput and their factors of pi are all in it.
TEST(Render, FurnaceHasTheRadianceOfTheGeometricSeries) {
  const Scene Cube = makeCube({0.5f, 0.25f, 0.75f}, {0.1f, 0.1f, 0.1f});
  const double Shares[3] = {0.5, 0.25, 0.75};
  for (uint32_t Depth : {1u, 2u, 3u, 5u}) {
    RenderOptions Options;
    Options.Width = Options.Height = 16;
    Options.SamplesPerPixel = 512;
    Options.MaxDepth = Depth;
    const Rendering R = render(Cube, Options, 2);
    for (unsigned Channel = 0; Channel != 3; ++Channel) {
      double Expected = 0;
      for (uint32_t Term = 0; Term <= Depth; ++Term)
        Expected += 0.1 * std::pow(Shares[Channel], Term);
      EXPECT_NEAR(meanLinear(R.Picture, Channel), Expected, Expected * 0.01)
          << "depth " << Depth << ", channel " << Channel;
    }
  }
}

TEST(Render, DoesNotDependOnTheNumberOfThreads) {
  const Scene Box = loadCornell();
  RenderOptions Options;
  Options.Width = 40;
  Options.Height = 24;
  Options.SamplesPerPixel = 2;
  Options.MaxDepth = 3;
  const Rendering One = render(Box, Options, 1), Four = render(Box, Options, 4);
  EXPECT_EQ(One.Picture.Pixels, Four.Picture.Pixels);
  EXPECT_EQ(totalRays(One), totalRays(Four));
}

TEST(Render, SeedChangesThePicture) {
  const Scene Box = loadCornell();
  RenderOptions Options;
  Options.Width = Options.Height = 16;
  const Rendering First = render(Box, Options, 1);
  Options.Seed = 2;
  EXPECT_NE(First.Picture.Pixels, render(Box, Options, 1).Picture.Pixels);
}

TEST(Render, CornellBoxIsRedOnTheLeftAndLitFromAbove) {
  RenderOptions Options;
  Options.Width = Options.Height = 64;
  Options.SamplesPerPixel = 16;
  Options.MaxDepth = 2;
  const Image Picture = render(loadCornell(), Options, 2).Picture;
  auto Channel = [&](uint32_t X, uint32_t Y, unsigned Index) {
    return Picture.Pixels[Y * 64 + X] >> (8 * Index) & 0xFF;
  };
  EXPECT_GT(Channel(5, 32, 0), 3 * Channel(5, 32, 1)) << "red wall";
  EXPECT_GT(3 * Channel(58, 32, 1), 4 * Channel(58, 32, 0)) << "green wall";
  EXPECT_EQ(Picture.Pixels[9 * 64 + 32], 0xFFFFFFFFu) << "light";
  for (uint32_t Pixel : Picture.Pixels)
    ASSERT_EQ(Pixel >> 24, 0xFFu) << "every pixel is written";
}

TEST(Render, CountsPrimaryAndShadowRays) {
  RenderOptions Options;
  Options.Width = Options.Height = 32;
  Options.SamplesPerPixel = 4;
  // Every primary ray hits, and sees every light but its own plane's.
  const Rendering Lit = render(makeCube({1, 1, 1}, {1, 1, 1}), Options, 1);
  EXPECT_GT(totalRays(Lit), 32u * 32 * 4 * 3 / 2);
  EXPECT_LE(totalRays(Lit), 32u * 32 * 4 * 2);
  // Without light there are no shadow rays, and black walls end the paths.
  Options.MaxDepth = 4;
  const Rendering Dark = render(makeCube({1, 1, 1}, {0, 0, 0}), Options, 1);
  EXPECT_EQ(totalRays(Dark), 32u * 32 * 4 * 4);
  const Rendering Black = render(makeCube({0, 0, 0}, {1, 1, 1}), Options, 1);
  EXPECT_EQ(totalRays(Black), 32u * 32 * 4);
}

TEST(Render, PictureCanBeOfAnyShape) {
  RenderOptions Options;
  Options.Width = 1;
  Options.Height = 1;
  EXPECT_EQ(render(loadCornell(), Options, 3).Picture.Pixels.size(), 1u);
  Options.Width = 200;
  const Image Wide = render(makeCube({0, 0, 0}, {1, 0, 0}), Options, 1).Picture;
  for (uint32_t Pixel : Wide.Pixels)
    EXPECT_EQ(Pixel, 0xFF0000FFu);
}
