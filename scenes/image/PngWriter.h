//===- PngWriter.h - PNG files ----------------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_IMAGE_PNGWRITER_H
#define TP_SCENES_IMAGE_PNGWRITER_H

#include "scenes/ErrorOr.h"
#include "scenes/image/Image.h"

#include <string>

namespace tp {

/// Writes \p Picture as an 8-bit RGBA PNG marked as sRGB. The bytes depend on
/// the pixels only (no time stamp). Fails, naming the file, if it cannot be
/// written; then no partial file stays behind.
Status writePng(const std::string &Path, const Image &Picture);

/// Reads a PNG of any kind as 8-bit RGBA. Fails, naming the file, if it is
/// missing or damaged.
ErrorOr<Image> readPng(const std::string &Path);

} // namespace tp

#endif // TP_SCENES_IMAGE_PNGWRITER_H
