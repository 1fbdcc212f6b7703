//===- LaunchSetupTest.cpp - Placing a scene in memory --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/LaunchSetup.h"

#include "kernels/common/SceneFlattener.h"
#include "kernels/common/SceneLayout.h"
#include "scenes/loader/SceneLoader.h"

#include <cstring>
#include <gtest/gtest.h>

using namespace tp;

namespace {

/// A memory of a few bytes.
class SmallMemory : public LaunchMemory {
public:
  explicit SmallMemory(size_t Bytes) : Bytes(Bytes) {}

  DeviceAddress allocate(size_t Size, uint32_t Alignment) override {
    const size_t Begin = (Next + Alignment - 1) / Alignment * Alignment;
    if (Begin + Size > Bytes.size())
      return 0;
    Next = Begin + Size;
    return DeviceAddress(Begin);
  }
  void write(DeviceAddress Address, const void *Source, size_t Size) override {
    std::memcpy(&Bytes.at(Address), Source, Size);
  }
  void read(DeviceAddress Address, void *Target, size_t Size) const override {
    std::memcpy(Target, &Bytes.at(Address), Size);
  }

private:
  std::vector<uint8_t> Bytes;
  size_t Next = 4;
};

} // namespace

static Scene loadCornell() {
  ErrorOr<Scene> Loaded =
      loadScene(std::string(TP_SCENES_FOLDER) + "/cornell/cornell.gltf");
  EXPECT_TRUE(Loaded) << Loaded.message();
  return std::move(*Loaded);
}

TEST(LaunchSetup, FillsTheLaunchBlock) {
  SmallMemory Memory(1 << 16);
  RenderOptions Options;
  Options.Width = 8;
  Options.Height = 4;
  Options.SamplesPerPixel = 3;
  Options.MaxDepth = 2;
  Options.Seed = 99;
  const ErrorOr<LaunchBlock> Launch =
      setUpLaunch(loadCornell(), Options, 5, Memory);
  ASSERT_TRUE(Launch) << Launch.message();
  EXPECT_EQ(Launch->Version, kLaunchBlockVersion);
  EXPECT_EQ(Launch->Width, 8u);
  EXPECT_EQ(Launch->Height, 4u);
  EXPECT_EQ(Launch->SamplesPerPixel, 3u);
  EXPECT_EQ(Launch->MaxDepth, 2u);
  EXPECT_EQ(Launch->Seed, 99u);
  EXPECT_EQ(Launch->Scene % kSceneAlignment, 0u);
  EXPECT_EQ(Launch->ArgumentCount, 0u);

  SceneHeader Header;
  Memory.read(Launch->Scene, &Header, sizeof(Header));
  EXPECT_EQ(Header.Version, kSceneVersion);
  EXPECT_EQ(Header.TriangleCount, 38u);
  EXPECT_EQ(Header.LightCount, 2u);

  const uint32_t Pixel = 0x12345678;
  const uint32_t PiecesTaken = 10;
  Memory.write(Launch->Framebuffer + 4 * 9, &Pixel, sizeof(Pixel));
  Memory.write(Launch->WorkCounter, &PiecesTaken, sizeof(PiecesTaken));
  EXPECT_EQ(readFramebuffer(*Launch, Memory).Pixels.at(9), Pixel);
  // Of 32 pixels for five threads pieces have one pixel each; each thread has
  // its first one from the start.
  EXPECT_EQ(readPixelsTaken(*Launch, 5, Memory), 5u + 10);
  EXPECT_EQ(readRayCounts(*Launch, 5, Memory), std::vector<uint32_t>(5, 0));
}

TEST(LaunchSetup, FullMemoryIsAnError) {
  SmallMemory Memory(1 << 14);
  const ErrorOr<LaunchBlock> Launch =
      setUpLaunch(loadCornell(), RenderOptions(), 1, Memory);
  ASSERT_FALSE(Launch);
  EXPECT_NE(Launch.message().find("do not fit in the chip's memory"),
            std::string::npos);
}

TEST(LaunchSetup, ParsesImageSizes) {
  RenderOptions Options;
  EXPECT_TRUE(parseImageSize("640x480", Options));
  EXPECT_EQ(Options.Width, 640u);
  EXPECT_EQ(Options.Height, 480u);
  for (const char *Bad : {"", "x", "640", "640x", "x480", "640x480x", "6 4x4",
                          "-1x4", "0x4", "4x0", "99999999999x1", "20000x1"})
    EXPECT_FALSE(parseImageSize(Bad, Options)) << Bad;
}

TEST(LaunchSetup, ChecksOptions) {
  RenderOptions Options;
  EXPECT_TRUE(checkRenderOptions(Options));
  Options.SamplesPerPixel = 0;
  EXPECT_EQ(checkRenderOptions(Options).message(),
            "--spp: samples per pixel must be from 1 to 1048576, not 0");
  Options.SamplesPerPixel = 1;
  Options.MaxDepth = 0;
  EXPECT_FALSE(checkRenderOptions(Options));
}

TEST(LaunchSetup, FlatteningIsDeterministic) {
  EXPECT_EQ(flattenScene(loadCornell()), flattenScene(loadCornell()));
}
