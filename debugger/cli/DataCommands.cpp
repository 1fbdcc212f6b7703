//===- DataCommands.cpp - Commands about data -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Command.h"
#include "debugger/cli/Views.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

/// The place in Shell::Displays of the one that \p Text numbers.
static Expected<std::vector<Display>::iterator> findDisplay(Shell &S,
                                                            StringRef Text) {
  Expected<uint64_t> Number = parseCount(Text, 0);
  if (!Number)
    return Number.takeError();
  auto Found = find_if(S.Displays,
                       [&](const Display &D) { return D.Number == *Number; });
  if (Found == S.Displays.end())
    return createStringError("Could not find display number " + Twine(*Number) +
                             ".");
  return Found;
}

llvm::Error undisplay(Shell &S, StringRef Number) {
  if (Number.empty()) {
    S.Displays.clear();
    return llvm::Error::success();
  }
  auto Found = findDisplay(S, Number);
  if (!Found)
    return Found.takeError();
  S.Displays.erase(*Found);
  return llvm::Error::success();
}

llvm::Error enableDisplays(Shell &S, StringRef Number, bool IsEnabled) {
  if (Number.empty()) {
    for (Display &D : S.Displays)
      D.Enabled = IsEnabled;
    return llvm::Error::success();
  }
  auto Found = findDisplay(S, Number);
  if (!Found)
    return Found.takeError();
  (*Found)->Enabled = IsEnabled;
  return llvm::Error::success();
}

static Expected<char> printFormat(StringRef Letters) {
  Expected<FormatLetters> Format = parseFormat(Letters);
  if (!Format)
    return Format.takeError();
  if (Format->Count != 1 || Format->Unit != 0)
    return createStringError(
        "Size letters are meaningless in \"print\" command.");
  if (Format->Format == 'i')
    return createStringError(
        "Format letter \"i\" is meaningless in \"print\" command.");
  return Format->Format;
}

static llvm::Error printCommand(Shell &S, CommandArguments Arguments) {
  Expected<char> Format = printFormat(Arguments.Format);
  if (!Format)
    return Format.takeError();
  StringRef Text = Arguments.isEmpty() ? StringRef("$") : Arguments.Text;
  Expected<Value> Result = S.evaluate(Text);
  if (!Result)
    return Result.takeError();
  if (Result->type().stripped().Kind == TypeKind::Void) {
    S.OS << "void\n";
    return llvm::Error::success();
  }
  std::string Shown = S.print(*Result, *Format);
  if (!Result->isOptimizedOut()) {
    Expected<Value> Kept = Result->snapshot(S.context());
    if (!Kept)
      return Kept.takeError();
    S.OS << '$' << S.Program.history().add(std::move(*Kept)) << " = ";
  }
  S.OS << Shown << '\n';
  return llvm::Error::success();
}

static llvm::Error outputCommand(Shell &S, CommandArguments Arguments) {
  Expected<char> Format = printFormat(Arguments.Format);
  if (!Format)
    return Format.takeError();
  Expected<Value> Result = S.evaluate(Arguments.Text);
  if (!Result)
    return Result.takeError();
  S.OS << S.print(*Result, *Format);
  return llvm::Error::success();
}

static llvm::Error echoCommand(Shell &S, CommandArguments Arguments) {
  for (size_t I = 0; I != Arguments.Text.size(); ++I) {
    char C = Arguments.Text[I];
    if (C == '\\' && I + 1 != Arguments.Text.size()) {
      C = Arguments.Text[++I];
      C = C == 'n' ? '\n' : C == 't' ? '\t' : C;
    }
    S.OS << C;
  }
  return llvm::Error::success();
}

/// The expression or the type that \p Text names.
static Expected<const Type *> typeOf(Shell &S, StringRef Text,
                                     bool &IsTypeName) {
  Expected<Expression> Parsed = Expression::parse(Text, S.info(), &S.context());
  if (!Parsed)
    return Parsed.takeError();
  if (const Type *Named = Parsed->namedType()) {
    IsTypeName = true;
    return Named;
  }
  if (Parsed->hasEffects())
    return createStringError("The type of an assignment is that of its left "
                             "side.");
  Expected<Value> Result = Parsed->evaluate(S.context(), &S.Program.history());
  if (!Result)
    return Result.takeError();
  return &Result->type();
}

static llvm::Error whatisCommand(Shell &S, CommandArguments Arguments) {
  bool IsTypeName = false;
  Expected<const Type *> Of = typeOf(S, Arguments.Text, IsTypeName);
  if (!Of)
    return Of.takeError();
  S.OS << "type = " << (*Of)->Name << '\n';
  return llvm::Error::success();
}

static llvm::Error ptypeCommand(Shell &S, CommandArguments Arguments) {
  bool IsTypeName = false;
  Expected<const Type *> Of = typeOf(S, Arguments.Text, IsTypeName);
  if (!Of)
    return Of.takeError();
  S.OS << "type = " << describeType(**Of) << '\n';
  return llvm::Error::success();
}

static llvm::Error displayCommand(Shell &S, CommandArguments Arguments) {
  if (Arguments.isEmpty()) {
    S.printDisplays();
    return llvm::Error::success();
  }
  if (Expected<FormatLetters> Format = parseFormat(Arguments.Format); !Format)
    return Format.takeError();
  Expected<Expression> Parsed =
      Expression::parse(Arguments.Text, S.info(), &S.context());
  if (!Parsed)
    return Parsed.takeError();
  S.Displays.push_back(
      {++S.LastDisplay, Arguments.Text.str(), Arguments.Format.str()});
  S.printDisplay(S.Displays.back());
  return llvm::Error::success();
}

static llvm::Error undisplayCommand(Shell &S, CommandArguments Arguments) {
  return undisplay(S, Arguments.Text);
}

static llvm::Error examineCommand(Shell &S, CommandArguments Arguments) {
  return examine(S, Arguments.Format, Arguments.Text);
}

static constexpr Command Table[] = {
    {"print", "p inspect call", "[/FORMAT] [EXPRESSION]",
     "Print the value of a C++ expression and keep it as $1, $2, ...\n"
     "FORMAT is one of x d u o t a c f s z.",
     printCommand, false, CompletionOf::Expressions},
    {"output", "", "[/FORMAT] EXPRESSION",
     "Print a value without number and line end.", outputCommand, false,
     CompletionOf::Expressions},
    {"echo", "", "TEXT", "Print text; \\n is a line end.", echoCommand},
    {"whatis", "", "EXPRESSION", "Print the type of an expression.",
     whatisCommand, false, CompletionOf::Expressions},
    {"ptype", "pt", "EXPRESSION|TYPE", "Print the definition of a type.",
     ptypeCommand, false, CompletionOf::Expressions},
    {"display", "", "[/FORMAT] [EXPRESSION]",
     "Print an expression at each stop from now on.", displayCommand, false,
     CompletionOf::Expressions},
    {"undisplay", "", "[NUMBER]", "End a display, or all.", undisplayCommand},
    {"x", "", "[/COUNT FORMAT UNIT] [ADDRESS]",
     "Print memory. FORMAT is one of x d u o t a c f s i, UNIT one of b h w "
     "g.\n"
     "Without ADDRESS from where the last one ended.",
     examineCommand, true, CompletionOf::Expressions}};

ArrayRef<Command> dataCommands() { return Table; }

} // namespace tp
