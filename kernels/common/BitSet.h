//===- BitSet.h - One bit for each of some things ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_BITSET_H
#define TP_KERNELS_COMMON_BITSET_H

#include <stdint.h>

namespace tp {

/// A set of numbers below a limit, in memory that the caller gives.
class BitSet {
public:
  /// Words of memory for the numbers below \p Size.
  static constexpr uint32_t wordCount(uint32_t Size) { return Size / 32 + 1; }

  /// An empty set in wordCount(Size) words.
  BitSet(uint32_t *Words, uint32_t Size) : Words(Words) {
    for (uint32_t Word = 0; Word != wordCount(Size); ++Word)
      Words[Word] = 0;
  }
  bool contains(uint32_t Number) const {
    return (Words[Number / 32] >> Number % 32 & 1) != 0;
  }
  /// False if it was there already.
  bool insert(uint32_t Number) {
    const bool IsNew = !contains(Number);
    Words[Number / 32] |= 1u << Number % 32;
    return IsNew;
  }

private:
  uint32_t *Words;
};

} // namespace tp

#endif // TP_KERNELS_COMMON_BITSET_H
