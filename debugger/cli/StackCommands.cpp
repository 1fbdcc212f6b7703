//===- StackCommands.cpp - Commands about the stack -----------------------===//
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

void printVariables(Shell &S, const std::vector<VariableInfo> &Variables,
                    const FrameContext &Frame, StringRef Indent) {
  for (const VariableInfo &Variable : Variables) {
    S.OS << Indent << Variable.Name << " = ";
    Expected<Value> Held = S.info().variables().value(Variable, Frame);
    if (Held)
      S.OS << S.Program.printer().print(*Held, Frame, S.Printing);
    else
      S.OS << "<error: " << toString(Held.takeError()) << '>';
    S.OS << '\n';
  }
}

void printStack(Shell &S, size_t Limit, bool WithLocals) {
  const std::vector<Frame> &Frames = S.stack().Frames;
  size_t Count = std::min(Limit, Frames.size());
  for (size_t I = 0; I != Count; ++I) {
    S.printFrame(I);
    if (!WithLocals)
      continue;
    std::vector<VariableInfo> Locals =
        S.info().variables().locals(Frames[I].Context);
    printVariables(S, Locals, Frames[I].Context, "        ");
    if (Locals.empty())
      S.OS << "No locals.\n";
  }
  if (Count < Frames.size())
    S.OS << "(More stack frames follow...)\n";
  else if (!S.stack().Problem.empty())
    S.OS << "Backtrace stopped: " << S.stack().Problem << '\n';
}

namespace {

llvm::Error backtraceCommand(Shell &S, CommandArguments Arguments) {
  bool IsFull = false;
  uint64_t Limit = uint64_t(-1);
  while (!Arguments.isEmpty()) {
    StringRef Word = Arguments.takeWord();
    if (Word == "full" || Word == "-full") {
      IsFull = true;
      continue;
    }
    Expected<uint64_t> Count = parseCount(Word, 0);
    if (!Count)
      return Count.takeError();
    Limit = *Count;
  }
  printStack(S, Limit, IsFull);
  return llvm::Error::success();
}

void showFrame(Shell &S) {
  S.printFrame(S.FrameIndex);
  S.printSourceLine(S.frame());
}

llvm::Error selectFrame(Shell &S, uint64_t Index) {
  if (Index >= S.stack().Frames.size())
    return createStringError("No frame at level " + Twine(Index) + ".");
  S.FrameIndex = unsigned(Index);
  showFrame(S);
  return llvm::Error::success();
}

llvm::Error frameCommand(Shell &S, CommandArguments Arguments) {
  Arguments.Text.consume_front("select ");
  Expected<uint64_t> Index = parseCount(Arguments.Text.trim(), S.FrameIndex);
  if (!Index)
    return Index.takeError();
  return selectFrame(S, *Index);
}

llvm::Error upCommand(Shell &S, CommandArguments Arguments) {
  Expected<uint64_t> Count = parseCount(Arguments.Text, 1);
  if (!Count)
    return Count.takeError();
  size_t Last = S.stack().Frames.size() - 1;
  if (S.FrameIndex >= Last)
    return createStringError("Initial frame selected; you can't go up.");
  return selectFrame(S, std::min<uint64_t>(S.FrameIndex + *Count, Last));
}

llvm::Error downCommand(Shell &S, CommandArguments Arguments) {
  Expected<uint64_t> Count = parseCount(Arguments.Text, 1);
  if (!Count)
    return Count.takeError();
  if (S.FrameIndex == 0)
    return createStringError(
        "Bottom (innermost) frame selected; you can't go down.");
  return selectFrame(S,
                     S.FrameIndex - std::min<uint64_t>(S.FrameIndex, *Count));
}

constexpr Command Table[] = {
    {"backtrace", "bt where", "[full] [COUNT]",
     "Print the frames of the selected thread, inlined functions too.\n"
     "full: with their local variables.",
     backtraceCommand},
    {"frame", "f", "[NUMBER]", "Select and print a frame.", frameCommand},
    {"up", "", "[COUNT]", "Select the frame that called this one.", upCommand,
     true},
    {"down", "dow", "[COUNT]", "Select the frame called by this one.",
     downCommand, true}};

} // namespace

ArrayRef<Command> stackCommands() { return Table; }

} // namespace tp
