//===- LaunchSetup.cpp - Preparing a rendering kernel's run ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/LaunchSetup.h"

#include "kernels/common/SceneLayout.h"
#include "kernels/common/WorkSchedule.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace tp {

static Status checkRange(const char *Option, const char *What, uint32_t Value,
                         uint32_t Limit) {
  if (Value >= 1 && Value <= Limit)
    return success();
  return Error{std::string(Option) + ": " + What + " must be from 1 to " +
               std::to_string(Limit) + ", not " + std::to_string(Value)};
}

Status checkRenderOptions(const RenderOptions &Options) {
  for (Status Check :
       {checkRange("--size", "the width", Options.Width, kMaxImageSide),
        checkRange("--size", "the height", Options.Height, kMaxImageSide),
        checkRange("--spp", "samples per pixel", Options.SamplesPerPixel,
                   kMaxSamplesPerPixel),
        checkRange("--depth", "the depth", Options.MaxDepth, kMaxPathDepth)})
    if (!Check)
      return Check;
  return success();
}

Status parseImageSize(std::string_view Text, RenderOptions &Options) {
  const char *const Begin = Text.data();
  const char *const End = Begin + Text.size();
  const auto Width = std::from_chars(Begin, End, Options.Width);
  const bool HasSecond =
      Width.ec == std::errc() && Width.ptr != End && *Width.ptr == 'x';
  if (HasSecond) {
    const auto Height = std::from_chars(Width.ptr + 1, End, Options.Height);
    if (Height.ec == std::errc() && Height.ptr == End)
      return checkRenderOptions(Options);
  }
  return Error{"--size: '" + std::string(Text) +
               "' is not of the form WIDTHxHEIGHT, as in 256x256"};
}

Status parseBvhOrigin(std::string_view Text, RenderOptions &Options) {
  if (Text != "host" && Text != "kernel")
    return Error{"--bvh: '" + std::string(Text) +
                 "' is neither 'host' nor 'kernel'"};
  Options.Bvh = Text == "host" ? BvhOrigin::Host : BvhOrigin::Kernel;
  return success();
}

ErrorOr<LaunchBlock> setUpLaunch(const Scene &Source,
                                 const RenderOptions &Options,
                                 uint32_t ThreadCount, LaunchMemory &Memory) {
  if (Options.Bvh == BvhOrigin::Kernel &&
      Source.Triangles.size() > kMaxWorkspaceTriangles)
    return Error{"--bvh: a kernel builds trees of at most " +
                 std::to_string(kMaxWorkspaceTriangles) +
                 " triangles; the scene has " +
                 std::to_string(Source.Triangles.size())};
  const uint32_t Padding = Options.PaddingBytes;
  const std::vector<uint8_t> Block = flattenScene(Source, Options.Bvh, Padding);
  const size_t PixelBytes =
      size_t(Options.Width) * Options.Height * sizeof(uint32_t);
  LaunchBlock Launch{};
  Launch.Version = kLaunchBlockVersion;
  Launch.Scene = Memory.allocate(Block.size(), kSceneAlignment);
  auto Allocate = [&](size_t Bytes) {
    return Memory.allocate(Bytes + Padding, sizeof(uint32_t));
  };
  Launch.Framebuffer = Allocate(PixelBytes);
  Launch.RayCounts = Allocate(ThreadCount * sizeof(uint32_t));
  Launch.WorkCounter = Allocate(sizeof(uint32_t));
  if (!Launch.Scene || !Launch.Framebuffer || !Launch.RayCounts ||
      !Launch.WorkCounter)
    return Error{"the scene (" + std::to_string(Block.size()) +
                 " bytes) and the picture (" + std::to_string(PixelBytes) +
                 " bytes) do not fit in the chip's memory"};
  Memory.write(Launch.Scene, Block.data(), Block.size());
  Launch.Width = Options.Width;
  Launch.Height = Options.Height;
  Launch.SamplesPerPixel = Options.SamplesPerPixel;
  Launch.MaxDepth = Options.MaxDepth;
  Launch.Seed = Options.Seed;
  return Launch;
}

Image readFramebuffer(const LaunchBlock &Launch, const LaunchMemory &Memory) {
  Image Picture{Launch.Width, Launch.Height, {}};
  Picture.Pixels.resize(size_t(Launch.Width) * Launch.Height);
  Memory.read(Launch.Framebuffer, Picture.Pixels.data(),
              Picture.Pixels.size() * sizeof(uint32_t));
  return Picture;
}

/// An array of one word per thread.
static std::vector<uint32_t> readWords(DeviceAddress Address,
                                       uint32_t ThreadCount,
                                       const LaunchMemory &Memory) {
  std::vector<uint32_t> Words(ThreadCount);
  Memory.read(Address, Words.data(), Words.size() * sizeof(uint32_t));
  return Words;
}

std::vector<uint32_t> readRayCounts(const LaunchBlock &Launch,
                                    uint32_t ThreadCount,
                                    const LaunchMemory &Memory) {
  return readWords(Launch.RayCounts, ThreadCount, Memory);
}

uint32_t readPixelsTaken(const LaunchBlock &Launch, uint32_t ThreadCount,
                         const LaunchMemory &Memory) {
  uint32_t PiecesTaken = 0;
  Memory.read(Launch.WorkCounter, &PiecesTaken, sizeof(PiecesTaken));
  return WorkSchedule(Launch.Width * Launch.Height, ThreadCount)
      .piece(ThreadCount + PiecesTaken)
      .Begin;
}

} // namespace tp
