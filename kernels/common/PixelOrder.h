//===- PixelOrder.h - The order in which pixels are rendered ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_PIXELORDER_H
#define TP_KERNELS_COMMON_PIXELORDER_H

#include <stdint.h>

namespace tp {

/// Column and row of a pixel; row 0 is the top.
struct PixelPlace {
  uint32_t X;
  uint32_t Y;
};

/// A curve through all pixels of a picture on which near positions are near
/// pixels. The picture is cut into blocks of 16 x 16 pixels, row by row; a
/// whole block is walked along a Z-order curve, one that the picture's edge
/// cuts row by row.
class PixelOrder {
public:
  constexpr PixelOrder(uint32_t Width, uint32_t Height)
      : Width(Width), Height(Height) {}

  /// The pixel at \p Position, from 0 to Width * Height - 1.
  constexpr PixelPlace at(uint32_t Position) const {
    const uint32_t BlockRow = Position / (Width * BlockSide);
    const uint32_t Y = BlockRow * BlockSide;
    const uint32_t BlockHeight = least(BlockSide, Height - Y);
    const uint32_t InRow = Position - Y * Width;
    const uint32_t BlockColumn = InRow / (BlockHeight * BlockSide);
    const uint32_t X = BlockColumn * BlockSide;
    const uint32_t BlockWidth = least(BlockSide, Width - X);
    const uint32_t InBlock = InRow - X * BlockHeight;
    if (BlockWidth == BlockSide && BlockHeight == BlockSide)
      return {X + evenBits(InBlock), Y + evenBits(InBlock >> 1)};
    const uint32_t Row = InBlock / BlockWidth;
    return {X + InBlock - Row * BlockWidth, Y + Row};
  }

private:
  static constexpr uint32_t BlockSide = 16;

  static constexpr uint32_t least(uint32_t A, uint32_t B) {
    return A < B ? A : B;
  }
  /// The even bits of the lowest eight, side by side.
  static constexpr uint32_t evenBits(uint32_t Word) {
    Word &= 0x55;
    Word = (Word | Word >> 1) & 0x33;
    return (Word | Word >> 2) & 0x0F;
  }

  uint32_t Width;
  uint32_t Height;
};

} // namespace tp

#endif // TP_KERNELS_COMMON_PIXELORDER_H
