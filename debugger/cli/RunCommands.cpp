//===- RunCommands.cpp - Commands that let the program run ----------------===//
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

/// Whether the program stopped for what the command did, so that a count goes
/// on.
bool goesOn(const SessionStop &Stop) { return Stop.Kind == SessionStop::Step; }

llvm::Error checkRunning(Shell &S) {
  if (S.Program.replay().thread(S.Thread).State == ThreadState::Halted)
    return createStringError("The selected thread has halted; select another "
                             "(info threads), or go back in time.");
  return llvm::Error::success();
}

llvm::Error resume(Shell &S, CommandArguments Arguments, Direction Towards) {
  Expected<uint64_t> Count = parseCount(Arguments.Text, 1);
  if (!Count)
    return Count.takeError();
  SessionStop Stop;
  for (uint64_t I = 0; I != std::max<uint64_t>(*Count, 1); ++I) {
    Stop = S.Program.resume(Towards);
    if (Stop.Kind != SessionStop::Breakpoint &&
        Stop.Kind != SessionStop::Watchpoint)
      break;
  }
  S.report(Stop);
  return llvm::Error::success();
}

llvm::Error steps(Shell &S, CommandArguments Arguments, StepRequest Step) {
  Expected<uint64_t> Count = parseCount(Arguments.Text, 1);
  if (!Count)
    return Count.takeError();
  if (Step.Towards == Direction::Forward)
    if (llvm::Error E = checkRunning(S))
      return E;
  Step.Thread = S.Thread;
  SessionStop Stop;
  for (uint64_t I = 0; I != *Count; ++I) {
    Stop = S.Program.step(Step);
    if (!goesOn(Stop))
      break;
  }
  if (*Count != 0)
    S.report(Stop);
  return llvm::Error::success();
}

StepRequest makeStep(StepRequest::StepUnit Unit, bool OverCalls,
                     Direction Towards) {
  StepRequest Step;
  Step.Unit = Unit;
  Step.OverCalls = OverCalls;
  Step.Towards = Towards;
  return Step;
}

template <StepRequest::StepUnit Unit, bool OverCalls, Direction Towards>
llvm::Error stepCommand(Shell &S, CommandArguments Arguments) {
  return steps(S, Arguments, makeStep(Unit, OverCalls, Towards));
}

template <Direction Towards>
llvm::Error continueCommand(Shell &S, CommandArguments Arguments) {
  return resume(S, Arguments, Towards);
}

template <Direction Towards>
llvm::Error finishCommand(Shell &S, CommandArguments) {
  if (S.FrameIndex + 1 >= S.stack().Frames.size())
    return createStringError(
        "\"finish\" not meaningful in the outermost frame.");
  S.OS << (Towards == Direction::Forward ? "Run till exit from "
                                         : "Run back to call of ");
  S.printFrame(S.FrameIndex);
  Expected<SessionStop> Stop = S.Program.finish(S.Thread, S.frame(), Towards);
  if (!Stop)
    return Stop.takeError();
  S.report(*Stop);
  return llvm::Error::success();
}

llvm::Error advanceTo(Shell &S, StringRef Text) {
  if (llvm::Error E = checkRunning(S))
    return E;
  Expected<std::vector<CodeLocation>> Found =
      findLocations(Text, S.info(), S.locationDefaults());
  if (!Found)
    return Found.takeError();
  S.report(S.Program.advance(S.Thread, S.frame(), *Found));
  return llvm::Error::success();
}

llvm::Error advanceCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("Argument required (a location).");
  return advanceTo(S, Arguments.Text);
}

llvm::Error untilCommand(Shell &S, CommandArguments Arguments) {
  if (!Arguments.isEmpty())
    return advanceTo(S, Arguments.Text);
  if (llvm::Error E = checkRunning(S))
    return E;
  S.report(S.Program.until(S.Thread));
  return llvm::Error::success();
}

llvm::Error restart(Shell &S) {
  if (S.Program.isStarted())
    if (llvm::Error E = S.Program.restart())
      return E;
  S.changed();
  S.select(0);
  return llvm::Error::success();
}

llvm::Error runCommand(Shell &S, CommandArguments Arguments) {
  if (!Arguments.isEmpty())
    return createStringError("The program's arguments are given when tpdbg is "
                             "started, behind --.");
  if (llvm::Error E = restart(S))
    return E;
  S.OS << "Starting program: " << S.Program.options().Run.Program << '\n';
  S.report(S.Program.resume(Direction::Forward));
  return llvm::Error::success();
}

llvm::Error startCommand(Shell &S, CommandArguments Arguments) {
  Expected<Breakpoint *> Main =
      S.Program.addBreakpoint("main", S.locationDefaults());
  if (!Main)
    return Main.takeError();
  (*Main)->Temporary = true;
  return runCommand(S, Arguments);
}

llvm::Error killCommand(Shell &S, CommandArguments) {
  if (!S.Program.isStarted())
    return createStringError("The program is not being run.");
  if (llvm::Error E = restart(S))
    return E;
  S.OS << "[The program is before its first instruction again]\n";
  return llvm::Error::success();
}

llvm::Error gotoCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError("Argument required (a cycle).");
  Expected<uint64_t> Time = S.evaluateInteger(Arguments.Text);
  if (!Time)
    return Time.takeError();
  SessionStop Stop = S.Program.goTo(*Time);
  if (Stop.Kind == SessionStop::Step)
    Stop.Thread = S.Thread;
  S.report(Stop);
  return llvm::Error::success();
}

constexpr StepRequest::StepUnit Line = StepRequest::Line;
constexpr StepRequest::StepUnit Instruction = StepRequest::Instruction;
constexpr Direction Forward = Direction::Forward;
constexpr Direction Backward = Direction::Backward;

constexpr Command Running[] = {
    {"run", "r", "",
     "Start the program from its beginning.\n"
     "What was changed in memory and registers is as it was loaded.",
     runCommand},
    {"start", "", "", "Start the program and stop at main.", startCommand},
    {"continue", "c fg", "[COUNT]",
     "Run until a breakpoint or watchpoint stops the program.\n"
     "With COUNT until the COUNT-th stop.",
     continueCommand<Forward>, true},
    {"step", "s", "[COUNT]",
     "Run the selected thread to another line, also in a function that it "
     "calls.",
     stepCommand<Line, false, Forward>, true},
    {"next", "n", "[COUNT]",
     "Run the selected thread to another line; calls are done in one go.",
     stepCommand<Line, true, Forward>, true},
    {"stepi", "si", "[COUNT]", "Run one instruction of the selected thread.",
     stepCommand<Instruction, false, Forward>, true},
    {"nexti", "ni", "[COUNT]",
     "Run one instruction of the selected thread; calls are done in one go.",
     stepCommand<Instruction, true, Forward>, true},
    {"finish", "fin", "", "Run until the selected frame has returned.",
     finishCommand<Forward>, true},
    {"until", "u", "[LOCATION]",
     "Like next, but not back to the beginning of a loop.\n"
     "With LOCATION run the thread to there, or until the frame has returned.",
     untilCommand, true, CompletionOf::Locations},
    {"advance", "", "LOCATION",
     "Run the selected thread to a location, or until the frame has returned.",
     advanceCommand, false, CompletionOf::Locations},
    {"goto", "", "CYCLE",
     "Go to the beginning of a cycle, earlier or later.\n"
     "Without timing: before that instruction of the run.",
     gotoCommand},
    {"kill", "k", "", "Put the program before its first instruction.",
     killCommand}};

constexpr Command Reverse[] = {
    {"reverse-continue", "rc", "[COUNT]",
     "Run backwards to the last breakpoint or watchpoint.",
     continueCommand<Backward>, true},
    {"reverse-step", "rs", "[COUNT]",
     "Run the selected thread back to the beginning of a line, also of a "
     "function that it had called.",
     stepCommand<Line, false, Backward>, true},
    {"reverse-next", "rn", "[COUNT]",
     "Run the selected thread back to the beginning of a line; calls are "
     "undone in one go.",
     stepCommand<Line, true, Backward>, true},
    {"reverse-stepi", "rsi", "[COUNT]",
     "Undo one instruction of the selected thread.",
     stepCommand<Instruction, false, Backward>, true},
    {"reverse-nexti", "rni", "[COUNT]",
     "Undo one instruction of the selected thread; calls are undone in one go.",
     stepCommand<Instruction, true, Backward>, true},
    {"reverse-finish", "", "",
     "Run back to where the selected frame's function was called.",
     finishCommand<Backward>, true}};

} // namespace

ArrayRef<Command> runCommands() { return Running; }
ArrayRef<Command> reverseCommands() { return Reverse; }

} // namespace tp
