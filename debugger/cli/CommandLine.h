//===- CommandLine.h - The debugger's commands ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_COMMANDLINE_H
#define TP_DEBUGGER_CLI_COMMANDLINE_H

#include "debugger/session/Session.h"

#include "llvm/Support/raw_ostream.h"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// What a command has done.
struct CommandResult {
  /// The program has run, or been moved in time: how it stopped.
  std::optional<SessionStop> Stop;
  /// Memory, registers or breakpoints may have changed.
  bool HasChanged = false;
  bool Failed = false;
  /// `quit`, with this status.
  std::optional<int> Quit;
};

/// Executes commands in gdb's and lldb's words on a session.
class CommandLine {
public:
  /// \p Session must outlive the object. Text goes to \p OS, errors too.
  CommandLine(Session &Session, llvm::raw_ostream &OS);
  ~CommandLine();

  /// Executes one line. An empty one repeats the last, if that is meant to be
  /// repeated.
  CommandResult execute(llvm::StringRef Line);

  /// What asks for the next line.
  llvm::StringRef prompt() const;
  /// Forgets a list of commands whose `end` has not come; whether there was
  /// one.
  bool dropUnfinished();

  /// The thread and frame that commands are about.
  uint32_t selectedThread() const;
  unsigned selectedFrame() const;
  void select(uint32_t Thread, unsigned Frame);

  /// What can stand in place of the word that ends at \p Cursor: whole words.
  std::vector<std::string> completions(llvm::StringRef Line, size_t Cursor);

private:
  struct Implementation;
  std::unique_ptr<Implementation> Inside;
};

} // namespace tp

#endif // TP_DEBUGGER_CLI_COMMANDLINE_H
