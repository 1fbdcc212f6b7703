//===- QuantizedPlanes.h - Decoding quantized boxes -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Bits moved to where a float has them, and no conversions, of which a chip can
// start few.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_QUANTIZEDPLANES_H
#define TP_KERNELS_BVH_QUANTIZEDPLANES_H

#include "kernels/common/Inline.h"
#include "kernels/common/SceneLayout.h"

#include <stdint.h>

namespace tp {

/// Bits of a scale that QuantizedBvhNode::Scales keeps: sign (0), exponent and
/// two of the fraction; one of the last axis, which comes lowest.
inline constexpr uint32_t kScaleBits = 11;

/// The scale of \p Axis, a positive float. What follows it in the word is part
/// of its fraction, so that only a shift is needed.
TP_KERNEL_INLINE float quantizedScale(uint32_t Scales, uint32_t Axis) {
  return __builtin_bit_cast(float, Scales << (Axis * kScaleBits));
}

/// The number of a plane whose byte is 0.
inline constexpr uint32_t kFirstPlane = 256;

/// Makes the numbers of planes from the bytes of a word of
/// QuantizedBvhNode::Planes. 256 + byte is a float whose fraction begins with
/// the byte. For child 0 and 2 that is the number; for child 1 and 3 the byte
/// below follows in the fraction, which saves a shift: the number is
/// 256 + byte + byte of the child before / 256.
class PlaneNumbers {
public:
  struct Numbers {
    float Of[kWideBvhWidth];
  };

  /// Not const: what was inserted last stays, to be replaced by the next.
  TP_KERNEL_INLINE Numbers decode(uint32_t Planes) {
    Numbers Result;
    Result.Of[0] = insertByte(Planes);
    Result.Of[1] = insertTwoBytes(Planes);
    Result.Of[2] = insertByte(Planes >> 16);
    Result.Of[3] = insertTwoBytes(Planes >> 16);
    return Result;
  }

private:
  static constexpr uint32_t BitsOfFirst = 0x43800000;

#ifdef __tp__
  // One after the other: between them the compiler would keep copies.
  TP_KERNEL_INLINE float insertByte(uint32_t Word) {
    float Number;
    asm("ins %0, %2, 15, 22\n\tmtc1 %1, %0"
        : "+r"(One), "=f"(Number)
        : "r"(Word));
    return Number;
  }
  TP_KERNEL_INLINE float insertTwoBytes(uint32_t Word) {
    float Number;
    asm("ins %0, %2, 7, 22\n\tmtc1 %1, %0"
        : "+r"(Two), "=f"(Number)
        : "r"(Word));
    return Number;
  }
#else
  float insertByte(uint32_t Word) {
    One = BitsOfFirst | (Word & 0xFF) << 15;
    return __builtin_bit_cast(float, One);
  }
  float insertTwoBytes(uint32_t Word) {
    Two = BitsOfFirst | (Word & 0xFFFF) << 7;
    return __builtin_bit_cast(float, Two);
  }
#endif

  uint32_t One = BitsOfFirst;
  uint32_t Two = BitsOfFirst;
};

} // namespace tp

#endif // TP_KERNELS_BVH_QUANTIZEDPLANES_H
