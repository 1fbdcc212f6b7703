//===- FunctionalRun.h - A run, or its beginning, without timing *- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_FUNCTIONALRUN_H
#define TP_SIMULATOR_TOOLS_FUNCTIONALRUN_H

#include "simulator/core/Engine.h"
#include "simulator/tools/RunConsole.h"

namespace tp {

/// Does all of simulate() in the functional mode.
llvm::Expected<int> runFunctionally(const Options &Request,
                                    const ChipConfig &Chip, RunSetup &Loaded,
                                    RunConsole &Console);

/// Executes the beginning of the program up to the marker of --fast-forward
/// without timing and puts \p Machine where that ends. Gives tpsim's exit
/// status if it does not get there, and has said why.
llvm::Expected<std::optional<int>>
fastForward(const Options &Request, const ChipConfig &Chip, RunSetup &Loaded,
            RunConsole &Console, Engine &Machine);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_FUNCTIONALRUN_H
