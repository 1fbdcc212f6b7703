//===- Completion.cpp - What can stand at the cursor ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Completion.h"

#include "debugger/cli/Command.h"
#include "debugger/cli/Shell.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

#include <set>

using namespace llvm;

namespace tp {

StringRef lastWord(StringRef Line) {
  size_t Begin = Line.find_last_of(" \t(*&!~+-/,<>=|^%[");
  return Begin == StringRef::npos ? Line : Line.substr(Begin + 1);
}

static void addCommands(std::set<std::string> &Found, StringRef Word,
                        ArrayRef<Command> Table) {
  for (const Command &C : Table)
    if (C.Name.starts_with(Word))
      Found.insert(C.Name.str());
}

static void addLocations(Shell &S, std::set<std::string> &Found,
                         StringRef Word) {
  for (uint32_t F = 0; F != S.map().functionCount(); ++F) {
    const FunctionInfo &Function = S.map().function(F);
    for (StringRef Name :
         {StringRef(Function.QualifiedName), StringRef(Function.BaseName)})
      if (!Name.empty() && Name.starts_with(Word))
        Found.insert(Name.str());
  }
  for (SourceFileId File = 0; File != S.info().files().size(); ++File) {
    StringRef Name = sys::path::filename(S.info().files().name(File));
    if (Name.starts_with(Word))
      Found.insert((Name + ":").str());
  }
}

static void addVariables(Shell &S, std::set<std::string> &Found,
                         StringRef Word) {
  const Variables &Names = S.info().variables();
  for (const std::vector<VariableInfo> &List :
       {Names.arguments(S.context()), Names.locals(S.context()),
        Names.globals()})
    for (const VariableInfo &Variable : List)
      if (StringRef(Variable.Name).starts_with(Word))
        Found.insert(Variable.Name);
}

static void addFiles(std::set<std::string> &Found, StringRef Word) {
  StringRef Folder = sys::path::parent_path(Word);
  std::error_code EC;
  for (sys::fs::directory_iterator I(Folder.empty() ? "." : Folder, EC), End;
       I != End && !EC; I.increment(EC)) {
    SmallString<128> Path(Folder);
    sys::path::append(Path, sys::path::filename(I->path()));
    if (Path.str().starts_with(Word))
      Found.insert(std::string(Path));
  }
}

std::vector<std::string> complete(Shell &S, StringRef Line) {
  std::set<std::string> Found;
  StringRef Word = lastWord(Line);
  CommandArguments Arguments{"", Line.ltrim()};
  bool IsCommand = !Arguments.Text.contains(' ');
  if (IsCommand) {
    Word = Arguments.Text;
    for (const CommandGroup &Group : commandGroups())
      addCommands(Found, Word, Group.Commands);
    return {Found.begin(), Found.end()};
  }
  StringRef Name = Arguments.takeWord().split('/').first;
  Expected<const Command *> Which = findCommand(allCommands(), Name, "");
  if (!Which) {
    consumeError(Which.takeError());
    return {};
  }
  switch ((*Which)->Completes) {
  case CompletionOf::Nothing:
    if ((*Which)->Name == "help")
      for (const CommandGroup &Group : commandGroups())
        addCommands(Found, Word, Group.Commands);
    break;
  case CompletionOf::Locations:
    addLocations(S, Found, Word);
    break;
  case CompletionOf::Expressions:
    addVariables(S, Found, Word);
    break;
  case CompletionOf::Subcommands: {
    ArrayRef<Command> Table =
        (*Which)->Name == "info" ? infoCommands() : setCommands();
    if (!Arguments.Text.contains(' '))
      addCommands(Found, Word, Table);
    else
      addVariables(S, Found, Word);
    break;
  }
  case CompletionOf::Files:
    Word = Arguments.Text;
    addFiles(Found, Word);
    break;
  }
  return {Found.begin(), Found.end()};
}

} // namespace tp
