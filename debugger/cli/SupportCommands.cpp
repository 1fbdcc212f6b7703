//===- SupportCommands.cpp - Commands about the debugger itself -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Command.h"
#include "debugger/cli/Shell.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {
namespace {

llvm::Error infoCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("\"info\" must be followed by the name of what to "
                             "show; see \"help info\".");
  return runSubcommand(S, infoCommands(), "info ", Arguments);
}

/// `set var x = 1`, `set $r4 = 1`, `set x = 1`.
llvm::Error setCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("Argument required (see \"help set\").");
  CommandArguments Ahead = Arguments;
  StringRef Word = Ahead.takeWord();
  bool IsAssignment = Ahead.Text.starts_with("=") || Word.contains('=') ||
                      Word.starts_with("$") || Word.starts_with("*");
  if (IsAssignment) {
    Expected<Value> Result = S.evaluate(Arguments.Text);
    return Result ? llvm::Error::success() : Result.takeError();
  }
  return runSubcommand(S, setCommands(), "set ", Arguments);
}

void printUsage(Shell &S, StringRef Prefix, const Command &C) {
  S.OS << Prefix << C.Name;
  if (!C.Usage.empty())
    S.OS << ' ' << C.Usage;
  S.OS << '\n';
  SmallVector<StringRef> Lines;
  C.Help.split(Lines, '\n');
  for (StringRef Line : Lines)
    S.OS << "    " << Line << '\n';
  if (!C.Aliases.empty())
    S.OS << "    Also: " << C.Aliases << '\n';
}

void printTable(Shell &S, StringRef Prefix, ArrayRef<Command> Table) {
  for (const Command &C : Table)
    S.OS << "  " << left_justify((Prefix + C.Name).str(), 22) << ' '
         << C.Help.split('\n').first << '\n';
}

llvm::Error helpCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty()) {
    for (const CommandGroup &Group : commandGroups()) {
      S.OS << Group.Title << ":\n";
      printTable(S, "", Group.Commands);
    }
    S.OS << "\n\"help COMMAND\" says more. Names can be abbreviated; an empty "
            "line repeats a step.\n";
    return llvm::Error::success();
  }
  StringRef Name = Arguments.takeWord();
  Expected<const Command *> Found = findCommand(allCommands(), Name, "");
  if (!Found)
    return Found.takeError();
  ArrayRef<Command> Table = (*Found)->Name == "info"  ? infoCommands()
                            : (*Found)->Name == "set" ? setCommands()
                                                      : ArrayRef<Command>();
  if (Arguments.isEmpty() || Table.empty()) {
    printUsage(S, "", **Found);
    printTable(S, ((*Found)->Name + " ").str(), Table);
    return llvm::Error::success();
  }
  std::string Prefix = ((*Found)->Name + " ").str();
  Expected<const Command *> Sub =
      findCommand(pointersTo(Table), Arguments.Text, Prefix);
  if (!Sub)
    return Sub.takeError();
  printUsage(S, Prefix, **Sub);
  return llvm::Error::success();
}

llvm::Error sourceCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("source command requires file name of file to "
                             "source.");
  S.Sourced = Arguments.Text.str();
  return llvm::Error::success();
}

llvm::Error quitCommand(Shell &S, CommandArguments Arguments) {
  Expected<uint64_t> Status = uint64_t(0);
  if (!Arguments.isEmpty())
    Status = S.evaluateInteger(Arguments.Text);
  if (!Status)
    return Status.takeError();
  S.Result.Quit = int(*Status & 0xff);
  return llvm::Error::success();
}

constexpr Command Table[] = {
    {"info", "i inf", "WHAT", "Print what the debugger knows.", infoCommand,
     false, CompletionOf::Subcommands},
    {"set", "", "WHAT", "Change the program or a setting.", setCommand, false,
     CompletionOf::Subcommands},
    {"source", "", "FILE", "Execute the commands of a file.", sourceCommand,
     false, CompletionOf::Files},
    {"help", "h", "[COMMAND]", "Print this list, or all about a command.",
     helpCommand},
    {"quit", "q exit", "[STATUS]", "Leave the debugger.", quitCommand}};

} // namespace

ArrayRef<Command> supportCommands() { return Table; }

} // namespace tp
