//===- WordsInFlight.h - Copies that wait for memory once -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each copy asks for all its words before it stores the first: it waits once,
// and then the words arrive as fast as they can be stored.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_WORDSINFLIGHT_H
#define TP_KERNELS_TREECACHE_WORDSINFLIGHT_H

#include "kernels/common/EarlyLoad.h"
#include "kernels/common/Inline.h"
#include "kernels/treecache/SlotMemory.h"

#include <stdint.h>
#include <utility>

namespace tp {

/// Words on their way from memory to the cache. They travel in registers of
/// both kinds, because neither has enough free ones.
template <uint32_t Count> class WordsInFlight {
public:
  /// Asks for word \p Index of each at `From(Index)`.
  template <class Address>
  TP_KERNEL_INLINE explicit WordsInFlight(Address From) {
    forEachIndex(Indices(), [&](auto Index) TP_LAMBDA_INLINE {
      if constexpr (Index < FloatCount)
        Floats[Index] = *reinterpret_cast<const FloatWord *>(From(Index));
      else
        Integers[Index - FloatCount] =
            *reinterpret_cast<const CacheWord *>(From(Index));
    });
    keepInRegisters();
  }

  /// Stores each word at `To(Index)`.
  template <class Address> TP_KERNEL_INLINE void store(Address To) const {
    forEachIndex(Indices(), [&](auto Index) TP_LAMBDA_INLINE {
      if constexpr (Index < FloatCount)
        *reinterpret_cast<FloatWord *>(To(Index)) = Floats[Index];
      else
        *reinterpret_cast<CacheWord *>(To(Index)) =
            Integers[Index - FloatCount];
    });
  }

private:
  using FloatWord [[gnu::may_alias]] = float;
  using Indices = std::make_integer_sequence<uint32_t, Count>;
  static constexpr uint32_t FloatCount = Count * 9 / 16;

  /// Unrolled from the start, so that no array of words comes up in memory.
  template <uint32_t... Index, class Action>
  TP_KERNEL_INLINE static void
  forEachIndex(std::integer_sequence<uint32_t, Index...>, Action Do) {
    (Do(std::integral_constant<uint32_t, Index>()), ...);
  }

  /// Hinders the compiler from delaying loads to where the words are stored.
  TP_KERNEL_INLINE void keepInRegisters() {
    for (float &Word : Floats)
      loadHere(Word);
    for (uint32_t &Word : Integers)
      loadHere(Word);
  }

  float Floats[FloatCount];
  uint32_t Integers[Count - FloatCount];
};

} // namespace tp

#endif // TP_KERNELS_TREECACHE_WORDSINFLIGHT_H
