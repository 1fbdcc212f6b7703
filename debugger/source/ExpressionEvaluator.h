//===- ExpressionEvaluator.h - Computes trees of expressions ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_EXPRESSIONEVALUATOR_H
#define TP_DEBUGGER_SOURCE_EXPRESSIONEVALUATOR_H

#include "debugger/source/Arithmetic.h"
#include "debugger/source/ExpressionNode.h"
#include "debugger/source/NameResolver.h"

namespace tp {

class DebugInformation;
class ValueHistory;

/// Evaluates expressions at any frame of a program.
class ExpressionEvaluator {
public:
  /// \p Information must outlive the evaluator.
  explicit ExpressionEvaluator(DebugInformation &Information);

  /// The value of \p Node; \p History may be missing.
  llvm::Expected<Value> evaluate(const ExpressionNode &Node,
                                 const FrameContext &Frame,
                                 ValueHistory *History) const;
  const Arithmetic &arithmetic() const { return Math; }

private:
  DebugInformation &Information;
  NameResolver Names;
  Arithmetic Math;

  /// What does not change in an evaluation.
  struct Place {
    const FrameContext &Frame;
    ValueHistory *History;
  };

  llvm::Expected<Value> run(const ExpressionNode &Node, Place At) const;
  /// Operators that need no more than the value of their first operand.
  llvm::Expected<Value> ofValue(const ExpressionNode &Node, Place At) const;
  /// The value of a node, of a reference what it refers to.
  llvm::Expected<Value> object(const ExpressionNode &Node, Place At) const;
  /// The number of an integer or pointer, not of another type.
  llvm::Expected<uint64_t> integer(const Value &Of, Place At) const;
  llvm::Expected<Value> name(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> registerValue(llvm::StringRef Name, Place At) const;
  llvm::Expected<Value> earlier(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> dereference(const Value &Of, Place At) const;
  llvm::Expected<Value> addressOf(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> binary(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> logical(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> step(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> assign(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> setConvenience(llvm::StringRef Name, const Value &New,
                                       Place At) const;
  llvm::Expected<Value> setPc(const Value &New, Place At) const;
  llvm::Expected<Value> store(const ExpressionNode &Target, const Value &Object,
                              const Value &New, Place At) const;
  llvm::Expected<Value> member(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> index(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> branch(const ExpressionNode &Taken,
                               const ExpressionNode &Other, Place At) const;
  llvm::Expected<Value> repeat(const ExpressionNode &Node, Place At) const;
  llvm::Expected<Value> sizeOf(const ExpressionNode &Node, Place At) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_EXPRESSIONEVALUATOR_H
