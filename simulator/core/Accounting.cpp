//===- Accounting.cpp - Statistics at the end of a run --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/Accounting.h"
#include "simulator/core/ThreadRequests.h"

#include <algorithm>

namespace tp {

/// The cycle up to which all cycles of the thread are charged.
static uint64_t accountedTo(const Thread &T, uint64_t NextCycle) {
  if (T.State != ThreadState::Running)
    return T.EndCycle;
  if (T.Requests && T.Requests->waitsFor() != Awaited::Nothing)
    return T.Requests->suspendedAt();
  return NextCycle;
}

std::optional<Loss> lossWithoutData(const Thread &T) {
  if (T.State == ThreadState::AtBarrier)
    return Loss::Barrier;
  if (T.State != ThreadState::Running)
    return Loss::Finished;
  switch (T.Requests ? T.Requests->waitsFor() : Awaited::Nothing) {
  case Awaited::StoreEntry:
    return Loss::StoreBuffer;
  case Awaited::AllStores:
    return Loss::Sync;
  case Awaited::Line:
    return Loss::IcacheMiss;
  default:
    return std::nullopt;
  }
}

uint64_t issuedBy(const Thread &T, uint64_t NextCycle) {
  return accountedTo(T, NextCycle) - T.totalLost();
}

static ThreadStatistics summarizeThread(const Thread &T, uint64_t NextCycle,
                                        uint64_t Cycles, Statistics &Sum) {
  ThreadStatistics Result;
  Result.Lost = T.Lost;
  uint64_t Accounted = accountedTo(T, NextCycle);
  Result.Instructions = issuedBy(T, NextCycle);
  LossCounts &LostAt = Sum.Pcs[T.LastWord].Lost;
  if (Accounted < Cycles) {
    Loss Reason = lossWithoutData(T).value_or(Loss::Memory);
    Result.Lost[unsigned(Reason)] += Cycles - Accounted;
    if (isWaitForResult(Reason))
      Sum.DataStall[unsigned(T.LastProducer)] += Cycles - Accounted;
    if (Reason != Loss::Finished)
      LostAt[unsigned(Reason)] += Cycles - Accounted;
  }
  if (Accounted > Cycles) {
    // Only the last charge of a thread reaches beyond the window.
    uint64_t Beyond = Accounted - Cycles;
    Result.Lost[unsigned(T.LastLoss)] -= Beyond;
    LostAt[unsigned(T.LastLoss)] -= Beyond;
    if (isWaitForResult(T.LastLoss))
      Sum.DataStall[unsigned(T.LastProducer)] -= Beyond;
  }
  if (T.State == ThreadState::Halted)
    Result.FinishCycle = T.EndCycle;
  return Result;
}

Statistics summarize(std::span<const Thread> Threads,
                     std::span<const uint64_t> NextCycles, uint64_t Cycles,
                     std::span<const TmRunnerState *const> Counters,
                     std::span<const Opcode> Opcodes) {
  Statistics Sum;
  Sum.Cycles = Cycles;
  Sum.Pcs.resize(Opcodes.size());
  for (const TmRunnerState *Counter : Counters) {
    for (size_t I = 0; I != Opcodes.size(); ++I) {
      Sum.Pcs[I].Executed += Counter->IssuedAt[I].Executed;
      Sum.Pcs[I].Global += Counter->IssuedAt[I].Global;
      Sum.GlobalAccesses += Counter->IssuedAt[I].Global;
      for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
        Sum.Pcs[I].Lost[Reason] += Counter->LostAt[I][Reason];
    }
    for (unsigned I = 0; I != NumOpcodes; ++I)
      Sum.DataStall[I] += Counter->DataStall[I];
    const std::vector<uint64_t> &Markers = Counter->Markers;
    Sum.Markers.resize(std::max(Sum.Markers.size(), Markers.size()));
    for (size_t I = 0; I != Markers.size(); ++I)
      Sum.Markers[I] += Markers[I];
  }
  for (size_t I = 0; I != Threads.size(); ++I)
    Sum.Threads.push_back(
        summarizeThread(Threads[I], NextCycles[I], Cycles, Sum));
  for (size_t I = 0; I != Opcodes.size(); ++I) {
    if (Opcodes[I] == IllegalOpcode)
      continue;
    const PcStatistics &Pc = Sum.Pcs[I];
    unsigned Op = unsigned(Opcodes[I]);
    Sum.Executed[Op] += Pc.Executed;
    Sum.UnitConflict[Op] += Pc.Lost[unsigned(Loss::UnitConflict)];
  }
  return Sum;
}

} // namespace tp
