//===- RunSummary.cpp - A run and what follows from its counts ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/RunSummary.h"

#include "simulator/stats/Ratio.h"

#include "llvm/Support/ErrorHandling.h"

#include <algorithm>
#include <numeric>

using namespace llvm;

namespace tp {

const char *lossName(Loss Reason) {
  switch (Reason) {
  case Loss::Data:
    return "data";
  case Loss::Memory:
    return "memory";
  case Loss::L1:
    return "l1";
  case Loss::L2:
    return "l2";
  case Loss::Dram:
    return "dram";
  case Loss::StoreBuffer:
    return "store_buffer";
  case Loss::UnitConflict:
    return "unit_conflict";
  case Loss::IcacheConflict:
    return "icache_conflict";
  case Loss::IcacheMiss:
    return "icache_miss";
  case Loss::Branch:
    return "branch";
  case Loss::Barrier:
    return "barrier";
  case Loss::Sync:
    return "sync";
  case Loss::Sleep:
    return "sleep";
  case Loss::Finished:
    return "finished";
  }
  llvm_unreachable("every loss has a name");
}

uint64_t RunSummary::threadCycles() const {
  return uint64_t(Chip.threadCount()) * Stats.Cycles;
}

double RunSummary::seconds() const {
  return double(Stats.Cycles) / (Chip.ClockGHz * 1e9);
}

double RunSummary::issueRate() const {
  return ratio(Stats.instructions(), threadCycles());
}

double RunSummary::instructionsPerCycleAndTm() const {
  return ratio(Stats.instructions(), double(Stats.Cycles) * Chip.TmCount);
}

uint64_t RunSummary::ownCycles(const ThreadStatistics &Thread) const {
  return Stats.Cycles - Thread.Lost[unsigned(Loss::Finished)] -
         Thread.Lost[unsigned(Loss::Barrier)];
}

uint64_t RunSummary::operations(Unit U) const {
  uint64_t Sum = 0;
  for (unsigned I = 0; I != NumOpcodes; ++I)
    if (takesTime(Opcode(I)) && unitOf(Opcode(I)) == U)
      Sum += Stats.Executed[I];
  return Sum;
}

double RunSummary::utilisation(Unit U) const {
  const UnitConfig &Config = Chip.Units[unsigned(U)];
  return ratio(operations(U), double(Stats.Cycles) * Chip.TmCount *
                                  Config.Count / Config.Interval);
}

double RunSummary::icacheUtilisation() const {
  return ratio(Stats.instructions(), double(Stats.Cycles) * Chip.TmCount *
                                         Chip.IcacheBanks * Chip.IcachePorts);
}

/// \p Rates in rising order; there is at least one.
static double median(const std::vector<double> &Rates) {
  size_t Half = Rates.size() / 2;
  return Rates.size() % 2 ? Rates[Half] : (Rates[Half - 1] + Rates[Half]) / 2;
}

std::optional<RayRates> rayRates(const RunSummary &Run) {
  RayRates Rates;
  Rates.Rays = std::accumulate(Run.Rays.begin(), Run.Rays.end(), uint64_t(0));
  if (Rates.Rays == 0)
    return std::nullopt;
  Rates.Chip = ratio(Rates.Rays, Run.seconds());
  std::vector<double> ToHalt, Own;
  for (size_t I = 0; I != Run.Rays.size(); ++I) {
    if (Run.Rays[I] == 0) {
      ++Rates.ThreadsWithoutRays;
      continue;
    }
    const ThreadStatistics &Thread = Run.Stats.Threads[I];
    uint64_t Cycles = Run.Stats.Cycles - Thread.Lost[unsigned(Loss::Finished)];
    double RayCycles = Run.Rays[I] * Run.Chip.ClockGHz * 1e9;
    ToHalt.push_back(ratio(RayCycles, Cycles));
    Own.push_back(ratio(RayCycles, Run.ownCycles(Thread)));
  }
  std::sort(ToHalt.begin(), ToHalt.end());
  std::sort(Own.begin(), Own.end());
  Rates.SlowestThread = ToHalt.front();
  Rates.FastestThread = ToHalt.back();
  Rates.PerThread = {Own.front(),
                     std::accumulate(Own.begin(), Own.end(), 0.0) / Own.size(),
                     median(Own), Own.back()};
  return Rates;
}

std::vector<OpcodeCount>
largestFirst(const std::array<uint64_t, NumOpcodes> &Counts) {
  std::vector<OpcodeCount> Sorted;
  for (unsigned I = 0; I != NumOpcodes; ++I)
    if (Counts[I] != 0)
      Sorted.push_back({Opcode(I), Counts[I]});
  std::sort(Sorted.begin(), Sorted.end(),
            [](const OpcodeCount &A, const OpcodeCount &B) {
              return A.Count != B.Count ? A.Count > B.Count : A.Op < B.Op;
            });
  return Sorted;
}

} // namespace tp
