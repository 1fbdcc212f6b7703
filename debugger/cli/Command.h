//===- Command.h - A command of the debugger --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_COMMAND_H
#define TP_DEBUGGER_CLI_COMMAND_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <string>
#include <vector>

namespace tp {

class Shell;

/// What can be completed behind a command.
enum class CompletionOf { Nothing, Locations, Expressions, Subcommands, Files };

/// What stands behind a command's name.
struct CommandArguments {
  /// Behind the slash: `4xw` of `x/4xw`.
  llvm::StringRef Format;
  llvm::StringRef Text;

  /// Takes the first word off Text.
  llvm::StringRef takeWord();
  bool isEmpty() const { return Text.empty(); }
};

struct Command {
  llvm::StringRef Name;
  /// Other names, each separated by a space.
  llvm::StringRef Aliases;
  /// Behind the name: `[COUNT]`.
  llvm::StringRef Usage;
  /// A sentence, and more in further lines.
  llvm::StringRef Help;
  llvm::Error (*Run)(Shell &S, CommandArguments Arguments);
  /// An empty line executes it again.
  bool Repeats = false;
  CompletionOf Completes = CompletionOf::Nothing;
};

/// The commands, by what they are about.
struct CommandGroup {
  llvm::StringRef Title;
  llvm::ArrayRef<Command> Commands;
};

llvm::ArrayRef<Command> runCommands();
llvm::ArrayRef<Command> reverseCommands();
llvm::ArrayRef<Command> breakpointCommands();
llvm::ArrayRef<Command> stackCommands();
llvm::ArrayRef<Command> threadCommands();
llvm::ArrayRef<Command> dataCommands();
llvm::ArrayRef<Command> sourceCommands();
llvm::ArrayRef<Command> supportCommands();
/// Behind `info`.
llvm::ArrayRef<Command> infoCommands();
/// Behind `set`.
llvm::ArrayRef<Command> setCommands();

/// All but the last two.
llvm::ArrayRef<CommandGroup> commandGroups();

/// The command of \p Table that \p Name is, or abbreviates. \p Prefix is in
/// front of it in messages: `info `.
llvm::Expected<const Command *>
findCommand(llvm::ArrayRef<const Command *> Table, llvm::StringRef Name,
            llvm::StringRef Prefix);
std::vector<const Command *> allCommands();
std::vector<const Command *> pointersTo(llvm::ArrayRef<Command> Table);

/// Executes one of infoCommands() or setCommands().
llvm::Error runSubcommand(Shell &S, llvm::ArrayRef<Command> Table,
                          llvm::StringRef Prefix, CommandArguments Arguments);

/// Reads a count; \p Default if there is none.
llvm::Expected<uint64_t> parseCount(llvm::StringRef Text, uint64_t Default);

} // namespace tp

#endif // TP_DEBUGGER_CLI_COMMAND_H
