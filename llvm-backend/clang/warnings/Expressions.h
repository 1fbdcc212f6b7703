//===- Expressions.h - Questions about expressions --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_EXPRESSIONS_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_EXPRESSIONS_H

#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"

#include <optional>

namespace tp {

inline bool isFloatingPoint(const clang::Expr *E) {
  return E->getType()->isRealFloatingType();
}

inline bool isAdditive(clang::BinaryOperatorKind Operator) {
  return clang::BinaryOperator::isAdditiveOp(Operator);
}

/// The expression without what passes its value on: parentheses, conversions
/// that are not written, temporaries.
const clang::Expr *unwrap(const clang::Expr *E);

/// As unwrap(), and without written conversions between floating types.
const clang::Expr *unwrapFloatingPoint(const clang::Expr *E);

/// The variable that \p E names, or null.
const clang::VarDecl *namedVariable(const clang::Expr *E);

/// The name of the function that \p Call calls directly; empty if it has none.
llvm::StringRef calleeName(const clang::CallExpr &Call);

/// The body of the function that \p Call calls, if this translation unit
/// defines it outside system headers.
const clang::FunctionDecl *calledDefinition(const clang::CallExpr &Call,
                                            const clang::ASTContext &Context);

/// The value of a constant expression of literals, constants and calls.
std::optional<llvm::APFloat> constantValue(const clang::Expr *E,
                                           const clang::ASTContext &Context);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_EXPRESSIONS_H
