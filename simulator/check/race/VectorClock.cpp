//===- VectorClock.cpp - What a thread knows of the others ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/VectorClock.h"

#include <algorithm>

namespace tp {

thread_local size_t VectorClock::LiveChunks = 0;

void VectorClock::raise(uint32_t Thread, Clock To) {
  if (of(Thread) >= To)
    return;
  const size_t Index = Thread / ChunkThreads;
  if (Index >= Chunks.size())
    Chunks.resize(Index + 1);
  std::shared_ptr<Chunk> &Own = Chunks[Index];
  if (!Own)
    Own = std::make_shared<Chunk>();
  else if (Own.use_count() != 1)
    Own = std::make_shared<Chunk>(*Own);
  (*Own)[Thread % ChunkThreads] = To;
}

void VectorClock::join(const VectorClock &Other) {
  if (Other.Chunks.size() > Chunks.size())
    Chunks.resize(Other.Chunks.size());
  for (size_t Index = 0; Index != Other.Chunks.size(); ++Index) {
    std::shared_ptr<Chunk> &Own = Chunks[Index];
    const std::shared_ptr<Chunk> &Theirs = Other.Chunks[Index];
    if (Own == Theirs || !Theirs)
      continue;
    bool OwnHasMore = false;
    bool TheyHaveMore = !Own;
    if (Own)
      for (size_t I = 0; I != ChunkThreads; ++I) {
        OwnHasMore |= (*Own)[I] > (*Theirs)[I];
        TheyHaveMore |= (*Own)[I] < (*Theirs)[I];
      }
    if (!TheyHaveMore)
      continue;
    if (!OwnHasMore) {
      Own = Theirs;
      continue;
    }
    if (Own.use_count() != 1)
      Own = std::make_shared<Chunk>(*Own);
    for (size_t I = 0; I != ChunkThreads; ++I)
      (*Own)[I] = std::max((*Own)[I], (*Theirs)[I]);
  }
}

} // namespace tp
