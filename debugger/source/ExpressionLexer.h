//===- ExpressionLexer.h - Words of expressions -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_EXPRESSIONLEXER_H
#define TP_DEBUGGER_SOURCE_EXPRESSIONLEXER_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

enum class TokenKind : uint8_t {
  End,
  /// A name without `::`.
  Identifier,
  /// `$name`, `$1`, `$$`.
  Dollar,
  Integer,
  Real,
  Character,
  String,
  /// An operator or bracket; Text says which.
  Punctuator,
};

/// A word of an expression.
struct Token {
  TokenKind Kind = TokenKind::End;
  llvm::StringRef Text;
  /// Integer, Character.
  uint64_t Number = 0;
  /// Real.
  double RealNumber = 0;
  /// The type of a literal: `unsigned int`, `float`.
  llvm::StringRef TypeName;
  /// String: without quotes and escapes.
  std::string Contents;

  bool is(llvm::StringRef Punctuator) const {
    return Kind == TokenKind::Punctuator && Text == Punctuator;
  }
  bool isWord(llvm::StringRef Word) const {
    return Kind == TokenKind::Identifier && Text == Word;
  }
};

/// The words of \p Text, which the tokens refer to; the last one is End.
llvm::Expected<std::vector<Token>> tokenize(llvm::StringRef Text);

/// What is said of an expression that is wrong at \p Near.
llvm::Error syntaxError(llvm::StringRef Near);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_EXPRESSIONLEXER_H
