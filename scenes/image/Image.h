//===- Image.h - A picture in memory ----------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_IMAGE_IMAGE_H
#define TP_SCENES_IMAGE_IMAGE_H

#include <cstdint>
#include <vector>

namespace tp {

/// Width x Height pixels in the form of the launch block's framebuffer: one
/// word each, red in the lowest byte, then green, blue, alpha; row 0 is the
/// top.
struct Image {
  uint32_t Width = 0;
  uint32_t Height = 0;
  std::vector<uint32_t> Pixels;
};

} // namespace tp

#endif // TP_SCENES_IMAGE_IMAGE_H
