//===- HappensBefore.h - Which accesses threads have ordered ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The order that a program makes between its threads, as C++ defines it: by
// the barrier, and by release operations whose value an acquire operation
// reads. `sync` is a fence of both kinds, so that a release store is a `sync`
// and an atomic store, and an atomic operation that acquires one with a `sync`
// behind it.
//
// A thread's time is cut into epochs: a new one begins with each of its
// releases. An access is known by its thread and epoch. The barrier orders all
// that was before it, which one clock per thread says for everybody; only what
// threads have told each other since then takes vector clocks.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_RACE_HAPPENSBEFORE_H
#define TP_SIMULATOR_CHECK_RACE_HAPPENSBEFORE_H

#include "simulator/check/race/VectorClock.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace tp {

class HappensBefore {
public:
  /// \p BudgetBytes bounds the memory for vector clocks and synchronization
  /// variables: over it everything so far counts as ordered.
  HappensBefore(uint32_t ThreadCount, size_t BudgetBytes);

  /// The epoch in which \p Thread is now; from 1.
  Clock now(uint32_t Thread) const { return Threads[Thread].Own; }

  /// Whether what \p Before did in its epoch \p When happens before what
  /// \p Thread does now.
  bool isBefore(uint32_t Before, Clock When, uint32_t Thread) const {
    if (Before == Thread || When <= Ordered[Before])
      return true;
    const VectorClock *Known = Threads[Thread].Known.get();
    return Known && When <= Known->of(Before);
  }

  /// All that happened so far happens before all that follows.
  void orderAll();

  /// A fence of acquire and release.
  void fence(uint32_t Thread);
  /// An atomic load of the word at \p Address.
  void atomicLoad(uint32_t Thread, uint32_t Address, bool Acquires);
  /// An atomic store: what others find in the word is this thread's.
  void atomicStore(uint32_t Thread, uint32_t Address);
  /// An atomic operation that reads and writes in one step.
  void atomicChange(uint32_t Thread, uint32_t Address);
  /// An operation on the stream at \p Address, which releases and acquires.
  void streamOperation(uint32_t Thread, uint32_t Address) {
    fence(Thread);
    atomicChange(Thread, Address);
    fence(Thread);
  }

  /// The greatest epoch of any thread.
  Clock latest() const { return Latest; }
  /// How often the budget made everything ordered.
  uint64_t overflows() const { return Overflows; }

private:
  /// What a release tells: all that Thread had done before, and all that it
  /// knew then. Known may be null.
  struct Release {
    std::shared_ptr<const VectorClock> Known;
    uint32_t Thread = 0;
    /// 0 if there is no release.
    Clock Own = 0;
  };
  struct ThreadClocks {
    Clock Own = 1;
    /// What it knows of others beyond Ordered; null if nothing. Shared with
    /// releases, so it is replaced, not changed.
    std::shared_ptr<const VectorClock> Known;
    /// What its last fence released.
    Release Fence;
    /// What its atomic loads since the last fence found; null if nothing.
    std::unique_ptr<VectorClock> Found;
  };

  /// All that two releases tell, the later one that of \p Second.
  static Release merged(const Release &First, const Release &Second);
  void beginEpoch(uint32_t Thread);
  void keepBudget();

  std::vector<ThreadClocks> Threads;
  /// Of each thread the last epoch that is ordered before everything now.
  std::vector<Clock> Ordered;
  /// What was last released on a word.
  std::unordered_map<uint32_t, Release> Variables;
  size_t BudgetBytes;
  Clock Latest = 1;
  uint64_t Overflows = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_RACE_HAPPENSBEFORE_H
