//===- ComparatorCheck.h - Orders that rounding breaks ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_COMPARATORCHECK_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_COMPARATORCHECK_H

#include "llvm-backend/clang/warnings/MixedRounding.h"
#include "llvm-backend/clang/warnings/WarningReporter.h"
#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"
#include "clang/AST/ExprCXX.h"
#include "clang/AST/TypeLoc.h"

namespace tp {

/// -Wtp-fp-comparator: what orders the elements of a sort, a set or the like
/// reads the sign of a number that it computes from both elements, in a way
/// that fused or regrouped operations turn into an inconsistent order.
class ComparatorCheck {
public:
  ComparatorCheck(clang::ASTContext &Context, const ContractionRules &Rules,
                  WarningReporter &Reporter)
      : Context(Context), Rules(Rules), Reporter(Reporter) {}

  /// Checks comparators that \p Call hands to an algorithm.
  void checkCall(const clang::CallExpr &Call);
  /// Checks comparators that a container is made with.
  void checkConstruction(const clang::CXXConstructExpr &Construction);
  /// Checks the comparator in the type of a container.
  void checkContainerType(clang::TemplateSpecializationTypeLoc Type);

private:
  void checkArgument(const clang::Expr &Argument, llvm::StringRef User,
                     clang::SourceLocation Place);
  void checkElementOrder(clang::QualType Element, llvm::StringRef User,
                         clang::SourceLocation Place);
  void checkComparator(const clang::FunctionDecl *Comparator,
                       llvm::StringRef User, clang::SourceLocation Place);
  void checkFunctor(const clang::CXXRecordDecl &Class, llvm::StringRef User,
                    clang::SourceLocation Place);
  void report(const MixedRounding &Found, llvm::StringRef User,
              clang::SourceLocation Place);

  clang::ASTContext &Context;
  const ContractionRules Rules;
  WarningReporter &Reporter;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_COMPARATORCHECK_H
