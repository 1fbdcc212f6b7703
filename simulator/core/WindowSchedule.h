//===- WindowSchedule.h - Which TMs have something to do when ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_WINDOWSCHEDULE_H
#define TP_SIMULATOR_CORE_WINDOWSCHEDULE_H

#include "simulator/core/Archive.h"

#include <cstdint>
#include <vector>

namespace tp {

/// Knows of each TM the first cycle in which it has something to do, so that
/// those that wait cost nothing.
class WindowSchedule {
public:
  /// All TMs are due in cycle 0. Windows have \p WindowCycles cycles.
  WindowSchedule(uint32_t TmCount, uint64_t WindowCycles);

  /// No TM is due any more.
  void clear();
  /// The first cycle in which a TM is due; NeverCycle if none is.
  uint64_t first();
  /// The TMs that are due before \p WindowEnd. They are then due no more.
  const std::vector<uint32_t> &take(uint64_t WindowEnd);
  /// A TM is due in \p Cycle, if not earlier.
  void wake(uint32_t Tm, uint64_t Cycle);

  /// The TMs of the last take().
  const std::vector<uint32_t> &due() const { return Due; }

  void serialize(Archive &A);

private:
  /// Out of date if the TM's cycle is another by now.
  struct Entry {
    uint64_t Cycle;
    uint32_t Tm;
    bool operator>(const Entry &Other) const { return Cycle > Other.Cycle; }
  };

  bool isCurrent(const Entry &E) const { return Cycles[E.Tm] == E.Cycle; }
  void insert(const Entry &E);
  void popLater();

  const uint64_t WindowCycles;
  /// NeverCycle of those that are not due.
  std::vector<uint64_t> Cycles;
  /// Those due before Horizon, and a heap of those due later.
  std::vector<Entry> Soon;
  std::vector<Entry> Later;
  /// Room for take().
  std::vector<Entry> Before;
  uint64_t Horizon;
  std::vector<uint32_t> Due;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_WINDOWSCHEDULE_H
