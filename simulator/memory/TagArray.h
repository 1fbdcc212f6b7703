//===- TagArray.h - The lines that a cache has ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_TAGARRAY_H
#define TP_SIMULATOR_MEMORY_TAGARRAY_H

#include "simulator/chip/MemoryConfig.h"
#include "simulator/core/Archive.h"

#include <cstdint>
#include <vector>

namespace tp {

/// A line of a cache; the masks have a bit for each sector.
struct CacheLine {
  /// Address / LineBytes.
  uint32_t Number = ~uint32_t(0);
  uint16_t Valid = 0;
  uint16_t Dirty = 0;
};

/// Tags of a cache with replacement of the line that was not used for longest.
class TagArray {
public:
  explicit TagArray(const CacheConfig &Config);

  /// The line with this number, or null. Its use is noted by promote().
  CacheLine *find(uint32_t Number) {
    CacheLine *Set = setOf(Number);
    for (CacheLine *Line = Set; Line != Set + Ways; ++Line)
      if (Line->Number == Number && Line->Valid != 0)
        return Line;
    return nullptr;
  }

  /// Makes a line the last used of its set and gives its new place.
  CacheLine *promote(CacheLine *Line) {
    CacheLine *Set = setOf(Line->Number);
    CacheLine Used = *Line;
    for (; Line != Set; --Line)
      *Line = Line[-1];
    *Set = Used;
    return Set;
  }

  /// Brings the set of a line into the host's cache.
  void prefetch(uint32_t Number) const {
    __builtin_prefetch(Lines.data() + size_t(Number & SetMask) * Ways);
  }

  /// Replaces the line of the set that was not used for longest, which is
  /// returned, by an empty one with this number, the last used.
  CacheLine replace(uint32_t Number);

  /// The line of this number's set that was last used.
  CacheLine *lastUsed(uint32_t Number) { return setOf(Number); }

  /// Forgets sectors of a line; without any it is the first to be replaced.
  void invalidate(CacheLine *Line, uint16_t Sectors);

  void serialize(Archive &A) { A(Lines); }

private:
  CacheLine *setOf(uint32_t Number) {
    return Lines.data() + size_t(Number & SetMask) * Ways;
  }

  uint32_t Ways;
  uint32_t SetMask;
  /// Set by set, within one the last used first.
  std::vector<CacheLine> Lines;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_TAGARRAY_H
