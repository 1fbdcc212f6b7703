//===- BreakpointCommands.cpp - Commands about breakpoints ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Command.h"
#include "debugger/cli/Shell.h"
#include "debugger/cli/Views.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

namespace {

/// `LOCATION thread N if CONDITION` in its parts.
struct BreakpointText {
  StringRef Location;
  std::optional<uint32_t> Thread;
  StringRef Condition;
};

} // namespace

/// Where the word \p Word begins in \p Text, or npos.
static size_t findWord(StringRef Text, StringRef Word) {
  for (size_t At = Text.find(Word); At != StringRef::npos;
       At = Text.find(Word, At + 1)) {
    StringRef Behind = Text.substr(At + Word.size());
    bool Begins = At == 0 || isSpace(Text[At - 1]);
    if (Begins &&
        (Behind.empty() || isSpace(Behind.front()) || Behind.front() == '('))
      return At;
  }
  return StringRef::npos;
}

static Expected<BreakpointText> splitBreakpoint(Shell &S, StringRef Text) {
  BreakpointText Result;
  if (size_t If = findWord(Text, "if"); If != StringRef::npos) {
    Result.Condition = Text.substr(If + 2).trim();
    Text = Text.take_front(If);
    if (Result.Condition.empty())
      return createStringError("Argument required (a condition behind if).");
  }
  size_t At = findWord(Text, "thread");
  StringRef Name = At == StringRef::npos ? "" : Text.substr(At + 6).trim();
  if (!Name.empty()) {
    Text = Text.take_front(At);
    if (Name != "all") {
      Expected<uint32_t> Thread = parseThread(Name, S.Program.chip());
      if (!Thread)
        return Thread.takeError();
      Result.Thread = *Thread;
    }
  }
  Result.Location = Text.trim();
  return Result;
}

static llvm::Error finishBreakpoint(Shell &S, Breakpoint &New,
                                    const BreakpointText &Text) {
  New.Thread = Text.Thread;
  if (llvm::Error E = S.Program.setCondition(New, Text.Condition)) {
    S.Program.breakpoints().remove(New.Number);
    return E;
  }
  S.Result.HasChanged = true;
  return llvm::Error::success();
}

static llvm::Error addBreakpoint(Shell &S, CommandArguments Arguments,
                                 bool IsTemporary) {
  Expected<BreakpointText> Text = splitBreakpoint(S, Arguments.Text);
  if (!Text)
    return Text.takeError();
  Expected<Breakpoint *> New =
      S.Program.addBreakpoint(Text->Location, S.locationDefaults());
  if (!New)
    return New.takeError();
  (*New)->Temporary = IsTemporary;
  if (llvm::Error E = finishBreakpoint(S, **New, *Text))
    return E;
  const CodeLocation &First = (*New)->Locations.front();
  S.OS << (IsTemporary ? "Temporary breakpoint " : "Breakpoint ")
       << (*New)->Number << " at " << format_hex(First.Address, 10) << ": ";
  if ((*New)->Locations.size() > 1)
    S.OS << (*New)->Text << ". (" << (*New)->Locations.size()
         << " locations)\n";
  else if (First.Position.isKnown())
    S.OS << "file " << S.info().files().name(First.Position.File) << ", line "
         << First.Position.Line << ".\n";
  else
    S.OS << S.map().describeAddress(First.Address) << '\n';
  return llvm::Error::success();
}

static llvm::Error breakCommand(Shell &S, CommandArguments Arguments) {
  return addBreakpoint(S, Arguments, false);
}

static llvm::Error temporaryCommand(Shell &S, CommandArguments Arguments) {
  return addBreakpoint(S, Arguments, true);
}

/// `-r ADDRESS BYTES`.
static Expected<Breakpoint *> watchRange(Shell &S, StringRef Text, bool Reads,
                                         bool Writes) {
  auto [AddressText, SizeText] = Text.trim().rsplit(' ');
  if (SizeText.empty())
    return createStringError("Argument required (-r ADDRESS BYTES).");
  Expected<uint32_t> Address = S.evaluateAddress(AddressText);
  if (!Address)
    return Address.takeError();
  Expected<uint64_t> Bytes = S.evaluateInteger(SizeText);
  if (!Bytes)
    return Bytes.takeError();
  if (*Bytes > UINT32_MAX)
    return createStringError("Not a number of bytes: " + SizeText);
  return S.Program.addWatchpoint(*Address, uint32_t(*Bytes), S.Thread, Reads,
                                 Writes);
}

template <bool Reads, bool Writes>
static llvm::Error watchCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("Argument required (expression to compute).");
  Expected<BreakpointText> Text = splitBreakpoint(S, Arguments.Text);
  if (!Text)
    return Text.takeError();
  StringRef What = Text->Location;
  Expected<Breakpoint *> New = nullptr;
  if (What.consume_front("-r "))
    New = watchRange(S, What, Reads, Writes);
  else {
    bool IsLocation =
        What.consume_front("-l ") || What.consume_front("-location ");
    New = S.Program.addWatchpoint(What.trim(), S.Thread, S.context(), Reads,
                                  Writes, IsLocation);
  }
  if (!New)
    return New.takeError();
  if (llvm::Error E = finishBreakpoint(S, **New, *Text))
    return E;
  S.OS << (!Reads   ? "Watchpoint "
           : Writes ? "Access watchpoint "
                    : "Read watchpoint ")
       << (*New)->Number << ": " << (*New)->Text << '\n';
  return llvm::Error::success();
}

static Expected<Breakpoint *> numbered(Shell &S, StringRef Text) {
  unsigned Number;
  if (Text.getAsInteger(10, Number))
    return createStringError("bad breakpoint number: '" + Text + "'");
  Breakpoint *Found = S.Program.breakpoints().find(Number);
  if (!Found)
    return createStringError("No breakpoint number " + Twine(Number) + ".");
  return Found;
}

/// Calls \p Do with each of the breakpoints `1 3-5`, or all.
static llvm::Error forEach(Shell &S, StringRef Text,
                           function_ref<void(Breakpoint &)> Do) {
  S.Result.HasChanged = true;
  if (Text.empty()) {
    std::vector<unsigned> Numbers;
    for (const std::unique_ptr<Breakpoint> &B : S.Program.breakpoints().all())
      Numbers.push_back(B->Number);
    for (unsigned Number : Numbers)
      Do(*S.Program.breakpoints().find(Number));
    return llvm::Error::success();
  }
  SmallVector<StringRef> Words;
  Text.split(Words, ' ', -1, false);
  for (StringRef Word : Words) {
    auto [First, Last] = Word.split('-');
    unsigned Begin, End;
    if (First.getAsInteger(10, Begin) ||
        (Last.empty() ? First : Last).getAsInteger(10, End) || End < Begin)
      return createStringError("bad breakpoint number: '" + Word + "'");
    for (unsigned Number = Begin; Number <= End; ++Number) {
      Breakpoint *Found = S.Program.breakpoints().find(Number);
      if (!Found)
        return createStringError("No breakpoint number " + Twine(Number) + ".");
      Do(*Found);
    }
  }
  return llvm::Error::success();
}

static llvm::Error deleteCommand(Shell &S, CommandArguments Arguments) {
  Arguments.Text.consume_front("breakpoints");
  if (Arguments.Text.consume_front("display"))
    return undisplay(S, Arguments.Text.trim());
  return forEach(S, Arguments.Text.trim(), [&](Breakpoint &B) {
    S.Program.breakpoints().remove(B.Number);
  });
}

template <bool IsEnabled>
static llvm::Error enableCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.Text.consume_front("display"))
    return enableDisplays(S, Arguments.Text.trim(), IsEnabled);
  return forEach(S, Arguments.Text,
                 [](Breakpoint &B) { B.Enabled = IsEnabled; });
}

static llvm::Error clearCommand(Shell &S, CommandArguments Arguments) {
  Expected<std::vector<CodeLocation>> Found =
      findLocations(Arguments.Text, S.info(), S.locationDefaults());
  if (!Found)
    return Found.takeError();
  std::vector<unsigned> Numbers;
  for (const std::unique_ptr<Breakpoint> &B : S.Program.breakpoints().all())
    if (any_of(B->Locations, [&](const CodeLocation &L) {
          return any_of(*Found, [&](const CodeLocation &F) {
            return F.Address == L.Address;
          });
        }))
      Numbers.push_back(B->Number);
  if (Numbers.empty())
    return createStringError("No breakpoint at " + Arguments.Text + ".");
  S.OS << "Deleted breakpoint" << (Numbers.size() > 1 ? "s" : "");
  for (unsigned Number : Numbers) {
    S.OS << ' ' << Number;
    S.Program.breakpoints().remove(Number);
  }
  S.OS << '\n';
  return llvm::Error::success();
}

static llvm::Error conditionCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("Argument required (breakpoint number).");
  Expected<Breakpoint *> Found = numbered(S, Arguments.takeWord());
  if (!Found)
    return Found.takeError();
  if (llvm::Error E = S.Program.setCondition(**Found, Arguments.Text))
    return E;
  if (Arguments.isEmpty())
    S.OS << "Breakpoint " << (*Found)->Number << " now unconditional.\n";
  return llvm::Error::success();
}

static llvm::Error ignoreCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("Argument required (a breakpoint number).");
  Expected<Breakpoint *> Found = numbered(S, Arguments.takeWord());
  if (!Found)
    return Found.takeError();
  Expected<uint64_t> Count = parseCount(Arguments.Text, 0);
  if (!Count)
    return Count.takeError();
  (*Found)->Ignore = *Count;
  S.OS << "Will ignore next " << *Count << " crossings of breakpoint "
       << (*Found)->Number << ".\n";
  return llvm::Error::success();
}

/// The lines up to `end` follow as commands of their own.
static llvm::Error commandsCommand(Shell &S, CommandArguments Arguments) {
  if (S.Program.breakpoints().all().empty())
    return createStringError("No breakpoints specified.");
  CommandList List;
  if (Arguments.isEmpty())
    List.Breakpoints = {S.Program.breakpoints().all().back()->Number};
  else if (llvm::Error E = forEach(S, Arguments.Text, [&](Breakpoint &B) {
             List.Breakpoints.push_back(B.Number);
           }))
    return E;
  S.Listing = std::move(List);
  return llvm::Error::success();
}

static constexpr Command Table[] = {
    {"break", "b br", "[LOCATION] [thread N|TM.TP|all] [if CONDITION]",
     "Stop before a place in the program.\n"
     "LOCATION is FILE:LINE, LINE, FUNCTION, FILE:FUNCTION or *ADDRESS; "
     "without it the selected frame's place.",
     breakCommand, false, CompletionOf::Locations},
    {"tbreak", "tb", "[LOCATION] [thread N|TM.TP|all] [if CONDITION]",
     "Like break, but only once.", temporaryCommand, false,
     CompletionOf::Locations},
    {"watch", "",
     "[-l] EXPRESSION | -r ADDRESS BYTES [thread N] [if CONDITION]",
     "Stop when an object in memory changes, whoever writes it.\n"
     "A watchpoint on a variable of a function ends when that returns, but "
     "not with -l.",
     watchCommand<false, true>, false, CompletionOf::Expressions},
    {"rwatch", "",
     "[-l] EXPRESSION | -r ADDRESS BYTES [thread N] [if CONDITION]",
     "Stop when an object in memory is read.", watchCommand<true, false>, false,
     CompletionOf::Expressions},
    {"awatch", "",
     "[-l] EXPRESSION | -r ADDRESS BYTES [thread N] [if CONDITION]",
     "Stop when an object in memory is read or written.",
     watchCommand<true, true>, false, CompletionOf::Expressions},
    {"delete", "d del", "[NUMBER...]",
     "Delete breakpoints and watchpoints, or all; \"delete display\": "
     "displays.",
     deleteCommand},
    {"clear", "cl", "[LOCATION]", "Delete the breakpoints at a location.",
     clearCommand, false, CompletionOf::Locations},
    {"enable", "", "[display] [NUMBER...]",
     "Enable breakpoints and watchpoints, or all; or displays.",
     enableCommand<true>},
    {"disable", "dis", "[display] [NUMBER...]",
     "Disable breakpoints and watchpoints, or all; or displays.",
     enableCommand<false>},
    {"condition", "", "NUMBER [CONDITION]",
     "Let a breakpoint stop only if a condition holds, or always.",
     conditionCommand},
    {"ignore", "", "NUMBER COUNT",
     "Let a breakpoint not stop the next COUNT times.", ignoreCommand},
    {"commands", "", "[NUMBER...]",
     "Execute the following lines, up to \"end\", whenever a breakpoint "
     "stops.\n"
     "Without NUMBER that of the last one. \"silent\" as the first line leaves "
     "out where\nthe program stopped; nothing is executed behind a command "
     "that "
     "lets it run.",
     commandsCommand}};

ArrayRef<Command> breakpointCommands() { return Table; }

} // namespace tp
