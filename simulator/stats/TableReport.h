//===- TableReport.h - A run's statistics for people ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_TABLEREPORT_H
#define TP_SIMULATOR_STATS_TABLEREPORT_H

#include "simulator/stats/RunSummary.h"

#include "llvm/Support/raw_ostream.h"

namespace tp {

/// How long the simulation took on the host.
struct HostSpeed {
  double Seconds = 0;
  unsigned Threads = 1;
  /// Thread-instructions that were simulated in this time; nothing: all that
  /// the run shows.
  std::optional<uint64_t> Instructions = std::nullopt;
};

/// Writes one screen about \p Run: at most 100 columns and 50
/// lines.
void writeTable(const RunSummary &Run, const HostSpeed &Speed,
                llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_STATS_TABLEREPORT_H
