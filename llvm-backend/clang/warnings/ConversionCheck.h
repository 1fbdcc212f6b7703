//===- ConversionCheck.h - Indexes from inexact numbers ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_CONVERSIONCHECK_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_CONVERSIONCHECK_H

#include "llvm-backend/clang/warnings/VariableFacts.h"
#include "llvm-backend/clang/warnings/WarningReporter.h"
#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"

#include <map>
#include <memory>

namespace tp {

/// -Wtp-fp-conversion: a number that fast math may round otherwise becomes an
/// integer, and that selects an element of an array without having been looked
/// at: one unit in the last place decides whether it is in range.
class ConversionCheck {
public:
  ConversionCheck(const clang::ASTContext &Context, WarningReporter &Reporter)
      : Context(Context), Reporter(Reporter) {}

  /// Checks all indexes in \p Function and the lambdas in it.
  void checkFunction(const clang::FunctionDecl &Function);

private:
  struct Finding;
  class Search;

  const VariableFacts &factsOf(const clang::FunctionDecl &Function);
  void report(const Finding &Found, const clang::Expr &Index);

  const clang::ASTContext &Context;
  WarningReporter &Reporter;
  std::map<const clang::FunctionDecl *, std::unique_ptr<VariableFacts>> Facts;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_CONVERSIONCHECK_H
