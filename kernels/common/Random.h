//===- Random.h - Random numbers without state ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_RANDOM_H
#define TP_KERNELS_COMMON_RANDOM_H

#include <stdint.h>

namespace tp {

/// Four random words, each uniform over all 32-bit values.
struct RandomWords {
  uint32_t X, Y, Z, W;
};

/// The random words of one event: a hash of where it happens, so that a picture
/// does not depend on which thread renders a pixel, or when. \p Dimension
/// numbers the events of one sample of one pixel. The hash is pcg4d of M.
/// Jarzynski and M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
inline RandomWords randomWords(uint32_t Pixel, uint32_t Sample,
                               uint32_t Dimension, uint32_t Seed) {
  constexpr uint32_t Multiplier = 1664525u, Increment = 1013904223u;
  uint32_t X = Pixel * Multiplier + Increment;
  uint32_t Y = Sample * Multiplier + Increment;
  uint32_t Z = Dimension * Multiplier + Increment;
  uint32_t W = Seed * Multiplier + Increment;
  for (int Round = 0; Round != 2; ++Round) {
    X += Y * W;
    Y += Z * X;
    Z += X * Y;
    W += Y * Z;
    if (Round == 0) {
      X ^= X >> 16;
      Y ^= Y >> 16;
      Z ^= Z >> 16;
      W ^= W >> 16;
    }
  }
  return {X, Y, Z, W};
}

/// \p Word as a float, uniform in [0, 1): the upper 24 bits, so that every
/// value is exact and equally likely.
inline float unitFloat(uint32_t Word) {
  // The value is below 2^24: the conversion of a signed integer is one
  // instruction everywhere.
  return static_cast<float>(static_cast<int32_t>(Word >> 8)) * 0x1p-24f;
}

/// A random integer below \p Count, and the part of the randomness that the
/// choice left over.
struct RandomChoice {
  uint32_t Index;
  uint32_t Remainder;
};

/// Splits \p Word into an integer below \p Count and a word that is again
/// uniform, in steps of \p Count.
inline RandomChoice chooseIndex(uint32_t Word, uint32_t Count) {
  const uint64_t Product = static_cast<uint64_t>(Word) * Count;
  return {static_cast<uint32_t>(Product >> 32), static_cast<uint32_t>(Product)};
}

} // namespace tp

#endif // TP_KERNELS_COMMON_RANDOM_H
