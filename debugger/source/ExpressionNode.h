//===- ExpressionNode.h - Expressions as trees ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_EXPRESSIONNODE_H
#define TP_DEBUGGER_SOURCE_EXPRESSIONNODE_H

#include "debugger/source/Arithmetic.h"
#include "debugger/source/NameResolver.h"
#include "debugger/source/Value.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What a node of an expression does with its operands.
enum class NodeKind : uint8_t {
  /// Literal.
  Constant,
  /// Name: a variable, enumerator, member of `this` or function.
  Name,
  /// Name: `$r4`, `$pc`.
  Register,
  /// Number: `$1`.
  History,
  /// Name: `$name`.
  Convenience,
  /// Of: the name of a type.
  TypeName,
  /// Operator on Operands[0].
  Unary,
  Dereference,
  AddressOf,
  /// Operator: Add or Subtract.
  PreStep,
  PostStep,
  /// Operator of arithmetic or comparison.
  Binary,
  LogicalAnd,
  LogicalOr,
  Conditional,
  /// Operator: None, or that of `+=`.
  Assign,
  Comma,
  /// Name: what is behind `.` or `->`.
  Member,
  /// Like Member of what Operands[0] points to.
  ArrowMember,
  Index,
  /// `first@count`.
  Repeat,
  /// To Of.
  Cast,
  /// `{type} address`.
  At,
  SizeOf,
};

/// A node of an expression.
struct ExpressionNode {
  NodeKind Kind = NodeKind::Constant;
  std::string Name;
  OperatorKind Operator = OperatorKind::None;
  /// Cast: only the type changes, not the bits.
  bool KeepBits = false;
  int Number = 0;
  const Type *Of = nullptr;
  Value Literal;
  std::vector<std::unique_ptr<ExpressionNode>> Operands;
  /// What Name was found to mean at the place where it was last asked for.
  mutable std::optional<BoundName> Bound;

  bool hasEffects() const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_EXPRESSIONNODE_H
