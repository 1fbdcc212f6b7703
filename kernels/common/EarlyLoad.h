//===- EarlyLoad.h - Loads that are asked for at once -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_EARLYLOAD_H
#define TP_KERNELS_COMMON_EARLYLOAD_H

#include "kernels/common/Inline.h"
#include "kernels/common/Vector3.h"

#include <stdint.h>

namespace tp {

// The compiler may delay a load until the path on which its value is used. Each
// of these keeps the load of its argument where it stands, so that it shares
// its wait for memory with its neighbours. They are no instructions.

TP_KERNEL_INLINE void loadHere([[maybe_unused]] uint32_t &Word) {
#ifdef __tp__
  asm volatile("" : "+r"(Word));
#endif
}

TP_KERNEL_INLINE void loadHere([[maybe_unused]] float &Number) {
#ifdef __tp__
  asm volatile("" : "+f"(Number));
#endif
}

TP_KERNEL_INLINE void loadHere(Vector3 &Vector) {
  loadHere(Vector.X);
  loadHere(Vector.Y);
  loadHere(Vector.Z);
}

/// A copy of \p From, words of memory that are asked for together. Half of them
/// travel in float registers, because neither kind has enough.
template <class T> TP_KERNEL_INLINE T loadTogether(const T &From) {
  struct Words {
    uint32_t Of[sizeof(T) / sizeof(uint32_t)];
  };
  Words Copy = __builtin_bit_cast(Words, From);
  bool InFloat = false;
  for (uint32_t &Word : Copy.Of) {
    if (InFloat) {
      float Number = __builtin_bit_cast(float, Word);
      loadHere(Number);
      Word = __builtin_bit_cast(uint32_t, Number);
    } else {
      loadHere(Word);
    }
    InFloat = !InFloat;
  }
  return __builtin_bit_cast(T, Copy);
}

} // namespace tp

#endif // TP_KERNELS_COMMON_EARLYLOAD_H
