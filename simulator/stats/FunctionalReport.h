//===- FunctionalReport.h - A run without timing ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_FUNCTIONALREPORT_H
#define TP_SIMULATOR_STATS_FUNCTIONALREPORT_H

#include "simulator/stats/RunSummary.h"
#include "simulator/stats/TableReport.h"

namespace tp {

/// As writeJson() for a run of the functional mode: what was executed, and
/// nothing that follows from cycles.
void writeFunctionalJson(const RunSummary &Run, llvm::raw_ostream &OS);

/// As writeTable() for a run of the functional mode.
void writeFunctionalTable(const RunSummary &Run, const HostSpeed &Speed,
                          llvm::raw_ostream &OS);

/// As checkSums() for a run of the functional mode.
llvm::Error checkFunctionalSums(const ChipConfig &Chip,
                                const Statistics &Stats);

} // namespace tp

#endif // TP_SIMULATOR_STATS_FUNCTIONALREPORT_H
