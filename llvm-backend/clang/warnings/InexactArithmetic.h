//===- InexactArithmetic.h - What fast math rounds otherwise ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_INEXACTARITHMETIC_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_INEXACTARITHMETIC_H

#include "llvm-backend/clang/warnings/VariableFacts.h"
#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"

namespace tp {

/// How one floating-point value is computed, through the variables of its
/// function.
class InexactArithmetic {
public:
  InexactArithmetic(const VariableFacts &Facts,
                    const clang::ASTContext &Context)
      : Facts(Facts), Context(Context) {}

  /// Whether a clamp or comparison keeps \p Value in bounds. In a product or
  /// sum that holds where the other operand is as simple as the number of bins.
  bool isBounded(const clang::Expr *Value);

  /// The operation in the computation of \p Value whose result fast math may
  /// change, by its reciprocal or by regrouping; null if there is none.
  const clang::BinaryOperator *findInexact(const clang::Expr *Value);

  /// Whether fast math may multiply by a reciprocal in place of \p Operator.
  bool mayUseReciprocal(const clang::BinaryOperator &Operator) const;

private:
  bool isBoundedIn(const clang::Expr *Value);
  const clang::BinaryOperator *findIn(const clang::Expr *Value,
                                      const clang::BinaryOperator *User);
  bool isInexact(const clang::BinaryOperator &Operator,
                 const clang::BinaryOperator *User) const;
  bool isExactScaling(const clang::BinaryOperator &Operator) const;
  bool isConstant(const clang::Expr *E) const;
  bool isSimple(const clang::Expr *E) const;

  const VariableFacts &Facts;
  const clang::ASTContext &Context;
  llvm::DenseSet<const clang::VarDecl *> Entered;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_INEXACTARITHMETIC_H
