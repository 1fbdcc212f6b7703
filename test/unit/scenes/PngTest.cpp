//===- PngTest.cpp - Writing and reading pictures -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "scenes/image/PngWriter.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

using namespace tp;

static std::string temporaryPath(const std::string &Name) {
  return testing::TempDir() + "tp-png-" + Name;
}

static Image makeGradient(uint32_t Width, uint32_t Height) {
  Image Picture{Width, Height, {}};
  for (uint32_t Y = 0; Y != Height; ++Y)
    for (uint32_t X = 0; X != Width; ++X)
      Picture.Pixels.push_back(X * 7 | Y * 11 << 8 | (X ^ Y) << 16 |
                               (255 - X) << 24);
  return Picture;
}

TEST(Png, RoundTripKeepsEveryPixel) {
  const Image Written = makeGradient(31, 17);
  const std::string Path = temporaryPath("round-trip.png");
  ASSERT_TRUE(writePng(Path, Written));
  const ErrorOr<Image> Read = readPng(Path);
  ASSERT_TRUE(Read) << Read.message();
  EXPECT_EQ(Read->Width, 31u);
  EXPECT_EQ(Read->Height, 17u);
  EXPECT_EQ(Read->Pixels, Written.Pixels);
  std::remove(Path.c_str());
}

TEST(Png, FirstPixelIsTopLeftAndRedIsTheLowestByte) {
  const Image Written{1, 2, {0xFF0000FF, 0xFFFF0000}};
  const std::string Path = temporaryPath("order.png");
  ASSERT_TRUE(writePng(Path, Written));
  // A PNG's rows run from the top; the colour type 6 is RGBA.
  std::ifstream File(Path, std::ios::binary);
  char Bytes[26];
  ASSERT_TRUE(File.read(Bytes, sizeof(Bytes)));
  EXPECT_EQ(Bytes[25], 6);
  const ErrorOr<Image> Read = readPng(Path);
  ASSERT_TRUE(Read);
  EXPECT_EQ(Read->Pixels[0] & 0xFF, 0xFFu);
  EXPECT_EQ(Read->Pixels[1] >> 16 & 0xFF, 0xFFu);
  std::remove(Path.c_str());
}

TEST(Png, UnwritablePathIsAnErrorThatNamesIt) {
  const Status Written =
      writePng("/nonexistent-folder/a.png", Image{1, 1, {0}});
  ASSERT_FALSE(Written);
  EXPECT_EQ(Written.message(),
            "/nonexistent-folder/a.png: No such file or directory");
}

TEST(Png, EmptyPictureIsAnError) {
  EXPECT_FALSE(writePng(temporaryPath("empty.png"), Image{}));
}

TEST(Png, FullDiskIsAnErrorAndDevicesStay) {
  EXPECT_FALSE(writePng("/dev/full", makeGradient(300, 300)));
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

TEST(Png, ReadingDamagedFilesIsAnError) {
  EXPECT_FALSE(readPng("/nonexistent-folder/a.png"));
  const std::string Path = temporaryPath("damaged.png");
  FILE *File = std::fopen(Path.c_str(), "wb");
  std::fputs("no picture", File);
  std::fclose(File);
  EXPECT_FALSE(readPng(Path));
  std::remove(Path.c_str());
}
