//===- LldbWords.cpp - lldb's commands in gdb's words ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/LldbWords.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringSwitch.h"

#include <optional>

using namespace llvm;

namespace tp {

namespace {

struct Phrase {
  StringRef Lldb;
  StringRef Gdb;
};

/// What stands behind is kept. Longer ones first.
constexpr Phrase Phrases[] = {{"breakpoint list", "info breakpoints"},
                              {"breakpoint delete", "delete"},
                              {"breakpoint enable", "enable"},
                              {"breakpoint disable", "disable"},
                              {"breakpoint command add", "commands"},
                              {"watchpoint list", "info watchpoints"},
                              {"watchpoint delete", "delete"},
                              {"watchpoint enable", "enable"},
                              {"watchpoint disable", "disable"},
                              {"watchpoint set variable", "watch"},
                              {"watchpoint set expression --", "watch -l *"},
                              {"process launch", "run"},
                              {"process continue", "continue"},
                              {"process kill", "kill"},
                              {"process status", "info program"},
                              {"thread backtrace all", "thread apply all bt"},
                              {"thread backtrace", "bt"},
                              {"thread continue", "continue"},
                              {"thread step-inst-over", "nexti"},
                              {"thread step-inst", "stepi"},
                              {"thread step-in", "step"},
                              {"thread step-over", "next"},
                              {"thread step-out", "finish"},
                              {"thread until", "until"},
                              {"thread list", "threads"},
                              {"thread select", "thread"},
                              {"thread info", "cycle"},
                              {"frame select", "frame"},
                              {"frame info", "frame"},
                              {"register read", "info registers"},
                              {"register write", "set register"},
                              {"target variable", "print"},
                              {"image lookup --address", "info symbol"},
                              {"image lookup -a", "info symbol"},
                              {"image lookup --name", "info functions"},
                              {"image lookup -n", "info functions"},
                              {"image lookup --type", "ptype"},
                              {"image lookup -t", "ptype"},
                              {"command source", "source"},
                              {"expression --", "print"},
                              {"expression", "print"},
                              {"expr", "print"},
                              {"po", "print"},
                              {"disassemble --frame", "disassemble"},
                              {"disassemble -f", "disassemble"},
                              {"disassemble --name", "disassemble"},
                              {"disassemble -n", "disassemble"},
                              {"disassemble --pc", "x/10i $pc"}};

} // namespace

/// Takes `-x VALUE` or `--xxx VALUE` from \p Text, where \p Names has both.
static std::optional<std::string> takeOption(std::string &Text,
                                             ArrayRef<StringRef> Names) {
  for (StringRef Name : Names) {
    size_t At = StringRef(Text).find((Name + " ").str());
    if (At == StringRef::npos || (At != 0 && Text[At - 1] != ' '))
      continue;
    StringRef Value = StringRef(Text).substr(At + Name.size() + 1).ltrim();
    StringRef Taken = Value.take_until(isSpace);
    size_t End = Value.data() + Taken.size() - Text.data();
    if (Value.starts_with("\"") || Value.starts_with("'")) {
      size_t Close = Value.find(Value.front(), 1);
      Taken = Value.slice(1, Close);
      End = Value.data() - Text.data() +
            std::min(Close == StringRef::npos ? Value.size() : Close + 1,
                     Value.size());
    }
    std::string Result = Taken.str();
    Text = Text.substr(0, At) + Text.substr(End);
    return Result;
  }
  return std::nullopt;
}

static llvm::Error checkNothingLeft(StringRef Text, StringRef Of) {
  if (Text.trim().empty())
    return llvm::Error::success();
  return createStringError("unknown option of " + Of + ": " + Text.trim());
}

static Expected<std::string> breakpointSet(StringRef Line) {
  std::string Text = Line.str();
  std::optional<std::string> Condition =
      takeOption(Text, {"-c", "--condition"});
  std::optional<std::string> Name = takeOption(Text, {"-n", "--name"});
  std::optional<std::string> File = takeOption(Text, {"-f", "--file"});
  std::optional<std::string> Number = takeOption(Text, {"-l", "--line"});
  std::optional<std::string> Address = takeOption(Text, {"-a", "--address"});
  std::optional<std::string> Thread = takeOption(Text, {"-t", "--thread-id"});
  bool IsOnce =
      StringRef(Text).trim() == "-o" || StringRef(Text).trim() == "--one-shot";
  if (!IsOnce)
    if (llvm::Error E = checkNothingLeft(Text, "breakpoint set"))
      return std::move(E);
  std::string Result = IsOnce ? "tbreak " : "break ";
  if (Name)
    Result += (File ? *File + ":" : std::string()) + *Name;
  else if (Number)
    Result += (File ? *File + ":" : std::string()) + *Number;
  else if (Address)
    Result += "*" + *Address;
  else
    return createStringError("breakpoint set needs --name, --line or "
                             "--address");
  if (Thread)
    Result += " thread " + *Thread;
  if (Condition)
    Result += " if " + *Condition;
  return Result;
}

static Expected<std::string> memoryRead(StringRef Line) {
  std::string Text = Line.str();
  std::string Count = takeOption(Text, {"-c", "--count"}).value_or("8");
  std::string Size = takeOption(Text, {"-s", "--size"}).value_or("4");
  std::string Format = takeOption(Text, {"-f", "--format"}).value_or("x");
  StringRef Unit = StringSwitch<StringRef>(Size)
                       .Case("1", "b")
                       .Case("2", "h")
                       .Case("4", "w")
                       .Case("8", "g")
                       .Default("");
  if (Unit.empty())
    return createStringError("memory read --size is 1, 2, 4 or 8");
  StringRef Letter = StringSwitch<StringRef>(Format)
                         .Case("hex", "x")
                         .Case("binary", "t")
                         .Case("pointer", "a")
                         .Case("c-string", "s")
                         .Default(StringRef(Format).take_front());
  return ("x/" + Count + Letter + Unit + " " + StringRef(Text).trim()).str();
}

Expected<std::string> fromLldb(StringRef Line) {
  StringRef Text = Line.trim();
  if (Text.consume_front("breakpoint set "))
    return breakpointSet(Text);
  if (Text.consume_front("memory read "))
    return memoryRead(Text);
  if (Text == "frame variable")
    return std::string("info all-variables");
  if (Text.consume_front("frame variable "))
    return ("print " + Text).str();
  for (const Phrase &P : Phrases)
    if (Text.starts_with(P.Lldb) &&
        (Text.size() == P.Lldb.size() || Text[P.Lldb.size()] == ' '))
      return (P.Gdb + Text.substr(P.Lldb.size())).str();
  return Text.str();
}

} // namespace tp
