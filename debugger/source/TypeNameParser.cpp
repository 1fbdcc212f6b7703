//===- TypeNameParser.cpp - Names of types in expressions ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/DebugInformation.h"
#include "debugger/source/ExpressionParser.h"
#include "debugger/source/NameIndex.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

/// `unsigned`, `long long`, `char`: any order, as C++ has it.
const Type *ExpressionParser::builtin() {
  bool IsSigned = false, IsUnsigned = false, IsShort = false;
  unsigned Longs = 0;
  StringRef Base;
  size_t Begin = At;
  for (;; ++At) {
    const Token &Word = peek();
    static constexpr StringLiteral kBases[] = {
        "void",     "bool",     "char", "wchar_t", "char8_t",
        "char16_t", "char32_t", "int",  "float",   "double"};
    if (Word.isWord("signed") || Word.isWord("__signed__"))
      IsSigned = true;
    else if (Word.isWord("unsigned"))
      IsUnsigned = true;
    else if (Word.isWord("short"))
      IsShort = true;
    else if (Word.isWord("long"))
      ++Longs;
    else if (Word.Kind == TokenKind::Identifier && Base.empty() &&
             is_contained(kBases, Word.Text))
      Base = Word.Text;
    else if (!Word.isWord("const") && !Word.isWord("volatile"))
      break;
  }
  bool HasModifier = IsSigned || IsUnsigned || IsShort || Longs;
  if (Base.empty() && !HasModifier) {
    At = Begin;
    return nullptr;
  }
  TypeTable &Types = Information.types();
  if (Base == "char" && IsSigned)
    return &Types.basic("signed char");
  if (Base == "char" && IsUnsigned)
    return &Types.basic("unsigned char");
  if (!Base.empty() && Base != "int")
    return &Types.basic(Base);
  std::string Name = IsUnsigned ? "unsigned " : "";
  Name += IsShort ? "short" : Longs >= 2 ? "long long" : Longs ? "long" : "int";
  return &Types.basic(Name);
}

/// Takes `<...>` if \p Name with it is a name of the program.
void ExpressionParser::templateArguments(std::string &Name) {
  if (!peek().is("<"))
    return;
  size_t Ahead = 0;
  int Open = 0;
  std::string Arguments;
  do {
    const Token &Word = peek(Ahead++);
    if (Word.Kind == TokenKind::End)
      return;
    Open += Word.is("<");
    Open -= Word.is(">") ? 1 : Word.is(">>") ? 2 : 0;
    bool NeedsSpace = !Arguments.empty() && isAlnum(Arguments.back()) &&
                      !Word.Text.empty() && isAlnum(Word.Text.front());
    Arguments += (NeedsSpace ? " " : "") + Word.Text.str();
  } while (Open > 0);
  if (Open < 0)
    return;
  std::string Whole = Name + Arguments;
  bool IsName = Information.types().find(Whole) != nullptr ||
                !Information.map().findFunctions(Whole).empty() ||
                peek(Ahead).is("::");
  if (!IsName)
    return;
  At += Ahead;
  Name = std::move(Whole);
}

std::string ExpressionParser::qualifiedName() {
  std::string Name;
  if (accept("::"))
    Name = "::";
  while (peek().Kind == TokenKind::Identifier) {
    Name += Tokens[At++].Text;
    templateArguments(Name);
    if (!peek().is("::") || peek(1).Kind != TokenKind::Identifier)
      break;
    ++At;
    Name += "::";
  }
  return Name;
}

bool ExpressionParser::isVariable(StringRef Name) const {
  if (!Scope)
    return false;
  return Information.variables().findLocal(*Scope, Name).has_value();
}

const Type *ExpressionParser::namedType() {
  size_t Begin = At;
  bool IsElaborated = false;
  for (StringRef Word : {"struct", "class", "union", "enum", "typename"})
    if (peek().isWord(Word)) {
      ++At;
      IsElaborated = true;
      break;
    }
  std::string Name = qualifiedName();
  DWARFDie Place;
  if (Scope) {
    std::vector<InlinedCall> Calls =
        Information.map().callsAt(Scope->lookupPc());
    if (!Calls.empty())
      Place =
          Information.map()
              .function(
                  Calls[std::min<size_t>(Scope->InlineDepth, Calls.size() - 1)]
                      .Function)
              .Die;
  }
  const Type *Found = nullptr;
  StringRef Plain = Name;
  Plain.consume_front("::");
  if (!Plain.empty() && (IsElaborated || !isVariable(Plain)))
    Found = Information.types().find(Name, Place);
  // A variable of this name is more likely meant.
  if (Found && !IsElaborated && Scope &&
      Information.variables().findGlobal(*Scope, Name) && !peek().is("*") &&
      !peek().is(")") && !peek().is("&"))
    Found = nullptr;
  if (!Found)
    At = Begin;
  return Found;
}

Expected<const Type *> ExpressionParser::typeName() {
  size_t Begin = At;
  bool IsConst = false, IsVolatile = false;
  auto Qualifiers = [&] {
    while (peek().isWord("const") || peek().isWord("volatile")) {
      (peek().isWord("const") ? IsConst : IsVolatile) = true;
      ++At;
    }
  };
  Qualifiers();
  const Type *Base = nullptr;
  if (peek().Kind == TokenKind::Identifier || peek().is("::")) {
    Base = builtin();
    if (!Base)
      Base = namedType();
  }
  if (!Base) {
    At = Begin;
    return nullptr;
  }
  Qualifiers();
  if (IsConst)
    Base = &Information.types().qualified(TypeKind::Const, *Base);
  if (IsVolatile)
    Base = &Information.types().qualified(TypeKind::Volatile, *Base);
  return declarator(*Base);
}

/// `*`, `&` and `const` behind a type.
const Type *ExpressionParser::pointers(const Type &Base) {
  TypeTable &Types = Information.types();
  const Type *Result = &Base;
  while (true) {
    if (accept("*"))
      Result = &Types.pointerTo(*Result);
    else if (accept("&") || accept("&&"))
      Result = &Types.referenceTo(*Result);
    else if (peek().isWord("const") || peek().isWord("volatile"))
      Result = &Types.qualified(
          Tokens[At++].isWord("const") ? TypeKind::Const : TypeKind::Volatile,
          *Result);
    else if (peek().isWord("__restrict"))
      ++At;
    else
      return Result;
  }
}

/// Takes the `(*)` of a pointer to an array or function: how many stars.
unsigned ExpressionParser::innerStars() {
  if (!peek().is("("))
    return 0;
  size_t Ahead = 1;
  while (peek(Ahead).is("*"))
    ++Ahead;
  bool IsDeclarator = Ahead != 1 && peek(Ahead).is(")") &&
                      (peek(Ahead + 1).is("[") || peek(Ahead + 1).is("("));
  if (!IsDeclarator)
    return 0;
  At += Ahead + 1;
  return unsigned(Ahead - 1);
}

const Type *ExpressionParser::arrays(const Type &Element) {
  std::vector<uint32_t> Counts;
  while (peek().is("[") && peek(1).Kind == TokenKind::Integer &&
         peek(2).is("]")) {
    Counts.push_back(uint32_t(peek(1).Number));
    At += 3;
  }
  const Type *Result = &Element;
  for (uint32_t Count : reverse(Counts))
    Result = &Information.types().arrayOf(*Result, Count);
  return Result;
}

/// `(int, float)` behind the result's type.
Expected<const Type *> ExpressionParser::function(const Type &Result) {
  if (Error Problem = expect("("))
    return std::move(Problem);
  std::string Parameters;
  while (!accept(")")) {
    if (!Parameters.empty()) {
      if (Error Problem = expect(","))
        return std::move(Problem);
      Parameters += ", ";
    }
    Expected<const Type *> Parameter = typeName();
    if (!Parameter)
      return Parameter;
    if (!*Parameter)
      return unexpected();
    Parameters += (*Parameter)->Name;
  }
  if (Parameters == "void")
    Parameters.clear();
  return &Information.types().function(Result, "(" + Parameters + ")");
}

/// `*`, `&`, `[3]`, `(*)[3]`, `(*)(int)`.
Expected<const Type *> ExpressionParser::declarator(const Type &Base) {
  const Type *Result = pointers(Base);
  unsigned Stars = innerStars();
  if (Stars != 0 && peek().is("(")) {
    Expected<const Type *> Function = function(*Result);
    if (!Function)
      return Function;
    Result = *Function;
  } else {
    Result = arrays(*Result);
  }
  for (unsigned I = 0; I != Stars; ++I)
    Result = &Information.types().pointerTo(*Result);
  return Result;
}

} // namespace tp
