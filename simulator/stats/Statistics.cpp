//===- Statistics.cpp - What a simulation counts --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/Statistics.h"

#include "simulator/stats/MemoryCounts.h"

#include <algorithm>
#include <numeric>

namespace tp {

uint64_t Statistics::instructions() const {
  return std::accumulate(Executed.begin(), Executed.end(), uint64_t(0));
}

uint64_t Statistics::lost(Loss Reason) const {
  uint64_t Sum = 0;
  for (const ThreadStatistics &Thread : Threads)
    Sum += Thread.Lost[unsigned(Reason)];
  return Sum;
}

template <class Counts>
static void subtract(Counts &From, const Counts &Earlier) {
  for (size_t I = 0; I != Earlier.size(); ++I)
    From[I] -= Earlier[I];
}

template <class Counts> static void add(Counts &Sum, const Counts &Later) {
  for (size_t I = 0; I != Later.size(); ++I)
    Sum[I] += Later[I];
}

Statistics Statistics::since(const Statistics &Earlier) const {
  Statistics Result = *this;
  Result.Cycles -= Earlier.Cycles;
  Result.GlobalAccesses -= Earlier.GlobalAccesses;
  Result.Icache -= Earlier.Icache;
  subtract(Result.Executed, Earlier.Executed);
  subtract(Result.DataStall, Earlier.DataStall);
  subtract(Result.UnitConflict, Earlier.UnitConflict);
  subtract(Result.Markers, Earlier.Markers);
  for (size_t I = 0; I != Earlier.Threads.size(); ++I) {
    Result.Threads[I].Instructions -= Earlier.Threads[I].Instructions;
    subtract(Result.Threads[I].Lost, Earlier.Threads[I].Lost);
  }
  for (size_t I = 0; I != Earlier.Pcs.size(); ++I) {
    Result.Pcs[I].Executed -= Earlier.Pcs[I].Executed;
    Result.Pcs[I].Global -= Earlier.Pcs[I].Global;
    subtract(Result.Pcs[I].Lost, Earlier.Pcs[I].Lost);
  }
  if (Memory && Earlier.Memory)
    Result.Memory = difference(*Memory, *Earlier.Memory);
  return Result;
}

Statistics &Statistics::operator+=(const Statistics &Later) {
  Cycles += Later.Cycles;
  GlobalAccesses += Later.GlobalAccesses;
  Icache += Later.Icache;
  add(Executed, Later.Executed);
  add(DataStall, Later.DataStall);
  add(UnitConflict, Later.UnitConflict);
  Markers.resize(std::max(Markers.size(), Later.Markers.size()));
  add(Markers, Later.Markers);
  Threads.resize(Later.Threads.size());
  for (size_t I = 0; I != Threads.size(); ++I) {
    Threads[I].Instructions += Later.Threads[I].Instructions;
    Threads[I].FinishCycle = Later.Threads[I].FinishCycle;
    add(Threads[I].Lost, Later.Threads[I].Lost);
  }
  Pcs.resize(Later.Pcs.size());
  for (size_t I = 0; I != Pcs.size(); ++I) {
    Pcs[I].Executed += Later.Pcs[I].Executed;
    Pcs[I].Global += Later.Pcs[I].Global;
    add(Pcs[I].Lost, Later.Pcs[I].Lost);
  }
  if (Memory && Later.Memory)
    tp::add(*Memory, *Later.Memory);
  else if (Later.Memory)
    Memory = Later.Memory;
  return *this;
}

} // namespace tp
