//===- RunResults.h - What a run of tpsim leaves behind ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_RUNRESULTS_H
#define TP_SIMULATOR_TOOLS_RUNRESULTS_H

#include "simulator/core/Engine.h"
#include "simulator/stats/RunSummary.h"
#include "simulator/tools/RunSetup.h"
#include "simulator/tools/TrapMessage.h"

namespace tp {

/// What is known of a run that has ended with \p Result, but for the events of
/// its rays. \p Stats and \p Chip are kept by reference.
RunSummary summaryOf(const RunResult &Result, const Options &Request,
                     const RunSetup &Loaded, const ChipConfig &Chip,
                     const Statistics &Stats);

/// tpsim's exit status after a run.
int exitStatus(const RunResult &Result);

/// writeJson() or writeFunctionalJson().
using JsonFunction = void(const RunSummary &Run, llvm::raw_ostream &OS);

/// Adds to \p Run what its rays did and writes all that the user asked for but
/// the table.
llvm::Error writeResults(RunSummary &Run, const Options &Request,
                         const RunSetup &Loaded, JsonFunction &WriteJson);

/// Why the run did not end as the program wanted, to standard error. \p
/// Registers are those of the thread that trapped.
void explainEnd(const RunResult &Result, const Options &Request,
                const ChipConfig &Chip, const ElfProgram &Elf, TrapClock Clock,
                const RegisterFunction &Registers);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_RUNRESULTS_H
