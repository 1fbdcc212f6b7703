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
#include "llvm/Support/SaveAndRestore.h"

using namespace llvm;

namespace tp {

struct CommandLine::Implementation : Shell {
  using Shell::Shell;

  /// What an empty line executes.
  std::string Repeated;
  unsigned SourceDepth = 0;
  /// The commands of breakpoints are being executed.
  bool IsAtStop = false;

  /// Executes \p Line and the commands of the breakpoints at which it stops.
  llvm::Error run(StringRef Line, CommandLine &Commands);

private:
  /// One of the lines behind `commands`.
  void readListed(CommandList &List, StringRef Line);
  llvm::Error runOne(StringRef Line, CommandLine &Commands);
  llvm::Error runSourced(CommandLine &Commands);
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

void CommandLine::Implementation::readListed(CommandList &List,
                                             StringRef Line) {
  bool IsEnd = Line == "end" || Line == "DONE";
  if (IsEnd && List.Depth == 0) {
    for (unsigned Number : List.Breakpoints)
      if (Breakpoint *Of = Program.breakpoints().find(Number))
        Of->Commands = List.Lines;
    Listing.reset();
    return;
  }
  if (IsEnd)
    --List.Depth;
  else if (CommandArguments Arguments; takeName(Line, Arguments) == "commands")
    ++List.Depth;
  List.Lines.push_back(Line.str());
}

llvm::Error CommandLine::Implementation::runOne(StringRef Line,
                                                CommandLine &Commands) {
  if (Listing) {
    readListed(*Listing, Line);
    return llvm::Error::success();
  }
  Expected<std::string> Translated = fromLldb(Line);
  if (!Translated)
    return Translated.takeError();
  CommandArguments Arguments;
  StringRef Name = takeName(*Translated, Arguments);
  Expected<const Command *> Found = findCommand(allCommands(), Name, "");
  if (!Found)
    return Found.takeError();
  if (!IsAtStop)
    Repeated.clear();
  if ((*Found)->Repeats && !IsAtStop)
    Repeated = (*Found)->Name == "list" || (*Found)->Name == "x"
                   ? (*Found)->Name.str()
                   : Line.str();
  if (llvm::Error E = (*Found)->Run(*this, Arguments))
    return E;
  return Sourced.empty() ? llvm::Error::success() : runSourced(Commands);
}

llvm::Error CommandLine::Implementation::runSourced(CommandLine &Commands) {
  constexpr unsigned MostNested = 16;
  std::string Path = std::exchange(Sourced, "");
  if (SourceDepth == MostNested)
    return createStringError("source files are nested too deeply");
  ++SourceDepth;
  Expected<std::optional<int>> Quit = runScript(Commands, Path, OS);
  --SourceDepth;
  if (!Quit)
    return Quit.takeError();
  Result.Quit = *Quit;
  return llvm::Error::success();
}

llvm::Error CommandLine::Implementation::run(StringRef Line,
                                             CommandLine &Commands) {
  if (llvm::Error E = runOne(Line, Commands))
    return E;
  if (IsAtStop)
    return llvm::Error::success();
  SaveAndRestore AtStop(IsAtStop, true);
  while (Result.Stop && !Result.Stop->Commands.empty() && !Result.Quit) {
    SessionStop Stop = std::move(*Result.Stop);
    Result.Stop.reset();
    for (const std::string &Listed : std::exchange(Stop.Commands, {})) {
      if (Listed == "silent")
        continue;
      if (llvm::Error E = runOne(Listed, Commands)) {
        Result.Stop = std::move(Stop);
        return E;
      }
      if (Result.Stop || Result.Quit)
        break;
    }
    if (!Result.Stop)
      Result.Stop = std::move(Stop);
  }
  return llvm::Error::success();
}

CommandLine::CommandLine(Session &Session, raw_ostream &OS)
    : Inside(std::make_unique<Implementation>(Session, OS)) {}

CommandLine::~CommandLine() = default;

CommandResult CommandLine::execute(StringRef Line) {
  if (Inside->SourceDepth == 0)
    Inside->Result = CommandResult();
  Line = Line.trim();
  std::string Again;
  if (Line.empty() && !Inside->Listing)
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

StringRef CommandLine::prompt() const {
  return Inside->Listing ? ">" : "(tpdbg) ";
}

bool CommandLine::dropUnfinished() {
  return std::exchange(Inside->Listing, std::nullopt).has_value();
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
