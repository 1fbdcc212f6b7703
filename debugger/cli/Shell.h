//===- Shell.h - What the commands share ------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_SHELL_H
#define TP_DEBUGGER_CLI_SHELL_H

#include "debugger/cli/CommandLine.h"
#include "debugger/cli/Examine.h"
#include "debugger/session/Session.h"
#include "simulator/loader/Disassembler.h"
#include "simulator/loader/Symbolizer.h"

#include "llvm/Support/raw_ostream.h"

#include <optional>
#include <string>
#include <vector>

namespace tp {

/// An expression that is printed at each stop.
struct Display {
  unsigned Number = 0;
  std::string Text;
  /// As behind the slash of `display/4xw`.
  std::string Format;
  bool Enabled = true;
};

/// The lines behind `commands` as far as they have been read.
struct CommandList {
  /// Whose commands they will be.
  std::vector<unsigned> Breakpoints;
  std::vector<std::string> Lines;
  /// How many lists of further breakpoints are begun in this one.
  unsigned Depth = 0;
};

/// The state of the command line, and the ways to print that several commands
/// use.
class Shell {
public:
  Shell(Session &Program, llvm::raw_ostream &OS);

  Session &Program;
  llvm::raw_ostream &OS;
  /// Of the command that runs.
  CommandResult Result;

  uint32_t Thread = 0;
  unsigned FrameIndex = 0;
  PrintOptions Printing;
  std::vector<Display> Displays;
  unsigned LastDisplay = 0;
  /// Where `list` goes on, and how many lines it shows.
  SourcePosition Listed;
  bool IsListedBehind = false;
  unsigned ListSize = 10;
  /// Where `x` goes on.
  std::optional<uint32_t> Examined;
  FormatLetters LastFormat = {1, 'x', 4};
  Disassembler Instructions;
  /// A file that `source` asks to be executed.
  std::string Sourced;
  /// While the lines behind `commands` are read.
  std::optional<CommandList> Listing;

  DebugInformation &info() { return Program.information(); }
  const SourceMap &map() { return Program.information().map(); }

  /// The stack of the selected thread; kept until changed().
  const Backtrace &stack();
  /// The selected frame.
  const Frame &frame();
  const FrameContext &context() { return frame().Context; }
  /// The program has moved or been changed.
  void changed();
  void select(uint32_t NewThread, unsigned NewFrame = 0);
  LocationDefaults locationDefaults();

  /// Parses and evaluates in the selected frame.
  llvm::Expected<Value> evaluate(llvm::StringRef Text);
  llvm::Expected<uint64_t> evaluateInteger(llvm::StringRef Text);
  /// Likewise; the error says if it is none of the machine's addresses.
  llvm::Expected<uint32_t> evaluateAddress(llvm::StringRef Text);
  std::string print(const Value &Of, char Format = 0);

  /// `thread 17 (TM 2, TP 1)`.
  std::string threadName(uint32_t Number) const;
  /// `cycle 120`, or `instruction 120` without timing.
  std::string timeName(uint64_t Time) const;
  /// `main (argc=1) at main.cpp:3`, with the pc in front if it is not at the
  /// beginning of a line.
  std::string describeFrame(const Frame &Of);
  /// `#0  ...` and a line end.
  void printFrame(unsigned Index);
  /// The line of a frame with its number, and its pc if that is not where the
  /// line begins and has not been printed yet.
  void printSourceLine(const Frame &Of, bool WithAddress = false);
  /// Where the selected thread is, as after a stop.
  void printPlace(bool WithFrame);
  /// The error says that there is no memory.
  llvm::Error printInstruction(uint32_t Pc);
  void printDisplays();
  void printDisplay(const Display &Shown);

  /// Tells how the program stopped, selects the thread, prints displays.
  void report(const SessionStop &Stop);

private:
  std::optional<Backtrace> Stack;
  /// What was printed last, to leave out the frame while a step stays in it.
  struct {
    uint32_t Thread = uint32_t(-1);
    uint32_t Cfa = 0;
    std::optional<uint32_t> Function;
  } Shown;
  Symbolizer Symbols;

  void reportBreakpoint(const SessionStop &Stop, llvm::StringRef Kind);
  void reportWatchpoint(const SessionStop &Stop);
  void reportTrap(const SessionStop &Stop);
  std::string describeBytes(llvm::ArrayRef<uint8_t> Bytes, const Type *Of);
};

} // namespace tp

#endif // TP_DEBUGGER_CLI_SHELL_H
