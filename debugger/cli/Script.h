//===- Script.h - Commands from a file or the keyboard ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_SCRIPT_H
#define TP_DEBUGGER_CLI_SCRIPT_H

#include "debugger/cli/CommandLine.h"

#include "llvm/Support/Error.h"

#include <optional>

namespace tp {

/// Executes the lines of a file; `#` begins a comment line. Ends at the first
/// error, which then names file and line, or at quit, whose status comes back.
llvm::Expected<std::optional<int>>
runScript(CommandLine &Commands, llvm::StringRef Path, llvm::raw_ostream &OS);

/// Reads commands from standard input, with history and completion if it is a
/// terminal, until it ends or quit; gives the exit status.
int runInteractively(CommandLine &Commands, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_DEBUGGER_CLI_SCRIPT_H
