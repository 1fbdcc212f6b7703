//===- StopReport.cpp - How the program stopped, in words -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Shell.h"
#include "simulator/tools/TrapMessage.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

std::string Shell::describeBytes(ArrayRef<uint8_t> Bytes, const Type *Of) {
  if (Of && Of->Size == Bytes.size())
    return print(Value::computed(*Of, Bytes));
  std::string Text;
  for (size_t I = 0; I < Bytes.size(); I += 4)
    Text += (I ? " " : "") +
            formatNumber(Bytes.slice(I, std::min<size_t>(4, Bytes.size() - I)),
                         'x', map());
  return Text;
}

/// `Breakpoint 2, ` or, if there are several threads, with the thread.
static std::string who(const Shell &S, uint32_t Thread, const Twine &What) {
  if (S.Program.chip().threadCount() == 1)
    return What.str();
  std::string Name = S.threadName(Thread);
  return "T" + Name.substr(1) + " hit " + What.str();
}

void Shell::reportBreakpoint(const SessionStop &Stop, StringRef Kind) {
  OS << '\n'
     << who(*this, Stop.Thread,
            (is_contained(Stop.Deleted, Stop.Numbers.front()) ? "Temporary "
                                                              : "") +
                Kind + " " + Twine(Stop.Numbers.front()) + ", ");
  printPlace(true);
}

void Shell::reportWatchpoint(const SessionStop &Stop) {
  const Breakpoint *Watch = Program.breakpoints().find(Stop.Numbers.front());
  OS << '\n'
     << who(*this, Stop.Thread,
            Twine(Stop.IsWrite ? "Watchpoint " : "Read watchpoint ") +
                Twine(Stop.Numbers.front()) + ": " +
                (Watch ? Watch->Text : std::string()))
     << "\n\n";
  if (Stop.IsWrite)
    OS << "Old value = " << describeBytes(Stop.Old, Stop.WatchedType)
       << "\nNew value = " << describeBytes(Stop.New, Stop.WatchedType) << '\n';
  else
    OS << "Value = " << describeBytes(Stop.Old, Stop.WatchedType) << '\n';
  OS << "by " << map().describeAddress(Stop.AccessPc);
  if (const LineRange *Line = map().lineAt(Stop.AccessPc);
      Line && Line->Position.isKnown())
    OS << " at " << info().files().shortName(Line->Position);
  OS << " in " << timeName(Program.replay().now().Time) << '\n';
  printPlace(true);
}

void Shell::reportTrap(const SessionStop &Stop) {
  if (!Stop.TrapInfo) {
    OS << "The program trapped.\n";
    return;
  }
  ReplayThread State = Program.replay().thread(Stop.Thread);
  OS << '\n'
     << trapMessage(
            *Stop.TrapInfo,
            Program.isFunctional() ? TrapClock::Instructions
                                   : TrapClock::Cycles,
            Program.chip(), Program.program(), Symbols,
            [&](unsigned Register) { return State.Registers[Register]; })
     << '\n';
  printPlace(true);
}

void Shell::report(const SessionStop &Stop) {
  changed();
  Result.Stop = Stop;
  bool IsSwitch = Stop.Thread != Thread;
  if (!Stop.Commands.empty() && Stop.Commands.front() == "silent") {
    select(Stop.Thread, Stop.Frame);
    return;
  }
  select(Thread);
  switch (Stop.Kind) {
  case SessionStop::Exited:
    if (Stop.ExitStatus == 0)
      OS << "[All threads have halted in "
         << timeName(Program.replay().now().Time) << ": exited normally]\n";
    else
      OS << "[All threads have halted in "
         << timeName(Program.replay().now().Time) << ": exited with status "
         << Stop.ExitStatus << "]\n";
    return;
  case SessionStop::Beginning:
    OS << "\nNo more reverse-execution history: this is the beginning.\n";
    printPlace(true);
    printDisplays();
    return;
  case SessionStop::CycleLimit:
    OS << "\nThe limit of --max-cycles is reached: "
       << timeName(Program.replay().now().Time) << ".\n";
    printPlace(true);
    return;
  case SessionStop::Interrupted:
    OS << "\nInterrupted in " << timeName(Program.replay().now().Time) << ".\n";
    printPlace(true);
    printDisplays();
    return;
  default:
    break;
  }
  select(Stop.Thread, Stop.Frame);
  if (IsSwitch && Stop.Kind == SessionStop::Step)
    OS << "[Switching to " << threadName(Thread) << "]\n";
  switch (Stop.Kind) {
  case SessionStop::Breakpoint:
    reportBreakpoint(Stop, "Breakpoint");
    break;
  case SessionStop::ConditionFailed:
    OS << "Error in testing condition of breakpoint " << Stop.Numbers.front()
       << ":\n"
       << Stop.Message << '\n';
    reportBreakpoint(Stop, "Breakpoint");
    break;
  case SessionStop::Watchpoint:
    reportWatchpoint(Stop);
    break;
  case SessionStop::ScopeEnded:
    for (unsigned Number : Stop.Numbers)
      if (is_contained(Stop.Deleted, Number))
        OS << "\nWatchpoint " << Number
           << " deleted because the program has left the block in\nwhich its "
              "expression is valid.\n";
    printPlace(true);
    break;
  case SessionStop::Trapped:
    reportTrap(Stop);
    break;
  default:
    printPlace(IsSwitch);
  }
  if (Stop.Returned) {
    std::string Text = print(*Stop.Returned);
    OS << "Value returned is $" << Program.history().add(*Stop.Returned)
       << " = " << Text << '\n';
  }
  printDisplays();
}

} // namespace tp
