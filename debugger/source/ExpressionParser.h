//===- ExpressionParser.h - Makes trees of expressions ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_EXPRESSIONPARSER_H
#define TP_DEBUGGER_SOURCE_EXPRESSIONPARSER_H

#include "debugger/source/ExpressionLexer.h"
#include "debugger/source/ExpressionNode.h"

#include <memory>
#include <optional>
#include <vector>

namespace tp {

class DebugInformation;

/// A parser of C++'s expressions by recursive descent, with gdb's `$`, `@` and
/// `{type} address`.
class ExpressionParser {
public:
  using NodePointer = std::unique_ptr<ExpressionNode>;

  /// \p Scope, if there is one, decides between variables and types of the same
  /// name. What is passed must outlive the parser.
  ExpressionParser(llvm::ArrayRef<Token> Tokens, DebugInformation &Information,
                   const FrameContext *Scope)
      : Tokens(Tokens), Information(Information), Scope(Scope) {}

  llvm::Expected<NodePointer> run();

private:
  llvm::ArrayRef<Token> Tokens;
  DebugInformation &Information;
  const FrameContext *Scope;
  size_t At = 0;
  unsigned Depth = 0;

  const Token &peek(size_t Ahead = 0) const;
  bool accept(llvm::StringRef Punctuator);
  llvm::Error expect(llvm::StringRef Punctuator);
  llvm::Error unexpected() const;

  llvm::Expected<NodePointer> comma();
  llvm::Expected<NodePointer> assignment();
  llvm::Expected<NodePointer> conditional();
  llvm::Expected<NodePointer> binary(unsigned MinPrecedence);
  llvm::Expected<NodePointer> unary();
  llvm::Expected<NodePointer> sizeOf();
  llvm::Expected<NodePointer> typedAddress();
  llvm::Expected<NodePointer> bracketed();
  llvm::Expected<NodePointer> parenthesis();
  llvm::Error unknownCast();
  llvm::Expected<NodePointer> namedCast();
  llvm::Expected<NodePointer> postfix(NodePointer Operand);
  llvm::Expected<NodePointer> primary();
  llvm::Expected<NodePointer> literal();
  llvm::Expected<NodePointer> dollar();
  llvm::Expected<NodePointer> name();

  /// A type's name at the current word; nothing, and nothing taken, if there is
  /// none.
  llvm::Expected<const Type *> typeName();
  llvm::Expected<const Type *> declarator(const Type &Base);
  const Type *pointers(const Type &Base);
  unsigned innerStars();
  const Type *arrays(const Type &Element);
  llvm::Expected<const Type *> function(const Type &Result);
  const Type *builtin();
  const Type *namedType();
  bool isVariable(llvm::StringRef Name) const;
  std::string qualifiedName();
  void templateArguments(std::string &Name);
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_EXPRESSIONPARSER_H
