//===- SourceCommands.cpp - Commands about source and instructions --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Command.h"
#include "debugger/cli/Views.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

llvm::Error printLines(Shell &S, SourceFileId File, uint32_t First,
                       uint32_t Last) {
  Expected<ArrayRef<StringRef>> Text = S.info().files().text(File);
  if (!Text)
    return Text.takeError();
  First = std::max(First, 1u);
  if (First > Text->size())
    return createStringError("Line number " + Twine(First) +
                             " out of range; \"" + S.info().files().name(File) +
                             "\" has " + Twine(Text->size()) + " lines.");
  Last = std::min<uint32_t>(Last, Text->size());
  for (uint32_t Line = First; Line <= Last; ++Line)
    S.OS << Line << '\t' << (*Text)[Line - 1] << '\n';
  S.Listed = {File, Last, 0};
  S.IsListedBehind = true;
  return llvm::Error::success();
}

static llvm::Error listAround(Shell &S, SourcePosition Position) {
  uint32_t Before = S.ListSize / 2;
  uint32_t First = Position.Line > Before ? Position.Line - Before : 1;
  return printLines(S, Position.File, First, First + S.ListSize - 1);
}

static llvm::Error listCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty()) {
    if (!S.Listed.isKnown()) {
      SourcePosition Here = S.locationDefaults().Position;
      if (!Here.isKnown())
        return createStringError("No line number information here; compile "
                                 "with -g.");
      return listAround(S, Here);
    }
    if (!S.IsListedBehind)
      return listAround(S, S.Listed);
    return printLines(S, S.Listed.File, S.Listed.Line + 1,
                      S.Listed.Line + S.ListSize);
  }
  if (Arguments.Text == "-") {
    if (!S.Listed.isKnown())
      return createStringError("Nothing has been listed yet.");
    uint32_t Shown = S.IsListedBehind ? S.ListSize : S.ListSize / 2;
    uint32_t Begin = S.Listed.Line > Shown ? S.Listed.Line - Shown : 0;
    if (Begin == 0)
      return createStringError("Already at the start of " +
                               S.info().files().name(S.Listed.File) + ".");
    uint32_t First = Begin > S.ListSize ? Begin - S.ListSize + 1 : 1;
    return printLines(S, S.Listed.File, First, Begin);
  }
  LocationDefaults Defaults = S.locationDefaults();
  if (S.Listed.isKnown())
    Defaults.Position = S.Listed;
  auto [FirstText, LastText] = Arguments.Text.split(',');
  if (!Arguments.Text.contains(',')) {
    Expected<SourcePosition> Center =
        findLine(FirstText.trim(), S.info(), Defaults);
    if (!Center)
      return Center.takeError();
    return listAround(S, *Center);
  }
  Expected<SourcePosition> First =
      FirstText.trim().empty() ? Defaults.Position
                               : findLine(FirstText.trim(), S.info(), Defaults);
  if (!First)
    return First.takeError();
  uint32_t Last = First->Line + S.ListSize - 1;
  if (!LastText.trim().empty()) {
    Expected<SourcePosition> End =
        findLine(LastText.trim(), S.info(), {*First, Defaults.Frame});
    if (!End)
      return End.takeError();
    Last = End->Line;
    if (Last < First->Line)
      return createStringError("Line " + Twine(Last) + " is before line " +
                               Twine(First->Line) + ".");
  }
  return printLines(S, First->File, First->Line, Last);
}

/// The lines between which instructions of one range stand.
static llvm::Error printRange(Shell &S, uint32_t Begin, uint32_t End,
                              bool WithSource) {
  SourcePosition Last;
  for (uint64_t At = Begin; At < End; At += 4) {
    auto Pc = uint32_t(At);
    const LineRange *Line = S.map().lineAt(Pc);
    if (WithSource && Line && Line->Position.isKnown() &&
        (Line->Position.File != Last.File ||
         Line->Position.Line != Last.Line)) {
      Last = Line->Position;
      S.OS << S.info().files().shortName(Last) << ":\t"
           << S.info().files().line(Last).value_or("") << '\n';
    }
    if (llvm::Error E = S.printInstruction(Pc))
      return E;
  }
  return llvm::Error::success();
}

static llvm::Error disassembleCommand(Shell &S, CommandArguments Arguments) {
  bool WithSource = StringRef(Arguments.Format).contains('s');
  if (!Arguments.Format.empty() && Arguments.Format != "s")
    return createStringError("Invalid disassembly modifier: only /s.");
  if (Arguments.Text.consume_front("/s"))
    WithSource = true;
  StringRef Text = Arguments.Text.trim();
  auto [First, Second] = Text.split(',');
  if (Text.contains(',')) {
    Expected<uint32_t> Begin = S.evaluateAddress(First.trim());
    if (!Begin)
      return Begin.takeError();
    Second = Second.trim();
    bool IsLength = Second.consume_front("+");
    Expected<uint32_t> End = S.evaluateAddress(Second);
    if (!End)
      return End.takeError();
    return printRange(S, *Begin & ~3u,
                      IsLength ? SaturatingAdd(*Begin, *End) : *End,
                      WithSource);
  }
  uint32_t Pc = S.context().lookupPc();
  if (!Text.empty()) {
    Expected<uint32_t> Address = S.evaluateAddress(Text);
    if (!Address)
      return Address.takeError();
    Pc = *Address;
  }
  std::optional<uint32_t> Function = S.map().functionAt(Pc);
  if (!Function)
    return createStringError(
        "No function contains the address; give a range: disassemble A,B");
  const FunctionInfo &In = S.map().function(*Function);
  S.OS << "Dump of assembler code for function " << In.Name << ":\n";
  for (const AddressRange &Range : In.Ranges)
    if (llvm::Error E = printRange(S, Range.Begin, Range.End, WithSource))
      return E;
  S.OS << "End of assembler dump.\n";
  return llvm::Error::success();
}

static llvm::Error directoryCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("Argument required (a folder).");
  S.info().files().addFolder(Arguments.Text);
  S.OS << "Source files are also looked for in " << Arguments.Text << '\n';
  return llvm::Error::success();
}

static constexpr Command Table[] = {
    {"list", "l", "[LINE | FUNCTION | FILE:LINE | FIRST,LAST | -]",
     "Print source lines around a place, or on from the last ones.",
     listCommand, true, CompletionOf::Locations},
    {"disassemble", "disas di", "[/s] [ADDRESS | BEGIN,END | BEGIN,+LENGTH]",
     "Print the instructions of a function; with /s among the source lines.",
     disassembleCommand, false, CompletionOf::Expressions},
    {"directory", "dir", "FOLDER",
     "Look for source files in another folder too.", directoryCommand, false,
     CompletionOf::Files}};

ArrayRef<Command> sourceCommands() { return Table; }

} // namespace tp
