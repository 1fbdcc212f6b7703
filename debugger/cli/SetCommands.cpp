//===- SetCommands.cpp - The commands behind set --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Command.h"
#include "debugger/cli/Shell.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

static llvm::Error setVariable(Shell &S, CommandArguments Arguments) {
  if (!Arguments.Text.contains('='))
    return createStringError("Argument required (VARIABLE = EXPRESSION).");
  Expected<Value> Result = S.evaluate(Arguments.Text);
  return Result ? llvm::Error::success() : Result.takeError();
}

static llvm::Error setRegister(Shell &S, CommandArguments Arguments) {
  Arguments.Text.consume_front("$");
  StringRef Name = Arguments.Text.take_while([](char C) { return isAlnum(C); });
  StringRef Held = Arguments.Text.drop_front(Name.size()).ltrim();
  Held.consume_front("=");
  if (Name.empty() || Held.trim().empty())
    return createStringError("Argument required (REGISTER = EXPRESSION).");
  return setVariable(S, {"", ("$" + Name + " = " + Held).str()});
}

/// `ADDRESS BYTE...`.
static llvm::Error setMemory(Shell &S, CommandArguments Arguments) {
  Expected<uint32_t> Address = S.evaluateAddress(Arguments.takeWord());
  if (!Address)
    return Address.takeError();
  std::vector<uint8_t> Bytes;
  while (!Arguments.isEmpty()) {
    Expected<uint64_t> Byte = S.evaluateInteger(Arguments.takeWord());
    if (!Byte)
      return Byte.takeError();
    if (*Byte > 0xff)
      return createStringError("Not a byte: " + Twine(*Byte) +
                               "; give the bytes one by one");
    Bytes.push_back(uint8_t(*Byte));
  }
  if (Bytes.empty())
    return createStringError("Argument required (ADDRESS BYTE...).");
  if (!S.Program.machine(S.Thread).Write(*Address, Bytes))
    return createStringError("Cannot write to memory at address 0x" +
                             utohexstr(*Address, true, 8));
  S.changed();
  return llvm::Error::success();
}

static llvm::Error setListSize(Shell &S, CommandArguments Arguments) {
  Expected<uint64_t> Size = parseCount(Arguments.Text, 10);
  if (!Size)
    return Size.takeError();
  S.ListSize = std::max(1u, unsigned(std::min<uint64_t>(*Size, 100000)));
  return llvm::Error::success();
}

static llvm::Error setPrint(Shell &S, CommandArguments Arguments) {
  StringRef Name = Arguments.takeWord();
  if (Name == "pretty") {
    if (Arguments.Text != "on" && Arguments.Text != "off" &&
        !Arguments.isEmpty())
      return createStringError("\"on\" or \"off\" expected.");
    S.Printing.Pretty = Arguments.Text != "off";
    return llvm::Error::success();
  }
  Expected<uint64_t> Count = parseCount(Arguments.Text, 0);
  if (!Count)
    return Count.takeError();
  unsigned Limit = *Count == 0 ? unsigned(-1)
                               : unsigned(std::min<uint64_t>(*Count, 1 << 30));
  if (Name == "elements")
    S.Printing.MaxElements = Limit;
  else if (Name == "repeats")
    S.Printing.RepeatThreshold = Limit;
  else if (Name == "max-depth")
    S.Printing.MaxDepth = Limit;
  else
    return createStringError("Undefined set print command: \"" + Name +
                             "\".  There are pretty, elements, repeats and "
                             "max-depth.");
  return llvm::Error::success();
}

static llvm::Error setSubstitution(Shell &S, CommandArguments Arguments) {
  StringRef From = Arguments.takeWord();
  StringRef To = Arguments.takeWord();
  if (From.empty() || To.empty() || !Arguments.isEmpty())
    return createStringError("Two arguments required (FROM TO).");
  S.info().files().substitute(From, To);
  return llvm::Error::success();
}

static constexpr Command Table[] = {
    {"variable", "var", "VARIABLE = EXPRESSION", "Change a variable.",
     setVariable, false, CompletionOf::Expressions},
    {"register", "", "REGISTER = EXPRESSION", "Change a register.",
     setRegister},
    {"memory", "", "ADDRESS BYTE...", "Change bytes of memory.", setMemory},
    {"listsize", "", "LINES", "How many lines list prints.", setListSize},
    {"print", "p", "pretty on|off | elements N | repeats N | max-depth N",
     "How values are printed; 0 is without limit.", setPrint},
    {"substitute-path", "", "FROM TO",
     "Source paths that begin with FROM begin with TO instead.",
     setSubstitution}};

ArrayRef<Command> setCommands() { return Table; }

} // namespace tp
