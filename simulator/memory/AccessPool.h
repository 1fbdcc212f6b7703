//===- AccessPool.h - Accesses that are under way ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_ACCESSPOOL_H
#define TP_SIMULATOR_MEMORY_ACCESSPOOL_H

#include "simulator/core/Archive.h"
#include "simulator/memory/MemoryRequest.h"

#include <cstdint>
#include <vector>

namespace tp {

/// An index that names nothing.
inline constexpr uint32_t NoIndex = ~uint32_t(0);

/// An access on its way through a level of memory.
struct Access {
  /// Of arrival; then of the first attempt to serve it; then, for one that
  /// waits for a miss, the earliest in which it could be answered.
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
  bool Attempted = false;
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

/// Accesses by index.
class AccessPool {
public:
  Access &operator[](uint32_t Index) { return Accesses[Index]; }
  const Access &operator[](uint32_t Index) const { return Accesses[Index]; }

  uint32_t add(const Access &A) {
    if (FirstFree == NoIndex) {
      Accesses.push_back(A);
      return uint32_t(Accesses.size() - 1);
    }
    uint32_t Index = FirstFree;
    FirstFree = Accesses[Index].Next;
    Accesses[Index] = A;
    return Index;
  }

  void release(uint32_t Index) {
    Accesses[Index].Next = FirstFree;
    FirstFree = Index;
  }

  /// Brings the next free accesses into the host's cache.
  void prefetch() const {
    if (FirstFree == NoIndex)
      return;
    __builtin_prefetch(Accesses.data() + FirstFree, 1);
    __builtin_prefetch(Accesses.data() + (FirstFree ^ 2), 1);
  }

  void serialize(Archive &A) {
    A(Accesses);
    A(FirstFree);
  }

private:
  std::vector<Access> Accesses;
  uint32_t FirstFree = NoIndex;
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
