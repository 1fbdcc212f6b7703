//===- InfoCommands.cpp - The commands behind info ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Command.h"
#include "debugger/cli/Views.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/bit.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

/// `0x000100b8 in sum(int) at tree.cpp:44`.
static void printLocation(Shell &S, const CodeLocation &At) {
  S.OS << format_hex(At.Address, 10);
  std::optional<uint32_t> Function = At.Function;
  std::vector<InlinedCall> Calls = S.map().callsAt(At.Address);
  if (!Function && !Calls.empty())
    Function = Calls.front().Function;
  if (Function)
    S.OS << " in " << S.map().function(*Function).Name;
  if (At.Position.isKnown())
    S.OS << " at " << S.info().files().shortName(At.Position);
  S.OS << '\n';
}

static void printBreakpoint(Shell &S, const Breakpoint &B) {
  StringRef Kind = !B.isWatchpoint() ? "breakpoint"
                   : !B.Reads        ? "watchpoint"
                   : B.Writes        ? "acc watchpoint"
                                     : "read watchpoint";
  S.OS << left_justify(utostr(B.Number), 8) << left_justify(Kind, 17)
       << (B.Temporary ? "del  " : "keep ") << (B.Enabled ? "y   " : "n   ");
  if (B.isWatchpoint()) {
    S.OS << B.Text << '\n';
  } else if (B.Locations.size() == 1) {
    printLocation(S, B.Locations.front());
  } else {
    S.OS << "<MULTIPLE>\n";
  }
  if (B.Condition)
    S.OS << "\tstop only if " << B.Condition->text() << '\n';
  if (B.Thread)
    S.OS << "\tstop only in " << S.threadName(*B.Thread) << '\n';
  if (B.Hits != 0)
    S.OS << "\tbreakpoint already hit " << B.Hits
         << (B.Hits == 1 ? " time\n" : " times\n");
  if (B.Ignore != 0)
    S.OS << "\tignore next " << B.Ignore << " hits\n";
  for (const std::string &Line : B.Commands)
    S.OS << "        " << Line << '\n';
  if (B.Locations.size() > 1)
    for (size_t I = 0; I != B.Locations.size(); ++I) {
      S.OS << left_justify(utostr(B.Number) + "." + utostr(I + 1), 32);
      printLocation(S, B.Locations[I]);
    }
}

static llvm::Error infoBreakpoints(Shell &S, CommandArguments) {
  if (S.Program.breakpoints().all().empty()) {
    S.OS << "No breakpoints or watchpoints.\n";
    return llvm::Error::success();
  }
  S.OS << "Num     Type             Disp Enb What\n";
  for (const std::unique_ptr<Breakpoint> &B : S.Program.breakpoints().all())
    printBreakpoint(S, *B);
  return llvm::Error::success();
}

static llvm::Error infoThreads(Shell &S, CommandArguments) {
  printThreads(S);
  return llvm::Error::success();
}

static llvm::Error infoLocals(Shell &S, CommandArguments) {
  std::vector<VariableInfo> Locals = S.info().variables().locals(S.context());
  if (Locals.empty())
    S.OS << "No locals.\n";
  printVariables(S, Locals, S.context());
  return llvm::Error::success();
}

static llvm::Error infoArguments(Shell &S, CommandArguments) {
  std::vector<VariableInfo> Arguments =
      S.info().variables().arguments(S.context());
  if (Arguments.empty())
    S.OS << "No arguments.\n";
  printVariables(S, Arguments, S.context());
  return llvm::Error::success();
}

static llvm::Error infoAllVariables(Shell &S, CommandArguments) {
  printVariables(S, S.info().variables().arguments(S.context()), S.context());
  printVariables(S, S.info().variables().locals(S.context()), S.context());
  return llvm::Error::success();
}

static void printRegister(Shell &S, unsigned Register) {
  const RegisterSet &Registers = S.context().Registers;
  S.OS << left_justify(registerName(Register), 8);
  if (!Registers.isKnown(Register)) {
    S.OS << "<not saved>\n";
    return;
  }
  uint32_t Bits = Registers.Values[Register];
  uint8_t Bytes[4];
  support::endian::write32le(Bytes, Bits);
  S.OS << format_hex(Bits, 10) << "  "
       << formatNumber(Bytes, Register < DwarfFirstFloat ? 'd' : 'f', S.map())
       << '\n';
}

static llvm::Error infoRegisters(Shell &S, CommandArguments Arguments) {
  bool IsAll = Arguments.isEmpty();
  auto PrintPc = [&] {
    S.OS << left_justify("pc", 8) << S.map().describeAddress(S.context().Pc)
         << '\n';
  };
  if (IsAll) {
    for (unsigned Register = 0; Register != DwarfRegisters; ++Register)
      printRegister(S, Register);
    PrintPc();
    return llvm::Error::success();
  }
  while (!Arguments.isEmpty()) {
    StringRef Name = Arguments.takeWord();
    Name.consume_front("$");
    unsigned Number;
    bool IsFloat = Name.starts_with("f");
    if (Name == "pc") {
      PrintPc();
    } else if (Name == "sp") {
      printRegister(S, StackPointerRegister);
    } else if ((Name.starts_with("r") || IsFloat) &&
               !Name.drop_front().getAsInteger(10, Number) &&
               Number < DwarfFirstFloat) {
      printRegister(S, Number + (IsFloat ? DwarfFirstFloat : 0));
    } else {
      return createStringError("Invalid register `" + Name +
                               "'; there are r0 to r31, f0 to f31, sp and pc");
    }
  }
  return llvm::Error::success();
}

static llvm::Error infoFrame(Shell &S, CommandArguments) {
  const Frame &At = S.frame();
  S.OS << "Stack level " << S.FrameIndex << ", frame at "
       << format_hex(At.Cfa, 10)
       << ":\n pc = " << format_hex(At.Context.Pc, 10);
  if (At.Function)
    S.OS << " in " << S.map().function(*At.Function).Name;
  if (At.Position.isKnown())
    S.OS << " (" << S.info().files().shortName(At.Position) << ')';
  S.OS << '\n';
  if (At.Inlined)
    S.OS << " inlined into frame " << S.FrameIndex + 1 << '\n';
  Expected<std::optional<FrameContext>> Caller =
      S.info().unwinder().caller(At.Context);
  if (!Caller)
    return Caller.takeError();
  const std::optional<FrameContext> &Outer = *Caller;
  if (!Outer) {
    S.OS << " outermost frame\n";
    return llvm::Error::success();
  }
  S.OS << " called from " << S.map().describeAddress(Outer->lookupPc()) << '\n';
  ListSeparator Separator;
  bool HasSaved = false;
  for (unsigned R = 0; R != DwarfRegisters; ++R)
    if (Outer->SavedAt[R] != At.Context.SavedAt[R]) {
      if (!HasSaved)
        S.OS << " Saved registers:\n  ";
      HasSaved = true;
      S.OS << Separator << registerName(R) << " at "
           << format_hex(Outer->SavedAt[R], 10);
    }
  if (HasSaved)
    S.OS << '\n';
  return llvm::Error::success();
}

static llvm::Error infoLine(Shell &S, CommandArguments Arguments) {
  LocationDefaults Defaults = S.locationDefaults();
  Expected<std::vector<CodeLocation>> Found =
      findLocations(Arguments.Text, S.info(), Defaults);
  if (!Found)
    return Found.takeError();
  for (const CodeLocation &At : *Found) {
    const LineRange *Line = S.map().lineAt(At.Address);
    if (!Line || !Line->Position.isKnown()) {
      S.OS << "No line number information available for address "
           << S.map().describeAddress(At.Address) << '\n';
      continue;
    }
    S.OS << "Line " << Line->Position.Line << " of \""
         << S.info().files().name(Line->Position.File)
         << "\" starts at address " << S.map().describeAddress(Line->Begin)
         << " and ends at " << S.map().describeAddress(Line->End) << ".\n";
    S.Examined = Line->Begin;
  }
  return llvm::Error::success();
}

static llvm::Error infoSymbol(Shell &S, CommandArguments Arguments) {
  Expected<uint32_t> Address = S.evaluateAddress(Arguments.Text);
  if (!Address)
    return Address.takeError();
  if (std::optional<std::string> Symbol = S.map().symbolAt(*Address))
    S.OS << *Symbol << '\n';
  else
    S.OS << "No symbol matches " << Arguments.Text << ".\n";
  return llvm::Error::success();
}

static llvm::Error infoSource(Shell &S, CommandArguments) {
  SourcePosition At = S.locationDefaults().Position;
  if (!At.isKnown())
    return createStringError("No current source file.");
  SourceFiles &Files = S.info().files();
  S.OS << "Current source file is " << Files.name(At.File) << "\nLocated in "
       << Files.path(At.File) << '\n';
  Expected<ArrayRef<StringRef>> Text = Files.text(At.File);
  if (!Text)
    return Text.takeError();
  S.OS << "Contains " << Text->size() << " lines.\n";
  if (Files.hasChanged(At.File))
    S.OS << "It is not what was compiled.\n";
  return llvm::Error::success();
}

static llvm::Error infoSources(Shell &S, CommandArguments) {
  for (SourceFileId File = 0; File != S.info().files().size(); ++File)
    S.OS << S.info().files().path(File) << '\n';
  return llvm::Error::success();
}

static llvm::Error infoFunctions(Shell &S, CommandArguments Arguments) {
  std::vector<std::string> Names;
  for (uint32_t F = 0; F != S.map().functionCount(); ++F) {
    const FunctionInfo &Function = S.map().function(F);
    if (!Function.InlinedInto &&
        StringRef(Function.Name).contains(Arguments.Text))
      Names.push_back("0x" + utohexstr(Function.Entry, true, 8) + "  " +
                      Function.Name);
  }
  sort(Names);
  for (const std::string &Name : Names)
    S.OS << Name << '\n';
  return llvm::Error::success();
}

static llvm::Error infoVariables(Shell &S, CommandArguments Arguments) {
  for (const VariableInfo &Variable : S.info().variables().globals())
    if (StringRef(Variable.Name).contains(Arguments.Text))
      S.OS << (Variable.Of ? Variable.Of->Name : "?") << ' ' << Variable.Name
           << '\n';
  return llvm::Error::success();
}

static llvm::Error infoCheckpoints(Shell &S, CommandArguments) {
  CheckpointUse Use = S.Program.replay().checkpoints();
  S.OS << Use.Checkpoints << " checkpoints, " << Use.Bytes << " bytes of "
       << Use.Budget << " (--checkpoint-memory)\n";
  return llvm::Error::success();
}

static llvm::Error infoCycle(Shell &S, CommandArguments) {
  printTiming(S);
  return llvm::Error::success();
}

static llvm::Error infoChip(Shell &S, CommandArguments) {
  printChip(S);
  return llvm::Error::success();
}

static llvm::Error infoDisplay(Shell &S, CommandArguments) {
  if (S.Displays.empty())
    S.OS << "There are no auto-display expressions now.\n";
  for (const Display &Shown : S.Displays)
    S.OS << Shown.Number << ":  " << (Shown.Enabled ? 'y' : 'n') << "  "
         << (Shown.Format.empty() ? "" : "/" + Shown.Format + " ") << Shown.Text
         << '\n';
  return llvm::Error::success();
}

static llvm::Error infoProgram(Shell &S, CommandArguments) {
  const ChipConfig &Chip = S.Program.chip();
  S.OS << S.Program.options().Run.Program << " on " << Chip.Name << ": "
       << Chip.TmCount << " TMs of " << Chip.TpsPerTm << " TPs, "
       << (S.Program.isFunctional() ? "without" : "with") << " timing; "
       << S.timeName(S.Program.replay().now().Time) << ".\n";
  for (const std::string &Warning : S.info().warnings())
    S.OS << "warning: " << Warning << '\n';
  return llvm::Error::success();
}

static constexpr Command Table[] = {
    {"breakpoints", "b break watchpoints", "",
     "Breakpoints and watchpoints, with how often they were hit.",
     infoBreakpoints},
    {"threads", "", "", "All threads, those at one place in one line.",
     infoThreads},
    {"locals", "", "", "Local variables of the selected frame.", infoLocals},
    {"args", "", "", "Arguments of the selected frame.", infoArguments},
    {"all-variables", "", "",
     "Arguments and local variables of the selected frame.", infoAllVariables},
    {"registers", "r reg", "[REGISTER...]", "Registers of the selected frame.",
     infoRegisters},
    {"frame", "f", "", "All about the selected frame.", infoFrame},
    {"line", "", "[LOCATION]", "The addresses of a line.", infoLine, false,
     CompletionOf::Locations},
    {"symbol", "", "ADDRESS", "The symbol that holds an address.", infoSymbol,
     false, CompletionOf::Expressions},
    {"source", "", "", "The source file of the selected frame.", infoSource},
    {"sources", "", "", "The source files of the program.", infoSources},
    {"functions", "fun", "[TEXT]", "Functions with TEXT in their name.",
     infoFunctions},
    {"variables", "var", "[TEXT]",
     "Global, static and thread_local variables with TEXT in their name.",
     infoVariables},
    {"display", "", "", "Expressions that are printed at each stop.",
     infoDisplay},
    {"cycle", "time", "",
     "The cycle, why the selected thread waits and what is in flight.",
     infoCycle},
    {"chip", "", "", "The threads by what they do in this cycle.", infoChip},
    {"checkpoints", "", "", "What going back in time costs.", infoCheckpoints},
    {"program", "proc", "", "What is being debugged.", infoProgram}};

ArrayRef<Command> infoCommands() { return Table; }

} // namespace tp
