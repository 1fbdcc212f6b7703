//===- Command.cpp - Finds commands by their name -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Command.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

StringRef CommandArguments::takeWord() {
  auto [Word, Rest] = getToken(Text, " \t");
  Text = Rest.trim();
  return Word;
}

ArrayRef<CommandGroup> commandGroups() {
  static const CommandGroup Groups[] = {
      {"Running the program", runCommands()},
      {"Running backwards", reverseCommands()},
      {"Breakpoints and watchpoints", breakpointCommands()},
      {"The stack", stackCommands()},
      {"Threads and time", threadCommands()},
      {"Data", dataCommands()},
      {"Source and instructions", sourceCommands()},
      {"The debugger itself", supportCommands()}};
  return Groups;
}

std::vector<const Command *> pointersTo(ArrayRef<Command> Table) {
  std::vector<const Command *> Result;
  for (const Command &C : Table)
    Result.push_back(&C);
  return Result;
}

std::vector<const Command *> allCommands() {
  std::vector<const Command *> Result;
  for (const CommandGroup &Group : commandGroups())
    append_range(Result, pointersTo(Group.Commands));
  return Result;
}

static bool hasName(const Command &C, StringRef Name) {
  SmallVector<StringRef> Aliases;
  C.Aliases.split(Aliases, ' ');
  return C.Name == Name || is_contained(Aliases, Name);
}

Expected<const Command *> findCommand(ArrayRef<const Command *> Table,
                                      StringRef Name, StringRef Prefix) {
  std::vector<const Command *> Matching;
  for (const Command *C : Table) {
    if (hasName(*C, Name))
      return C;
    if (C->Name.starts_with(Name))
      Matching.push_back(C);
  }
  if (Matching.size() == 1)
    return Matching.front();
  if (Matching.empty())
    return createStringError("Undefined " + Prefix + "command: \"" + Name +
                             "\".  Try \"help\".");
  std::vector<std::string> Names;
  for (const Command *C : Matching)
    Names.push_back(C->Name.str());
  sort(Names);
  return createStringError("Ambiguous " + Prefix + "command \"" + Name +
                           "\": " + join(Names, ", ") + ".");
}

llvm::Error runSubcommand(Shell &S, ArrayRef<Command> Table, StringRef Prefix,
                          CommandArguments Arguments) {
  StringRef Word = Arguments.takeWord();
  StringRef Name;
  std::tie(Name, Arguments.Format) = Word.split('/');
  Expected<const Command *> Found =
      findCommand(pointersTo(Table), Name, Prefix);
  if (!Found)
    return Found.takeError();
  return (*Found)->Run(S, Arguments);
}

Expected<uint64_t> parseCount(StringRef Text, uint64_t Default) {
  uint64_t Count;
  if (Text.empty())
    return Default;
  if (Text.getAsInteger(0, Count))
    return createStringError("Not a count: '" + Text + "'");
  return Count;
}

} // namespace tp
