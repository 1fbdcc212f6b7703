//===- CommandLine.cpp - The debugger's commands --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/CommandLine.h"

#include "debugger/cli/Command.h"
#include "debugger/cli/Completion.h"
#include "debugger/cli/LldbWords.h"
#include "debugger/cli/Script.h"
#include "debugger/cli/Shell.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

struct CommandLine::Implementation : Shell {
  using Shell::Shell;

  /// What an empty line executes.
  std::string Repeated;
  unsigned SourceDepth = 0;

  llvm::Error run(StringRef Line, CommandLine &Commands);
};

/// Splits `x/4xw $sp` into name and the rest.
static StringRef takeName(StringRef Line, CommandArguments &Arguments) {
  StringRef Name = Line.take_while(
      [](char C) { return isAlnum(C) || C == '-' || C == '_'; });
  StringRef Rest = Line.drop_front(Name.size());
  if (Rest.consume_front("/")) {
    Arguments.Format = Rest.take_until(isSpace);
    Rest = Rest.drop_front(Arguments.Format.size());
  }
  Arguments.Text = Rest.trim();
  return Name;
}

llvm::Error CommandLine::Implementation::run(StringRef Line,
                                             CommandLine &Commands) {
  Expected<std::string> Translated = fromLldb(Line);
  if (!Translated)
    return Translated.takeError();
  CommandArguments Arguments;
  StringRef Name = takeName(*Translated, Arguments);
  Expected<const Command *> Found = findCommand(allCommands(), Name, "");
  if (!Found)
    return Found.takeError();
  Repeated.clear();
  if ((*Found)->Repeats)
    Repeated = (*Found)->Name == "list" || (*Found)->Name == "x"
                   ? (*Found)->Name.str()
                   : Line.str();
  if (llvm::Error E = (*Found)->Run(*this, Arguments))
    return E;
  if (Sourced.empty())
    return llvm::Error::success();
  constexpr unsigned MostNested = 16;
  if (SourceDepth == MostNested)
    return createStringError("source files are nested too deeply");
  std::string Path = std::exchange(Sourced, "");
  ++SourceDepth;
  Expected<std::optional<int>> Quit = runScript(Commands, Path, OS);
  --SourceDepth;
  if (!Quit)
    return Quit.takeError();
  Result.Quit = *Quit;
  return llvm::Error::success();
}

CommandLine::CommandLine(Session &Session, raw_ostream &OS)
    : Inside(std::make_unique<Implementation>(Session, OS)) {}

CommandLine::~CommandLine() = default;

CommandResult CommandLine::execute(StringRef Line) {
  Inside->Result = CommandResult();
  Line = Line.trim();
  std::string Again;
  if (Line.empty())
    Line = Again = Inside->Repeated;
  if (Line.empty() || Line.front() == '#')
    return Inside->Result;
  if (llvm::Error E = Inside->run(Line, *this)) {
    Inside->OS << toString(std::move(E)) << '\n';
    Inside->Result.Failed = true;
  }
  Inside->OS.flush();
  return Inside->Result;
}

uint32_t CommandLine::selectedThread() const { return Inside->Thread; }

unsigned CommandLine::selectedFrame() const { return Inside->FrameIndex; }

void CommandLine::select(uint32_t Thread, unsigned Frame) {
  Inside->changed();
  Inside->select(Thread, Frame);
}

std::vector<std::string> CommandLine::completions(StringRef Line,
                                                  size_t Cursor) {
  return complete(*Inside, Line.take_front(Cursor));
}

} // namespace tp
