//===- WorkShares.h - Work divided among threads ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_WORKSHARES_H
#define TP_KERNELS_COMMON_WORKSHARES_H

#include <stdint.h>

namespace tp {

/// Items [0, Items) divided among threads, a contiguous range for each; sizes
/// differ by one at most.
class WorkShares {
public:
  /// \p Threads is not 0.
  constexpr WorkShares(uint32_t Items, uint32_t Threads)
      : Size(Items / Threads), Larger(Items - Size * Threads) {}

  /// The first item of \p Thread's range.
  constexpr uint32_t begin(uint32_t Thread) const {
    return Thread * Size + (Thread < Larger ? Thread : Larger);
  }
  /// The number of items in it.
  constexpr uint32_t size(uint32_t Thread) const {
    return Size + (Thread < Larger ? 1 : 0);
  }

private:
  /// Of the smaller ranges.
  uint32_t Size;
  /// The number of ranges with one item more: the first.
  uint32_t Larger;
};

} // namespace tp

#endif // TP_KERNELS_COMMON_WORKSHARES_H
