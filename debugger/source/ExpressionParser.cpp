//===- ExpressionParser.cpp - Makes trees of expressions -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/ExpressionParser.h"

#include "debugger/source/DebugInformation.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/ScopeExit.h"

using namespace llvm;

namespace tp {

using NodePointer = ExpressionParser::NodePointer;

namespace {

struct BinaryWord {
  StringRef Text;
  unsigned Precedence;
  NodeKind Kind;
  OperatorKind Operator;
};

} // namespace

static constexpr BinaryWord kBinaryWords[] = {
    {"||", 1, NodeKind::LogicalOr, OperatorKind::None},
    {"&&", 2, NodeKind::LogicalAnd, OperatorKind::None},
    {"|", 3, NodeKind::Binary, OperatorKind::BitOr},
    {"^", 4, NodeKind::Binary, OperatorKind::BitXor},
    {"&", 5, NodeKind::Binary, OperatorKind::BitAnd},
    {"==", 6, NodeKind::Binary, OperatorKind::Equal},
    {"!=", 6, NodeKind::Binary, OperatorKind::NotEqual},
    {"<", 7, NodeKind::Binary, OperatorKind::Less},
    {">", 7, NodeKind::Binary, OperatorKind::Greater},
    {"<=", 7, NodeKind::Binary, OperatorKind::LessEqual},
    {">=", 7, NodeKind::Binary, OperatorKind::GreaterEqual},
    {"<<", 8, NodeKind::Binary, OperatorKind::ShiftLeft},
    {">>", 8, NodeKind::Binary, OperatorKind::ShiftRight},
    {"@", 9, NodeKind::Repeat, OperatorKind::None},
    {"+", 10, NodeKind::Binary, OperatorKind::Add},
    {"-", 10, NodeKind::Binary, OperatorKind::Subtract},
    {"*", 11, NodeKind::Binary, OperatorKind::Multiply},
    {"/", 11, NodeKind::Binary, OperatorKind::Divide},
    {"%", 11, NodeKind::Binary, OperatorKind::Remainder},
};

static constexpr unsigned kMaxDepth = 500;

static const BinaryWord *binaryWord(const Token &Word) {
  if (Word.Kind != TokenKind::Punctuator)
    return nullptr;
  const auto *Found = find_if(kBinaryWords, [&](const BinaryWord &Entry) {
    return Entry.Text == Word.Text;
  });
  return Found == std::end(kBinaryWords) ? nullptr : Found;
}

template <class... Operands>
static NodePointer makeNode(NodeKind Kind, Operands... Children) {
  auto Node = std::make_unique<ExpressionNode>();
  Node->Kind = Kind;
  (Node->Operands.push_back(std::move(Children)), ...);
  return Node;
}

static NodePointer makeCast(const Type &To, NodePointer Operand) {
  NodePointer Node = makeNode(NodeKind::Cast, std::move(Operand));
  Node->Of = &To;
  return Node;
}

const Token &ExpressionParser::peek(size_t Ahead) const {
  return Tokens[std::min(At + Ahead, Tokens.size() - 1)];
}

bool ExpressionParser::accept(StringRef Punctuator) {
  if (!peek().is(Punctuator))
    return false;
  ++At;
  return true;
}

Error ExpressionParser::unexpected() const {
  const Token &Word = peek();
  if (Word.Kind == TokenKind::End)
    return syntaxError({});
  const char *Begin = Word.Text.data();
  const Token *Last = &Word;
  while (Last->Kind != TokenKind::End)
    ++Last;
  const Token &End = *(Last - 1);
  return syntaxError(
      StringRef(Begin, size_t(End.Text.data() + End.Text.size() - Begin)));
}

Error ExpressionParser::expect(StringRef Punctuator) {
  return accept(Punctuator) ? Error::success() : unexpected();
}

Expected<NodePointer> ExpressionParser::run() {
  Expected<NodePointer> Root = comma();
  if (Root && peek().Kind != TokenKind::End)
    return unexpected();
  return Root;
}

Expected<NodePointer> ExpressionParser::comma() {
  Expected<NodePointer> Left = assignment();
  while (Left && accept(",")) {
    Expected<NodePointer> Right = assignment();
    if (!Right)
      return Right;
    Left = makeNode(NodeKind::Comma, std::move(*Left), std::move(*Right));
  }
  return Left;
}

Expected<NodePointer> ExpressionParser::assignment() {
  // Each level of brackets comes by here.
  if (++Depth > kMaxDepth)
    return createStringError("The expression is nested too deeply.");
  scope_exit Leave([this] { --Depth; });
  Expected<NodePointer> Left = conditional();
  if (!Left || peek().Kind != TokenKind::Punctuator)
    return Left;
  StringRef Word = peek().Text;
  OperatorKind Operator = OperatorKind::None;
  if (Word != "=") {
    static constexpr StringLiteral kAssignable[] = {"+", "-", "*", "/",  "%",
                                                    "&", "|", "^", "<<", ">>"};
    if (!Word.consume_back("=") || !is_contained(kAssignable, Word))
      return Left;
    for (const BinaryWord &Entry : kBinaryWords)
      if (Entry.Text == Word)
        Operator = Entry.Operator;
  }
  ++At;
  Expected<NodePointer> Right = assignment();
  if (!Right)
    return Right;
  NodePointer Node =
      makeNode(NodeKind::Assign, std::move(*Left), std::move(*Right));
  Node->Operator = Operator;
  return Node;
}

Expected<NodePointer> ExpressionParser::conditional() {
  Expected<NodePointer> Condition = binary(1);
  if (!Condition || !accept("?"))
    return Condition;
  Expected<NodePointer> Then = comma();
  if (!Then)
    return Then;
  if (Error Problem = expect(":"))
    return std::move(Problem);
  Expected<NodePointer> Else = assignment();
  if (!Else)
    return Else;
  return makeNode(NodeKind::Conditional, std::move(*Condition),
                  std::move(*Then), std::move(*Else));
}

Expected<NodePointer> ExpressionParser::binary(unsigned MinPrecedence) {
  Expected<NodePointer> Left = unary();
  while (Left) {
    const BinaryWord *Word = binaryWord(peek());
    if (!Word || Word->Precedence < MinPrecedence)
      return Left;
    ++At;
    Expected<NodePointer> Right = binary(Word->Precedence + 1);
    if (!Right)
      return Right;
    NodePointer Node =
        makeNode(Word->Kind, std::move(*Left), std::move(*Right));
    Node->Operator = Word->Operator;
    Left = std::move(Node);
  }
  return Left;
}

Expected<NodePointer> ExpressionParser::unary() {
  if (++Depth > kMaxDepth)
    return createStringError("The expression is nested too deeply.");
  scope_exit Leave([this] { --Depth; });
  struct Prefix {
    StringRef Text;
    NodeKind Kind;
    OperatorKind Operator;
  };
  static constexpr Prefix kPrefixes[] = {
      {"-", NodeKind::Unary, OperatorKind::Minus},
      {"+", NodeKind::Unary, OperatorKind::Plus},
      {"!", NodeKind::Unary, OperatorKind::Not},
      {"~", NodeKind::Unary, OperatorKind::Complement},
      {"*", NodeKind::Dereference, OperatorKind::None},
      {"&", NodeKind::AddressOf, OperatorKind::None},
      {"++", NodeKind::PreStep, OperatorKind::Add},
      {"--", NodeKind::PreStep, OperatorKind::Subtract},
  };
  for (const Prefix &Word : kPrefixes) {
    if (!accept(Word.Text))
      continue;
    Expected<NodePointer> Operand = unary();
    if (!Operand)
      return Operand;
    NodePointer Node = makeNode(Word.Kind, std::move(*Operand));
    Node->Operator = Word.Operator;
    return Node;
  }
  if (peek().isWord("sizeof"))
    return sizeOf();
  if (peek().is("("))
    return parenthesis();
  if (peek().is("{"))
    return typedAddress();
  Expected<NodePointer> Operand = primary();
  if (!Operand)
    return Operand;
  return postfix(std::move(*Operand));
}

/// `{type} address`.
Expected<NodePointer> ExpressionParser::typedAddress() {
  ++At;
  Expected<const Type *> Of = typeName();
  if (!Of)
    return Of.takeError();
  if (!*Of)
    return unexpected();
  if (Error Problem = expect("}"))
    return std::move(Problem);
  Expected<NodePointer> Address = unary();
  if (!Address)
    return Address;
  NodePointer Node = makeNode(NodeKind::At, std::move(*Address));
  Node->Of = *Of;
  return Node;
}

Expected<NodePointer> ExpressionParser::sizeOf() {
  ++At;
  size_t Begin = At;
  if (accept("(")) {
    Expected<const Type *> Of = typeName();
    if (!Of)
      return Of.takeError();
    if (*Of && accept(")")) {
      NodePointer Node = makeNode(NodeKind::SizeOf);
      Node->Of = *Of;
      return Node;
    }
    At = Begin;
  }
  Expected<NodePointer> Operand = unary();
  if (!Operand)
    return Operand;
  if ((*Operand)->hasEffects())
    return createStringError("The operand of sizeof may not change anything.");
  return makeNode(NodeKind::SizeOf, std::move(*Operand));
}

/// What stands in brackets, of which the first has been taken.
Expected<NodePointer> ExpressionParser::bracketed() {
  Expected<NodePointer> Inner = comma();
  if (!Inner)
    return Inner;
  if (Error Problem = expect(")"))
    return std::move(Problem);
  return Inner;
}

Expected<NodePointer> ExpressionParser::parenthesis() {
  ++At;
  Expected<const Type *> Of = typeName();
  if (!Of)
    return Of.takeError();
  if (*Of) {
    if (Error Problem = expect(")"))
      return std::move(Problem);
    Expected<NodePointer> Operand = unary();
    if (!Operand)
      return Operand;
    return makeCast(**Of, std::move(*Operand));
  }
  if (Error Problem = unknownCast())
    return std::move(Problem);
  Expected<NodePointer> Inner = bracketed();
  if (!Inner)
    return Inner;
  return postfix(std::move(*Inner));
}

/// `(Name *)`, where the name is no type's.
Error ExpressionParser::unknownCast() {
  size_t Begin = At;
  std::string Name = qualifiedName();
  bool HasStar = false;
  while (accept("*"))
    HasStar = true;
  bool IsCast = HasStar && !Name.empty() && peek().is(")");
  At = Begin;
  return IsCast ? createStringError("No symbol \"" + Name +
                                    "\" in current context.")
                : Error::success();
}

Expected<NodePointer> ExpressionParser::namedCast() {
  bool KeepBits = peek().isWord("reinterpret_cast");
  ++At;
  if (Error Problem = expect("<"))
    return std::move(Problem);
  Expected<const Type *> Of = typeName();
  if (!Of)
    return Of.takeError();
  if (!*Of)
    return unexpected();
  if (Error Problem = expect(">"))
    return std::move(Problem);
  if (Error Problem = expect("("))
    return std::move(Problem);
  Expected<NodePointer> Operand = bracketed();
  if (!Operand)
    return Operand;
  NodePointer Node = makeCast(**Of, std::move(*Operand));
  Node->KeepBits = KeepBits;
  return postfix(std::move(Node));
}

Expected<NodePointer> ExpressionParser::postfix(NodePointer Operand) {
  while (true) {
    if (accept("[")) {
      Expected<NodePointer> Index = comma();
      if (!Index)
        return Index;
      if (Error Problem = expect("]"))
        return std::move(Problem);
      Operand =
          makeNode(NodeKind::Index, std::move(Operand), std::move(*Index));
    } else if (peek().is(".") || peek().is("->")) {
      bool IsArrow = peek().is("->");
      ++At;
      if (peek().Kind != TokenKind::Identifier)
        return unexpected();
      Operand = makeNode(IsArrow ? NodeKind::ArrowMember : NodeKind::Member,
                         std::move(Operand));
      Operand->Name = qualifiedName();
    } else if (peek().is("++") || peek().is("--")) {
      Operand = makeNode(NodeKind::PostStep, std::move(Operand));
      Operand->Operator =
          peek().is("++") ? OperatorKind::Add : OperatorKind::Subtract;
      ++At;
    } else if (peek().is("(")) {
      return createStringError("Functions of the program cannot be called: it "
                               "would have to run.");
    } else {
      return Operand;
    }
  }
}

Expected<NodePointer> ExpressionParser::primary() {
  switch (peek().Kind) {
  case TokenKind::Integer:
  case TokenKind::Real:
  case TokenKind::Character:
  case TokenKind::String:
    return literal();
  case TokenKind::Dollar:
    return dollar();
  case TokenKind::Identifier:
    return name();
  default:
    if (peek().is("::"))
      return name();
    return unexpected();
  }
}

Expected<NodePointer> ExpressionParser::literal() {
  const Token &Word = Tokens[At++];
  TypeTable &Types = Information.types();
  NodePointer Node = makeNode(NodeKind::Constant);
  if (Word.Kind == TokenKind::String) {
    const Type &Of =
        Types.arrayOf(Types.basic("char"), uint32_t(Word.Contents.size() + 1));
    Node->Literal = Value::computed(
        Of, ArrayRef(reinterpret_cast<const uint8_t *>(Word.Contents.c_str()),
                     Word.Contents.size() + 1));
  } else if (Word.Kind == TokenKind::Real) {
    Node->Literal = Value::real(Types.basic(Word.TypeName), Word.RealNumber);
  } else {
    Node->Literal = Value::integer(Types.basic(Word.TypeName), Word.Number);
  }
  return Node;
}

static bool isRegisterName(StringRef Name) {
  static constexpr StringLiteral kNames[] = {"pc", "sp", "fp", "ra", "cfa"};
  if (is_contained(kNames, Name))
    return true;
  unsigned Number;
  return (Name.consume_front("r") || Name.consume_front("f")) &&
         !Name.empty() && !Name.getAsInteger(10, Number) && Number < 32;
}

/// `$`, `$$`, `$$3` and `$3` count in the history.
Expected<NodePointer> ExpressionParser::dollar() {
  StringRef Word = Tokens[At++].Text;
  StringRef Name = Word.ltrim('$');
  size_t Dollars = Word.size() - Name.size();
  int Number = 0;
  bool IsNumber = !Name.empty() && !Name.getAsInteger(10, Number);
  if (Name.empty() || IsNumber) {
    if (Dollars > 2)
      return syntaxError(Word);
    NodePointer Node = makeNode(NodeKind::History);
    Node->Number = Dollars == 2 ? (IsNumber ? -Number : -1) : Number;
    return Node;
  }
  if (Dollars != 1)
    return syntaxError(Word);
  NodePointer Node = makeNode(isRegisterName(Name) ? NodeKind::Register
                                                   : NodeKind::Convenience);
  Node->Name = Name.str();
  return Node;
}

Expected<NodePointer> ExpressionParser::name() {
  static constexpr StringLiteral kCasts[] = {"static_cast", "reinterpret_cast",
                                             "const_cast"};
  if (is_contained(kCasts, peek().Text))
    return namedCast();
  if (peek().isWord("true") || peek().isWord("false")) {
    NodePointer Node = makeNode(NodeKind::Constant);
    Node->Literal = Value::integer(Information.types().basic("bool"),
                                   peek().isWord("true"));
    ++At;
    return Node;
  }
  if (peek().isWord("nullptr")) {
    ++At;
    NodePointer Node = makeNode(NodeKind::Constant);
    TypeTable &Types = Information.types();
    Node->Literal = Value::integer(Types.pointerTo(Types.basic("void")), 0);
    return Node;
  }
  Expected<const Type *> Of = typeName();
  if (!Of)
    return Of.takeError();
  if (!*Of) {
    NodePointer Node = makeNode(NodeKind::Name);
    Node->Name = qualifiedName();
    return Node;
  }
  // `float(x)`.
  if (accept("(")) {
    Expected<NodePointer> Operand = bracketed();
    if (!Operand)
      return Operand;
    return makeCast(**Of, std::move(*Operand));
  }
  NodePointer Node = makeNode(NodeKind::TypeName);
  Node->Of = *Of;
  return Node;
}

} // namespace tp
