//===- DebuggerOptions.h - Command line of tpdbg ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_DEBUGGEROPTIONS_H
#define TP_DEBUGGER_CLI_DEBUGGEROPTIONS_H

#include "debugger/session/Session.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A command of the command line, or a file of them.
struct StartupCommand {
  bool IsFile = false;
  std::string Text;
};

/// What the user asked for.
struct DebuggerOptions {
  bool Help = false;
  bool Version = false;
  bool Batch = false;
  /// Serve an editor; Session is not set.
  bool ServesEditor = false;
  std::optional<uint16_t> Port;
  /// In their order.
  std::vector<StartupCommand> Commands;
  SessionOptions Session;
};

/// Parses the arguments after the program's name.
llvm::Expected<DebuggerOptions>
parseDebuggerOptions(llvm::ArrayRef<const char *> Arguments);

/// Prints the help text.
void printDebuggerHelp(llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_DEBUGGER_CLI_DEBUGGEROPTIONS_H
