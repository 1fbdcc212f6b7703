//===- stream.h - Queues of words shared by all threads ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A stream is a ring buffer in global memory: this descriptor and, right behind
// it, Capacity words of data. Pushing and popping are one instruction each.
//
//===----------------------------------------------------------------------===//

#ifndef TP_STREAM_H
#define TP_STREAM_H

#include <stdint.h>

namespace tp {

struct Stream {
  /// Words popped so far, modulo 2^32.
  uint32_t Head;
  /// Words pushed so far, modulo 2^32. The stream is full when Tail - Head is
  /// Capacity and empty when it is 0.
  uint32_t Tail;
  /// A power of two.
  uint32_t Capacity;
  uint32_t Reserved;

  uint32_t *data() { return reinterpret_cast<uint32_t *>(this + 1); }
};

static_assert(sizeof(Stream) == 4 * sizeof(uint32_t),
              "the stream instructions know this layout");

/// What streamPop() returns for an empty stream; such a word can be pushed but
/// not be told from emptiness.
inline constexpr uint32_t kStreamEmpty = 0xFFFFFFFFu;

/// Bytes of a stream with room for \p Capacity words.
constexpr uint32_t streamBytes(uint32_t Capacity) {
  return static_cast<uint32_t>(sizeof(Stream) + Capacity * sizeof(uint32_t));
}

/// Makes the streamBytes(\p Capacity) bytes at \p Memory an empty stream.
/// \p Capacity is a power of two. Not atomic: one thread does it, the others
/// wait at a barrier.
inline Stream *streamCreate(void *Memory, uint32_t Capacity) {
  Stream *S = static_cast<Stream *>(Memory);
  S->Head = 0;
  S->Tail = 0;
  S->Capacity = Capacity;
  S->Reserved = 0;
  return S;
}

#ifdef __tp__

/// Appends \p Value; false when the stream is full.
inline bool streamPush(Stream *S, uint32_t Value) {
  return __builtin_tp_stream_push(&S->Head, Value) != 0;
}

/// Takes the oldest word, or returns kStreamEmpty.
inline uint32_t streamPop(Stream *S) {
  return __builtin_tp_stream_pop(&S->Head);
}

#else

bool streamPush(Stream *S, uint32_t Value);
uint32_t streamPop(Stream *S);

#endif

} // namespace tp

#endif // TP_STREAM_H
