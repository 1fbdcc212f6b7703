//===- Script.cpp - Commands from a file or the keyboard ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Script.h"

#include "debugger/cli/Completion.h"

#include "llvm/LineEditor/LineEditor.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/Process.h"

#include <iostream>

using namespace llvm;

namespace tp {

Expected<std::optional<int>> runScript(CommandLine &Commands, StringRef Path,
                                       raw_ostream &OS) {
  llvm::ErrorOr<std::unique_ptr<MemoryBuffer>> Text =
      MemoryBuffer::getFile(Path);
  if (!Text)
    return createStringError(Path + ": " + Text.getError().message() + ".");
  SmallVector<StringRef> Lines;
  (*Text)->getBuffer().split(Lines, '\n');
  for (size_t I = 0; I != Lines.size(); ++I) {
    if (Lines[I].trim().empty())
      continue;
    CommandResult Result = Commands.execute(Lines[I]);
    if (Result.Failed)
      return createStringError(Path + ":" + Twine(I + 1) +
                               ": Error in sourced command file.");
    if (Result.Quit)
      return Result.Quit;
  }
  if (Commands.dropUnfinished())
    return createStringError(Path + ": \"end\" of commands is missing");
  return std::nullopt;
}

static std::vector<LineEditor::Completion>
completionsFor(CommandLine &Commands, StringRef Line, size_t Cursor) {
  std::vector<LineEditor::Completion> Result;
  StringRef Word = lastWord(Line.take_front(Cursor));
  for (const std::string &Whole : Commands.completions(Line, Cursor))
    if (StringRef(Whole).starts_with(Word))
      Result.emplace_back(Whole.substr(Word.size()), Whole);
  return Result;
}

static int runOnTerminal(CommandLine &Commands, raw_ostream &OS) {
  LineEditor Editor("tpdbg", LineEditor::getDefaultHistoryPath("tpdbg"));
  Editor.setListCompleter([&](StringRef Line, size_t Cursor) {
    return completionsFor(Commands, Line, Cursor);
  });
  for (;;) {
    OS.flush();
    Editor.setPrompt(Commands.prompt().str());
    std::optional<std::string> Line = Editor.readLine();
    if (!Line)
      return 0;
    if (CommandResult Result = Commands.execute(*Line); Result.Quit)
      return *Result.Quit;
  }
}

int runInteractively(CommandLine &Commands, raw_ostream &OS) {
  if (sys::Process::StandardInIsUserInput())
    return runOnTerminal(Commands, OS);
  std::string Line;
  while (std::getline(std::cin, Line))
    if (CommandResult Result = Commands.execute(Line); Result.Quit)
      return *Result.Quit;
  return 0;
}

} // namespace tp
