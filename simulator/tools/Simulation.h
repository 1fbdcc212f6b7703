//===- Simulation.h - One run of tpsim --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_SIMULATION_H
#define TP_SIMULATOR_TOOLS_SIMULATION_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/tools/Options.h"

#include "llvm/Support/Error.h"

namespace tp {

/// Exit status after Ctrl-C: 128 + SIGINT, as shells have it.
inline constexpr int InterruptedStatus = 130;

/// Prints each line of the message, with `tpsim: error: ` before it, to
/// standard error.
void reportError(llvm::Error E);

/// Runs the program on \p Chip, passes its output on, writes image, statistics
/// and table, and returns tpsim's exit status: the program's; 1 after a trap or
/// the cycle limit; InterruptedStatus after Ctrl-C. An error means that nothing
/// was simulated or a result could not be written.
llvm::Expected<int> simulate(const Options &Request, const ChipConfig &Chip);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_SIMULATION_H
