//===- VectorClock.h - What a thread knows of the others --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_RACE_VECTORCLOCK_H
#define TP_SIMULATOR_CHECK_RACE_VECTORCLOCK_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// Counts the releases of one thread.
using Clock = uint32_t;

/// For each thread the last of its clocks of which everything is known; 0 for
/// every thread at first. Clocks of neighbouring threads lie in a chunk, and
/// copies share their chunks until one of them changes: what many threads know
/// alike is stored once.
class VectorClock {
public:
  Clock of(uint32_t Thread) const {
    const size_t Index = Thread / ChunkThreads;
    return Index < Chunks.size() && Chunks[Index]
               ? (*Chunks[Index])[Thread % ChunkThreads]
               : 0;
  }
  /// Makes the clock of \p Thread at least \p To.
  void raise(uint32_t Thread, Clock To);
  /// Makes each clock at least that of \p Other.
  void join(const VectorClock &Other);

  /// Bytes of a chunk, of which there are at most chunks().
  static constexpr size_t ChunkThreads = 64;
  static constexpr size_t ChunkBytes = ChunkThreads * sizeof(Clock);
  /// Chunks that all vector clocks of this host thread have together.
  static size_t chunks() { return LiveChunks; }

private:
  class Chunk : public std::array<Clock, ChunkThreads> {
  public:
    Chunk() : array{} { ++LiveChunks; }
    Chunk(const Chunk &Other) : array(Other) { ++LiveChunks; }
    Chunk &operator=(const Chunk &) = delete;
    ~Chunk() { --LiveChunks; }
  };

  static thread_local size_t LiveChunks;
  /// Null where all clocks are 0.
  std::vector<std::shared_ptr<Chunk>> Chunks;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_RACE_VECTORCLOCK_H
