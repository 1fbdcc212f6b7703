//===- RunSummary.h - A run and what follows from its counts ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_RUNSUMMARY_H
#define TP_SIMULATOR_STATS_RUNSUMMARY_H

#include "kernels/profile/RayProfile.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/loader/Symbolizer.h"
#include "simulator/stats/Statistics.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Name of a loss in JSON, e.g. `unit_conflict`.
const char *lossName(Loss Reason);

/// What was rendered.
struct ImageSettings {
  uint32_t Width = 0;
  uint32_t Height = 0;
  uint32_t SamplesPerPixel = 0;
  uint32_t MaxDepth = 0;
  uint32_t Seed = 0;
};

/// A run that is over, as the reports show it. Holds nothing of the host, so
/// that two runs of one simulation have equal summaries.
struct RunSummary {
  const ChipConfig &Chip;
  const Statistics &Stats;
  /// `finished`, `trapped`, `cycle_limit` or `interrupted`.
  std::string Outcome;
  int ExitStatus = 0;
  /// Rays by thread; empty if the program does not count any.
  std::vector<uint32_t> Rays;
  std::optional<ImageSettings> Image;
  /// What the rays of each thread did; empty if the program does not report it.
  std::vector<RayProfile> RayProfiles = {};
  /// Where the program's text begins, and its words.
  uint32_t TextBegin = 0;
  std::vector<Opcode> Opcodes = {};
  /// The source of the instruction at an address, innermost function first; set
  /// if the counts by instruction are to be shown.
  std::function<std::vector<SourceFrame>(uint32_t Pc)> FramesOf = {};

  /// Threads times cycles: what issues and losses add up to.
  uint64_t threadCycles() const;
  /// Simulated seconds at the chip's clock.
  double seconds() const;
  /// Issued instructions per thread-cycle, 0 to 1.
  double issueRate() const;
  double instructionsPerCycleAndTm() const;
  /// Cycles of a thread up to its halt, without its waits at barriers.
  uint64_t ownCycles(const ThreadStatistics &Thread) const;
  /// Operations that \p U started.
  uint64_t operations(Unit U) const;
  /// Share of the unit's issue slots that were used, 0 to 1.
  double utilisation(Unit U) const;
  /// Share of the fetches that the instruction caches could have served.
  double icacheUtilisation() const;
};

/// Rays per second at the chip's clock.
struct RayRates {
  uint64_t Rays = 0;
  /// All rays over the run's time.
  double Chip = 0;
  /// Over each thread's time up to its halt; threads without a ray are left
  /// out.
  double SlowestThread = 0;
  double FastestThread = 0;
  /// Over each thread's own cycles; threads without a ray are left out.
  struct {
    double Minimum = 0;
    double Mean = 0;
    double Median = 0;
    double Maximum = 0;
  } PerThread;
  uint32_t ThreadsWithoutRays = 0;
};

/// std::nullopt if the program counted no rays.
std::optional<RayRates> rayRates(const RunSummary &Run);

/// An operation code's count.
struct OpcodeCount {
  Opcode Op;
  uint64_t Count;
};

/// The nonzero counts, largest first; equal counts in the order of Opcode.
std::vector<OpcodeCount>
largestFirst(const std::array<uint64_t, NumOpcodes> &Counts);

} // namespace tp

#endif // TP_SIMULATOR_STATS_RUNSUMMARY_H
