//===- WordCopy.h - Copies that wait for memory once ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each copy asks for all its words before it stores the first: it waits once,
// and then the words arrive as fast as they can be stored.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_TREECACHE_WORDCOPY_H
#define TP_KERNELS_TREECACHE_WORDCOPY_H

#include "kernels/common/Inline.h"
#include "kernels/treecache/SlotFormat.h"
#include "kernels/treecache/SlotMemory.h"

#include <stdint.h>

namespace tp {

/// Words on their way from memory to the cache. They travel in registers of
/// both kinds, because neither has enough free ones.
template <uint32_t Count> class WordsInFlight {
public:
  /// Asks for word \p Index, which is at \p Address.
  TP_KERNEL_INLINE void load(uint32_t Index, const char *Address) {
    if (Index < FloatCount)
      Floats[Index] = *reinterpret_cast<const FloatWord *>(Address);
    else
      Integers[Index - FloatCount] =
          *reinterpret_cast<const CacheWord *>(Address);
  }
  /// Stores all words from \p To on; all are to be asked for before.
  TP_KERNEL_INLINE void store(char *To) {
    keepInRegisters();
    for (uint32_t Index = 0; Index != FloatCount; ++Index)
      reinterpret_cast<FloatWord *>(To)[Index] = Floats[Index];
    for (uint32_t Index = FloatCount; Index != Count; ++Index)
      reinterpret_cast<CacheWord *>(To)[Index] = Integers[Index - FloatCount];
  }

private:
  using FloatWord [[gnu::may_alias]] = float;
  static constexpr uint32_t FloatCount = Count * 5 / 8;

  /// Hinders the compiler from making it a copy of memory to memory.
  TP_KERNEL_INLINE void keepInRegisters() {
#ifdef __tp__
    for (float &Word : Floats)
      asm volatile("" : "+f"(Word));
#endif
    for (uint32_t &Word : Integers)
      asm volatile("" : "+r"(Word));
  }

  float Floats[FloatCount];
  uint32_t Integers[Count - FloatCount];
};

/// Copies \p Count words.
template <uint32_t Count>
TP_KERNEL_INLINE void copyWords(char *To, const char *From) {
  WordsInFlight<Count> Words;
  for (uint32_t Word = 0; Word != Count; ++Word)
    Words.load(Word, From + Word * 4);
  Words.store(To);
}

/// Copies what tests of \p Count triangles need, without gaps.
template <uint32_t Count>
TP_KERNEL_INLINE void copyRecords(char *To, const TriangleRecord *Records) {
  constexpr uint32_t PerRecord = kTriangleTestBytes / 4;
  WordsInFlight<Count * PerRecord> Words;
  for (uint32_t Word = 0; Word != Count * PerRecord; ++Word)
    Words.load(Word, reinterpret_cast<const char *>(Records) +
                         Word / PerRecord * sizeof(TriangleRecord) +
                         Word % PerRecord * 4);
  Words.store(To);
}

} // namespace tp

#endif // TP_KERNELS_TREECACHE_WORDCOPY_H
