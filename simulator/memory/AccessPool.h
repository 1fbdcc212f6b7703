//===- AccessPool.h - Accesses that are under way ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_ACCESSPOOL_H
#define TP_SIMULATOR_MEMORY_ACCESSPOOL_H

#include "simulator/core/Archive.h"
#include "simulator/memory/MemoryRequest.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp {

/// An index that names nothing.
inline constexpr uint32_t NoIndex = ~uint32_t(0);

/// An access on its way through a level of memory.
struct Access {
  /// Of arrival; then of the first attempt to serve it; then, for one that
  /// waits for a miss, the earliest in which it could be answered, and for one
  /// that has gone on, the last in which a part was.
  uint64_t Cycle = 0;
  uint32_t Address = 0;
  /// The asker's name for it; NoIndex if nobody waits for an answer.
  uint32_t Tag = NoIndex;
  /// Of its source: orders what happens in one cycle.
  uint32_t Sequence = 0;
  /// In a list.
  uint32_t Next = NoIndex;
  /// TP in the TM, or TM in the group.
  uint16_t Source = 0;
  uint16_t Bytes = 0;
  /// Parts that have not been answered yet.
  uint16_t Remaining = 0;
  RequestKind Kind = RequestKind::Load;
  /// Whether its bank has tried to serve it.
  bool Attempted : 1 = false;
  /// Of the parts that have been answered.
  ServedBy Level : 7 = ServedBy::L1;
};

/// The order in which accesses are served that arrive at one place.
struct AccessBefore {
  bool operator()(const Access &A, const Access &B) const {
    if (A.Cycle != B.Cycle)
      return A.Cycle < B.Cycle;
    if (A.Source != B.Source)
      return A.Source < B.Source;
    return A.Sequence < B.Sequence;
  }
};

/// Accesses by index. The lowest free index is used first: so a TM's accesses
/// stay in few lines of the host's cache.
class AccessPool {
public:
  Access &operator[](uint32_t Index) { return Accesses[Index]; }
  const Access &operator[](uint32_t Index) const { return Accesses[Index]; }

  uint32_t add(const Access &A) {
    uint32_t Index = FirstFree;
    if (Index == Accesses.size())
      grow();
    Accesses[Index] = A;
    Free[Index / 64] &= ~(uint64_t(1) << Index % 64);
    findFree(Index / 64);
    return Index;
  }

  void release(uint32_t Index) {
    Free[Index / 64] |= uint64_t(1) << Index % 64;
    FirstFree = std::min(FirstFree, Index);
  }

  /// Brings the next free accesses into the host's cache.
  void prefetch() const {
    __builtin_prefetch(Free.data(), 1);
    for (uintptr_t I = 0; I != 8; I += 2)
      __builtin_prefetch(
          reinterpret_cast<const void *>(uintptr_t(Accesses.data()) +
                                         (FirstFree + I) * sizeof(Accesses[0])),
          1);
  }

  void serialize(Archive &A) {
    A(Accesses);
    A(Free);
    A(FirstFree);
  }

private:
  void grow() {
    Accesses.resize(Accesses.size() + 64);
    Free.push_back(~uint64_t(0));
  }
  /// Sets FirstFree, which is not below the word \p Word of Free.
  void findFree(size_t Word) {
    while (Word != Free.size() && Free[Word] == 0)
      ++Word;
    FirstFree = uint32_t(Word * 64);
    if (Word != Free.size())
      FirstFree += uint32_t(std::countr_zero(Free[Word]));
  }

  std::vector<Access> Accesses;
  /// A bit for each access.
  std::vector<uint64_t> Free;
  uint32_t FirstFree = 0;
};

/// Accesses of a pool, first in first out.
struct AccessList {
  uint32_t First = NoIndex;
  uint32_t Last = NoIndex;

  bool isEmpty() const { return First == NoIndex; }

  void append(AccessPool &Pool, uint32_t Index) {
    Pool[Index].Next = NoIndex;
    if (isEmpty())
      First = Index;
    else
      Pool[Last].Next = Index;
    Last = Index;
  }

  uint32_t removeFirst(AccessPool &Pool) {
    uint32_t Index = First;
    First = Pool[Index].Next;
    return Index;
  }
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_ACCESSPOOL_H
