//===- DoubleCheck.h - Arithmetic in double ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_DOUBLECHECK_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_DOUBLECHECK_H

#include "llvm-backend/clang/warnings/WarningReporter.h"
#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"
#include "llvm/ADT/SmallPtrSet.h"

namespace tp {

/// -Wtp-double: a kernel that is meant to compute in float computes in double,
/// which is software: a literal without `f`, a promotion, a function of the C
/// library. One warning for an expression; of what has to be double, arguments
/// for `...`, none.
///
/// Expressions have to come from the outside in.
class DoubleCheck {
public:
  DoubleCheck(const clang::ASTContext &Context, WarningReporter &Reporter)
      : Context(Context), Reporter(Reporter) {}

  void checkBinaryOperator(const clang::BinaryOperator &Operator);
  void checkUnaryOperator(const clang::UnaryOperator &Operator);
  void checkCast(const clang::CastExpr &Cast);
  void checkCall(const clang::CallExpr &Call);

private:
  bool isDouble(clang::QualType Type) const;
  bool isConstant(const clang::Expr &E) const;
  bool isArithmeticInDouble(const clang::BinaryOperator &Operator) const;
  bool isDone(const clang::Expr &E) const { return Done.contains(&E); }
  void finish(const clang::Expr *E);
  void noteLiterals(const clang::Expr *E);
  void checkVariableArguments(const clang::CallExpr &Call, unsigned First);

  const clang::ASTContext &Context;
  WarningReporter &Reporter;
  /// Part of an expression that has been reported.
  llvm::SmallPtrSet<const clang::Expr *, 32> Done;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_DOUBLECHECK_H
