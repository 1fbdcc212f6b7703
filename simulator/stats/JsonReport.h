//===- JsonReport.h - A run's statistics for programs -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_JSONREPORT_H
#define TP_SIMULATOR_STATS_JSONREPORT_H

#include "simulator/stats/RunSummary.h"

#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Raised when a name in the JSON changes its meaning or goes away.
inline constexpr int JsonFormatVersion = 2;

/// Writes \p Run as JSON; docs/statistics.md lists the names. The text depends
/// on the simulation only: no host time, path or thread count is in it.
void writeJson(const RunSummary &Run, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_STATS_JSONREPORT_H
