//===- TagArray.cpp - The lines that a cache has --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/TagArray.h"

#include <algorithm>

namespace tp {

TagArray::TagArray(const CacheConfig &Config)
    : Ways(Config.Ways),
      SetMask(uint32_t(Config.Bytes / Config.LineBytes / Config.Ways) - 1),
      Lines(Config.Bytes / Config.LineBytes) {}

CacheLine TagArray::replace(uint32_t Number) {
  CacheLine *Set = setOf(Number);
  CacheLine Victim = Set[Ways - 1];
  std::move_backward(Set, Set + Ways - 1, Set + Ways);
  *Set = CacheLine{Number, 0, 0};
  return Victim;
}

void TagArray::invalidate(CacheLine *Line, uint16_t Sectors) {
  Line->Valid &= uint16_t(~Sectors);
  Line->Dirty &= Line->Valid;
  if (Line->Valid != 0)
    return;
  CacheLine *End = setOf(Line->Number) + Ways;
  std::rotate(Line, Line + 1, End);
}

} // namespace tp
