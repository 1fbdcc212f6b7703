//===- ExpressionLexer.cpp - Words of expressions ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/ExpressionLexer.h"

#include "llvm/ADT/APFloat.h"
#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

Error syntaxError(StringRef Near) {
  if (Near.empty())
    return createStringError("A syntax error at the end of the expression.");
  return createStringError("A syntax error in expression, near `" + Near +
                           "'.");
}

namespace {

class Lexer {
public:
  explicit Lexer(StringRef Text) : Rest(Text) {}

  Error run(std::vector<Token> &Tokens);

private:
  StringRef Rest;

  Expected<Token> next();
  Expected<Token> number();
  Expected<Token> integer(StringRef Text);
  Expected<Token> real(StringRef Text);
  Expected<Token> character();
  Expected<Token> string();
  Expected<uint32_t> escape();
  Token take(TokenKind Kind, size_t Length);
};

} // namespace

static bool isNameStart(char C) { return isAlpha(C) || C == '_'; }
static bool isNamePart(char C) { return isAlnum(C) || C == '_'; }

Token Lexer::take(TokenKind Kind, size_t Length) {
  Token Result;
  Result.Kind = Kind;
  Result.Text = Rest.take_front(Length);
  Rest = Rest.drop_front(Length);
  return Result;
}

Error Lexer::run(std::vector<Token> &Tokens) {
  while (true) {
    Rest = Rest.ltrim();
    if (Rest.empty())
      break;
    Expected<Token> Next = next();
    if (!Next)
      return Next.takeError();
    Tokens.push_back(std::move(*Next));
    // Trees are as deep as their expressions are long.
    constexpr size_t MaxTokens = 2000;
    if (Tokens.size() > MaxTokens)
      return createStringError("The expression is too long.");
  }
  Tokens.emplace_back();
  return Error::success();
}

Expected<Token> Lexer::next() {
  char First = Rest.front();
  if (isNameStart(First))
    return take(TokenKind::Identifier, Rest.take_while(isNamePart).size());
  if (First == '$') {
    size_t Dollars = Rest.take_while([](char C) { return C == '$'; }).size();
    size_t Name = Rest.drop_front(Dollars).take_while(isNamePart).size();
    return take(TokenKind::Dollar, Dollars + Name);
  }
  if (isDigit(First) || (First == '.' && Rest.size() > 1 && isDigit(Rest[1])))
    return number();
  if (First == '\'')
    return character();
  if (First == '"')
    return string();
  static constexpr StringLiteral kPunctuators[] = {
      "<<=", ">>=", "->*", "::", "->", "++", "--", "<<", ">>", "<=", ">=", "==",
      "!=",  "&&",  "||",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "(",
      ")",   "[",   "]",   "{",  "}",  ".",  ",",  "?",  ":",  "+",  "-",  "*",
      "/",   "%",   "&",   "|",  "^",  "~",  "!",  "<",  ">",  "=",  "@"};
  for (StringRef Punctuator : kPunctuators)
    if (Rest.starts_with(Punctuator))
      return take(TokenKind::Punctuator, Punctuator.size());
  return createStringError("Invalid character '" + Rest.take_front(1) +
                           "' in expression.");
}

Expected<Token> Lexer::number() {
  bool IsHex = Rest.starts_with_insensitive("0x");
  size_t Length = 0;
  while (Length < Rest.size()) {
    char C = Rest[Length];
    bool IsSign = (C == '+' || C == '-') && Length > 0 &&
                  (IsHex ? toLower(Rest[Length - 1]) == 'p'
                         : toLower(Rest[Length - 1]) == 'e');
    if (!isNamePart(C) && C != '.' && C != '\'' && !IsSign)
      break;
    ++Length;
  }
  StringRef Text = Rest.take_front(Length);
  bool IsReal = Text.contains('.') || (IsHex ? Text.contains_insensitive("p")
                                             : Text.contains_insensitive("e"));
  Expected<Token> Result = IsReal ? real(Text) : integer(Text);
  if (!Result)
    return Result;
  Rest = Rest.drop_front(Length);
  return Result;
}

static std::string withoutSeparators(StringRef Number) {
  std::string Digits = Number.str();
  erase(Digits, '\'');
  return Digits;
}

Expected<Token> Lexer::real(StringRef Text) {
  Token Result;
  Result.Kind = TokenKind::Real;
  Result.Text = Text;
  Result.TypeName = "double";
  std::string Digits = withoutSeparators(Text);
  bool IsHex = Text.starts_with_insensitive("0x");
  if (toLower(Digits.back()) == 'f' &&
      (!IsHex || Text.contains_insensitive("p"))) {
    Result.TypeName = "float";
    Digits.pop_back();
  }
  APFloat Number(Result.TypeName == "float" ? APFloat::IEEEsingle()
                                            : APFloat::IEEEdouble());
  Expected<APFloat::opStatus> Status =
      Number.convertFromString(Digits, APFloat::rmNearestTiesToEven);
  if (!Status) {
    consumeError(Status.takeError());
    return createStringError("Invalid number \"" + Text + "\".");
  }
  Result.RealNumber = Result.TypeName == "float"
                          ? double(Number.convertToFloat())
                          : Number.convertToDouble();
  return Result;
}

Expected<Token> Lexer::integer(StringRef Text) {
  Token Result;
  Result.Kind = TokenKind::Integer;
  Result.Text = Text;
  std::string Digits = withoutSeparators(Text);
  StringRef Body = Digits;
  bool IsDecimal = !Body.starts_with("0") || Body.size() == 1;
  StringRef Suffix =
      Body.starts_with_insensitive("0x")
          ? Body.take_back(Body.size() - Body.find_last_not_of("uUlL") - 1)
          : Body.drop_front(Body.find_last_of("0123456789") + 1);
  Body = Body.drop_back(Suffix.size());
  std::string Lower = Suffix.lower();
  bool IsUnsigned = StringRef(Lower).contains('u');
  bool IsLongLong = StringRef(Lower).contains("ll");
  static constexpr StringLiteral kSuffixes[] = {"",   "u",  "l",   "ul",
                                                "lu", "ll", "ull", "llu"};
  if (Body.getAsInteger(0, Result.Number) ||
      !is_contained(kSuffixes, StringRef(Lower)))
    return createStringError("Invalid number \"" + Text + "\".");
  bool FitsInt = Result.Number <= INT32_MAX;
  bool FitsUnsigned = Result.Number <= UINT32_MAX;
  if (!IsLongLong && (IsUnsigned || !FitsInt) && FitsUnsigned &&
      (IsUnsigned || !IsDecimal))
    Result.TypeName = "unsigned int";
  else if (!IsLongLong && FitsInt)
    Result.TypeName = "int";
  else if (IsUnsigned || Result.Number > INT64_MAX)
    Result.TypeName = "unsigned long long";
  else
    Result.TypeName = "long long";
  return Result;
}

Expected<uint32_t> Lexer::escape() {
  Rest = Rest.drop_front();
  if (Rest.empty())
    return syntaxError({});
  char Letter = Rest.front();
  if (Letter >= '0' && Letter <= '7') {
    StringRef Digits = Rest.take_front(3).take_while(
        [](char C) { return C >= '0' && C <= '7'; });
    Rest = Rest.drop_front(Digits.size());
    uint32_t Number = 0;
    Digits.getAsInteger(8, Number);
    return Number;
  }
  Rest = Rest.drop_front();
  switch (Letter) {
  case 'n':
    return '\n';
  case 't':
    return '\t';
  case 'r':
    return '\r';
  case 'a':
    return '\a';
  case 'b':
    return '\b';
  case 'f':
    return '\f';
  case 'v':
    return '\v';
  case 'e':
    return 27;
  case 'x': {
    StringRef Digits = Rest.take_while(isHexDigit);
    Rest = Rest.drop_front(Digits.size());
    uint32_t Number = 0;
    if (Digits.getAsInteger(16, Number))
      return syntaxError("\\x");
    return Number;
  }
  default:
    return uint8_t(Letter);
  }
}

Expected<Token> Lexer::character() {
  StringRef Begin = Rest;
  Token Result;
  Result.Kind = TokenKind::Character;
  Result.TypeName = "char";
  Rest = Rest.drop_front();
  if (Rest.starts_with("\\")) {
    Expected<uint32_t> Code = escape();
    if (!Code)
      return Code.takeError();
    Result.Number = *Code;
  } else if (!Rest.empty() && Rest.front() != '\'') {
    Result.Number = uint8_t(Rest.front());
    Rest = Rest.drop_front();
  } else {
    return createStringError("Empty character constant.");
  }
  if (!Rest.consume_front("'"))
    return createStringError("Unmatched single quote.");
  Result.Text = Begin.drop_back(Rest.size());
  return Result;
}

Expected<Token> Lexer::string() {
  StringRef Begin = Rest;
  Token Result;
  Result.Kind = TokenKind::String;
  Rest = Rest.drop_front();
  while (!Rest.empty() && Rest.front() != '"') {
    if (Rest.front() == '\\') {
      Expected<uint32_t> Code = escape();
      if (!Code)
        return Code.takeError();
      Result.Contents += char(*Code);
      continue;
    }
    Result.Contents += Rest.front();
    Rest = Rest.drop_front();
  }
  if (!Rest.consume_front("\""))
    return createStringError("Unterminated string in expression.");
  Result.Text = Begin.drop_back(Rest.size());
  return Result;
}

Expected<std::vector<Token>> tokenize(StringRef Text) {
  std::vector<Token> Tokens;
  if (Error Problem = Lexer(Text).run(Tokens))
    return std::move(Problem);
  return Tokens;
}

} // namespace tp
