//===- Expression.h - Expressions of C++ over a program's values *- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_EXPRESSION_H
#define TP_DEBUGGER_SOURCE_EXPRESSION_H

#include "debugger/source/Value.h"

#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringRef.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

class DebugInformation;
class ExpressionEvaluator;
struct ExpressionNode;

/// `$1`, `$$`, `$name`: what earlier expressions gave.
class ValueHistory {
public:
  /// Keeps a value; its number, from 1 on.
  unsigned add(Value Kept);
  /// Number \p Number; 0 and below count back from the last (`$$2` is -2).
  /// nullptr if there is none.
  const Value *get(int Number) const;
  unsigned size() const { return unsigned(Values.size()); }

  const Value *variable(llvm::StringRef Name) const;
  void setVariable(llvm::StringRef Name, Value Kept);

private:
  std::vector<Value> Values;
  llvm::StringMap<Value> Named;
};

/// An expression, parsed once and evaluated at any frame. docs/debugging.md
/// says what is understood.
class Expression {
public:
  /// Parses \p Text; what names mean is decided when it is evaluated, except
  /// that names of types are those that \p Scope sees. The error has the place
  /// in the text. \p Information must outlive the expression.
  static llvm::Expected<Expression> parse(llvm::StringRef Text,
                                          DebugInformation &Information,
                                          const FrameContext *Scope = nullptr);

  Expression(Expression &&) noexcept;
  Expression &operator=(Expression &&) noexcept;
  ~Expression();

  /// The value at a frame; assignments change the program. \p History serves
  /// `$1` and `$name`; without it they are errors.
  llvm::Expected<Value> evaluate(const FrameContext &Frame,
                                 ValueHistory *History = nullptr) const;
  /// Whether the value is not zero: a condition. Errors as evaluate().
  llvm::Expected<bool> isTrue(const FrameContext &Frame,
                              ValueHistory *History = nullptr) const;

  const std::string &text() const { return Text; }
  /// Whether it changes anything.
  bool hasEffects() const;
  /// If it is only the name of a type (`whatis`, `ptype`, `sizeof`).
  const Type *namedType() const;

private:
  Expression();

  std::string Text;
  std::unique_ptr<ExpressionEvaluator> Evaluator;
  std::unique_ptr<ExpressionNode> Root;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_EXPRESSION_H
