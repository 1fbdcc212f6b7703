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

#include <stdint.h>

namespace tp {

/// A word of the cache, which may be of any type.
using CacheWord [[gnu::may_alias]] = uint32_t;

/// Copies \p Count words.
template <uint32_t Count>
TP_KERNEL_INLINE void copyWords(char *To, const char *From) {
  const CacheWord *Source = reinterpret_cast<const CacheWord *>(From);
  CacheWord *Target = reinterpret_cast<CacheWord *>(To);
  uint32_t Words[Count];
  for (uint32_t Word = 0; Word != Count; ++Word)
    Words[Word] = Source[Word];
  for (uint32_t Word = 0; Word != Count; ++Word)
    Target[Word] = Words[Word];
}

/// Copies what tests of \p Count triangles need, without gaps.
template <uint32_t Count>
TP_KERNEL_INLINE void copyRecords(char *To, const TriangleRecord *Records) {
  constexpr uint32_t PerRecord = kTriangleTestBytes / 4;
  const CacheWord *Source = reinterpret_cast<const CacheWord *>(Records);
  CacheWord *Target = reinterpret_cast<CacheWord *>(To);
  uint32_t Words[Count][PerRecord];
  for (uint32_t Record = 0; Record != Count; ++Record)
    for (uint32_t Word = 0; Word != PerRecord; ++Word)
      Words[Record][Word] = Source[Record * sizeof(TriangleRecord) / 4 + Word];
  for (uint32_t Record = 0; Record != Count; ++Record)
    for (uint32_t Word = 0; Word != PerRecord; ++Word)
      Target[Record * PerRecord + Word] = Words[Record][Word];
}

} // namespace tp

#endif // TP_KERNELS_TREECACHE_WORDCOPY_H
