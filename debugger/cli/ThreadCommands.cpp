//===- ThreadCommands.cpp - Commands about threads and time ---------------===//
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

static llvm::Error threadsCommand(Shell &S, CommandArguments) {
  printThreads(S);
  return llvm::Error::success();
}

/// `thread apply all|LIST COMMAND` is one command for several threads.
static llvm::Error applyToThreads(Shell &S, CommandArguments Arguments);

static llvm::Error threadCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty()) {
    S.OS << "[Current thread is " << S.threadName(S.Thread) << "]\n";
    return llvm::Error::success();
  }
  if (Arguments.Text.consume_front("apply "))
    return applyToThreads(S, Arguments);
  Expected<uint32_t> Thread = parseThread(Arguments.Text, S.Program.chip());
  if (!Thread)
    return Thread.takeError();
  S.select(*Thread);
  S.OS << "[Switching to " << S.threadName(*Thread) << "]\n";
  S.printFrame(0);
  S.printSourceLine(S.frame());
  return llvm::Error::success();
}

static llvm::Error applyToThreads(Shell &S, CommandArguments Arguments) {
  std::vector<uint32_t> Threads;
  for (;;) {
    CommandArguments Ahead = Arguments;
    StringRef Word = Ahead.takeWord();
    if (Word == "all") {
      for (uint32_t T = 0; T != S.Program.replay().threadCount(); ++T)
        Threads.push_back(T);
    } else if (!Word.empty() && isDigit(Word.front())) {
      auto [First, Last] = Word.split('-');
      Expected<uint32_t> Begin = parseThread(First, S.Program.chip());
      if (!Begin)
        return Begin.takeError();
      Expected<uint32_t> End =
          Last.empty() ? *Begin : parseThread(Last, S.Program.chip());
      if (!End)
        return End.takeError();
      for (uint32_t T = *Begin; T <= *End; ++T)
        Threads.push_back(T);
    } else {
      break;
    }
    Arguments = Ahead;
  }
  StringRef Word = Arguments.takeWord();
  StringRef Name;
  std::tie(Name, Arguments.Format) = Word.split('/');
  if (Threads.empty() || Word.empty())
    return createStringError("thread apply needs threads and a command.");
  Expected<const Command *> Found = findCommand(allCommands(), Name, "");
  if (!Found)
    return Found.takeError();
  uint32_t Selected = S.Thread;
  unsigned Frame = S.FrameIndex;
  llvm::Error Problem = llvm::Error::success();
  for (uint32_t T : Threads) {
    S.select(T);
    S.OS << "\nThread " << T << " (" << threadPlace(T, S.Program.chip())
         << "):\n";
    if (llvm::Error E = (*Found)->Run(S, Arguments)) {
      Problem = std::move(E);
      break;
    }
  }
  S.select(Selected, Frame);
  return Problem;
}

static llvm::Error cycleCommand(Shell &S, CommandArguments) {
  printTiming(S);
  return llvm::Error::success();
}

/// Bytes of a written place as the thread that wrote sees them.
static std::string bytesAt(Shell &S, uint32_t Thread, uint32_t Address,
                           uint32_t Bytes) {
  std::vector<uint8_t> Held(Bytes);
  if (!S.Program.machine(Thread).Read(Address, Held))
    return "?";
  std::string Text;
  for (uint32_t I = 0; I < Bytes; I += 4)
    Text += (I ? " " : "") +
            formatNumber(ArrayRef(Held).slice(I, std::min(4u, Bytes - I)), 'x',
                         S.map());
  return Text;
}

static void printWrite(Shell &S, const WriteRecord &Write, uint32_t Address,
                       uint32_t Bytes) {
  uint32_t Selected = S.Thread;
  unsigned Frame = S.FrameIndex;
  S.Program.replay().visit(Write.At, [&] {
    S.select(Write.Thread);
    S.changed();
    S.OS << "written by " << S.threadName(Write.Thread) << " in "
         << S.timeName(Write.At.Time);
    Moment Here = S.Program.replay().now();
    constexpr uint32_t MostBytes = 32;
    uint32_t Shown = std::min(Bytes, MostBytes);
    std::string Old = bytesAt(S, Write.Thread, Address, Shown);
    S.Program.replay().goTo({Write.At.Time + 1, 0});
    S.OS << ": " << Old << " -> " << bytesAt(S, Write.Thread, Address, Shown)
         << '\n';
    S.Program.replay().goTo(Here);
    S.changed();
    if (llvm::Error E = S.printInstruction(Write.Pc))
      S.OS << toString(std::move(E)) << '\n';
    S.printSourceLine(S.frame());
    printStack(S, 20, false);
  });
  S.changed();
  S.select(Selected, Frame);
}

static llvm::Error whoWroteCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty())
    return createStringError(
        "Argument required (an expression or an address).");
  StringRef Text = Arguments.Text;
  std::optional<uint64_t> Before;
  if (size_t At = Text.rfind(" before "); At != StringRef::npos) {
    Expected<uint64_t> Time = S.evaluateInteger(Text.substr(At + 8).trim());
    if (!Time)
      return Time.takeError();
    Before = *Time;
    Text = Text.take_front(At).trim();
  }
  Expected<Value> Named = S.evaluate(Text);
  if (!Named)
    return Named.takeError();
  uint32_t Address, Bytes = 4;
  std::optional<uint32_t> Place = Named->address();
  if (Place && Named->type().Size != 0) {
    Address = *Place;
    Bytes = Named->type().Size;
  } else if (Named->registerNumber() || Named->isOptimizedOut()) {
    return createStringError("'" + Text + "' is not in memory here.");
  } else {
    Expected<uint32_t> Number = S.evaluateAddress(Text);
    if (!Number)
      return Number.takeError();
    Address = *Number;
  }
  uint8_t First;
  if (!S.context().read(Address, First))
    return cannotAccess(Address);
  LastWrite Write = AsLoaded();
  auto Ask = [&] { Write = S.Program.lastWrite(S.Thread, Address, Bytes); };
  if (Before)
    S.Program.replay().visit({*Before, 0}, Ask);
  else
    Ask();
  if (std::holds_alternative<SearchInterrupted>(Write))
    return createStringError("Interrupted before the write was found.");
  S.OS << format_hex(Address, 10) << ", " << Bytes << " bytes: ";
  if (std::holds_alternative<AsLoaded>(Write))
    S.OS << "as the program was loaded; nobody wrote\n";
  else if (auto *User = std::get_if<WrittenByUser>(&Write))
    S.OS << "written by you in " << S.timeName(User->At.Time) << '\n';
  else
    printWrite(S, std::get<WriteRecord>(Write), Address, Bytes);
  return llvm::Error::success();
}

static constexpr Command Table[] = {
    {"thread", "t", "[N | TM.TP | apply all|N... COMMAND]",
     "Select a thread, by its number or its place in the chip.", threadCommand},
    {"threads", "", "", "Print all threads, those at one place in one line.",
     threadsCommand},
    {"cycle", "stall", "",
     "Print the cycle, why the selected thread waits and what is in flight.",
     cycleCommand},
    {"who-wrote", "ww", "EXPRESSION|ADDRESS [before CYCLE]",
     "Print who wrote last to an object: thread, cycle, line and stack.",
     whoWroteCommand, false, CompletionOf::Expressions}};

ArrayRef<Command> threadCommands() { return Table; }

} // namespace tp
