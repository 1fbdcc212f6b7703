//===- Accounting.cpp - Statistics at the end of a run --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/Accounting.h"

#include <algorithm>

namespace tp {

/// What a thread loses from its end on.
static Loss lossAfterEnd(ThreadState State) {
  return State == ThreadState::AtBarrier ? Loss::Barrier : Loss::Finished;
}

static ThreadStatistics summarizeThread(const Thread &T, uint64_t NextCycle,
                                        uint64_t Cycles, Statistics &Sum) {
  ThreadStatistics Result;
  Result.Lost = T.Lost;
  bool Ended = T.State != ThreadState::Running;
  uint64_t Accounted = Ended ? T.EndCycle : NextCycle;
  Result.Instructions = Accounted - T.totalLost();
  if (Accounted < Cycles)
    Result.Lost[unsigned(lossAfterEnd(T.State))] += Cycles - Accounted;
  if (Accounted > Cycles) {
    // Only the last charge of a thread reaches beyond the window.
    uint64_t Beyond = Accounted - Cycles;
    Result.Lost[unsigned(T.LastLoss)] -= Beyond;
    if (isWaitForResult(T.LastLoss))
      Sum.DataStall[unsigned(T.LastProducer)] -= Beyond;
  }
  if (T.State == ThreadState::Halted)
    Result.FinishCycle = T.EndCycle;
  return Result;
}

Statistics summarize(std::span<const Thread> Threads,
                     std::span<const uint64_t> NextCycles, uint64_t Cycles,
                     std::span<const TmRunnerState *const> Counters) {
  Statistics Sum;
  Sum.Cycles = Cycles;
  for (const TmRunnerState *Counter : Counters) {
    for (unsigned I = 0; I != NumOpcodes; ++I) {
      Sum.Executed[I] += Counter->Executed[I];
      Sum.DataStall[I] += Counter->DataStall[I];
      Sum.UnitConflict[I] += Counter->UnitConflict[I];
    }
    const std::vector<uint64_t> &Markers = Counter->Markers;
    Sum.Markers.resize(std::max(Sum.Markers.size(), Markers.size()));
    for (size_t I = 0; I != Markers.size(); ++I)
      Sum.Markers[I] += Markers[I];
  }
  for (size_t I = 0; I != Threads.size(); ++I)
    Sum.Threads.push_back(
        summarizeThread(Threads[I], NextCycles[I], Cycles, Sum));
  return Sum;
}

} // namespace tp
