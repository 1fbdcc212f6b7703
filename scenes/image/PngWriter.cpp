//===- PngWriter.cpp - PNG files ------------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "scenes/image/PngWriter.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <png.h>

namespace tp {

static std::vector<png_byte> toBytes(const Image &Picture) {
  std::vector<png_byte> Bytes;
  Bytes.reserve(Picture.Pixels.size() * 4);
  for (uint32_t Pixel : Picture.Pixels)
    for (unsigned Channel = 0; Channel != 4; ++Channel)
      Bytes.push_back(static_cast<png_byte>(Pixel >> (8 * Channel)));
  return Bytes;
}

static Error pngError(const std::string &Path, const char *Reason) {
  return Error{Path + ": " + Reason};
}

/// Leaves devices and pipes alone.
static void removeRegularFile(const std::string &Path) {
  std::error_code Ignored;
  if (std::filesystem::is_regular_file(Path, Ignored))
    std::filesystem::remove(Path, Ignored);
}

Status writePng(const std::string &Path, const Image &Picture) {
  assert(Picture.Pixels.size() == size_t(Picture.Width) * Picture.Height);
  if (Picture.Pixels.empty())
    return pngError(Path, "a PNG needs at least one pixel");

  FILE *File = std::fopen(Path.c_str(), "wb");
  if (!File)
    return pngError(Path, std::strerror(errno));

  const std::vector<png_byte> Bytes = toBytes(Picture);
  png_image Header{};
  Header.version = PNG_IMAGE_VERSION;
  Header.width = Picture.Width;
  Header.height = Picture.Height;
  Header.format = PNG_FORMAT_RGBA;
  const bool Written =
      png_image_write_to_stdio(&Header, File, /*convert_to_8_bit=*/0,
                               Bytes.data(), /*row_stride=*/0, nullptr) != 0;
  errno = 0;
  const bool Closed = std::fclose(File) == 0;
  if (Written && Closed)
    return success();
  const std::string Reason = Written ? std::strerror(errno) : Header.message;
  removeRegularFile(Path);
  return pngError(Path, Reason.c_str());
}

ErrorOr<Image> readPng(const std::string &Path) {
  png_image Header{};
  Header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&Header, Path.c_str()))
    return pngError(Path, Header.message);
  Header.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> Bytes(PNG_IMAGE_SIZE(Header));
  if (!png_image_finish_read(&Header, nullptr, Bytes.data(), 0, nullptr))
    return pngError(Path, Header.message);

  Image Picture{Header.width, Header.height, {}};
  Picture.Pixels.reserve(Bytes.size() / 4);
  for (size_t Byte = 0; Byte != Bytes.size(); Byte += 4)
    Picture.Pixels.push_back(
        uint32_t(Bytes[Byte]) | uint32_t(Bytes[Byte + 1]) << 8 |
        uint32_t(Bytes[Byte + 2]) << 16 | uint32_t(Bytes[Byte + 3]) << 24);
  return Picture;
}

} // namespace tp
