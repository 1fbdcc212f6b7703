//===- VariableFacts.h - What a function does to its variables --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_VARIABLEFACTS_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_VARIABLEFACTS_H

#include "clang/AST/Expr.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/DenseSet.h"
#include "llvm/ADT/SmallVector.h"

namespace tp {

/// Whether \p Call is of a function that by its name keeps a value in bounds:
/// minimum, clamp, fmod, saturate, ...
bool isBoundingCall(const clang::CallExpr &Call);

/// What a function and the lambdas in it do to their variables, in any order.
class VariableFacts {
public:
  explicit VariableFacts(const clang::Stmt &Body);

  /// What \p Variable is initialized with and assigned.
  llvm::ArrayRef<const clang::Expr *>
  valuesOf(const clang::VarDecl *Variable) const;

  /// Whether something looks at the value of \p Variable, or may: a comparison,
  /// a clamp, a remainder, a function that can write it.
  bool isExamined(const clang::VarDecl *Variable) const {
    return Examined.contains(Variable);
  }

  /// The expressions that elements of arrays are selected by.
  llvm::ArrayRef<const clang::Expr *> indexes() const { return Indexes; }
  /// The values that the function returns.
  llvm::ArrayRef<const clang::Expr *> returned() const { return Returned; }

private:
  class Collector;

  llvm::DenseMap<const clang::VarDecl *,
                 llvm::SmallVector<const clang::Expr *, 2>>
      Values;
  llvm::DenseSet<const clang::VarDecl *> Examined;
  llvm::SmallVector<const clang::Expr *, 8> Indexes;
  llvm::SmallVector<const clang::Expr *, 4> Returned;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_VARIABLEFACTS_H
