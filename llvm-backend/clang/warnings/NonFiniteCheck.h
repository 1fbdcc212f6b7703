//===- NonFiniteCheck.h - Infinity and NaN under finite math ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_NONFINITECHECK_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_NONFINITECHECK_H

#include "llvm-backend/clang/warnings/WarningReporter.h"
#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"

namespace tp {

/// -Wtp-fp-nonfinite: an infinity or a NaN, or a test for one, where the
/// compiler may assume that there is none.
class NonFiniteCheck {
public:
  NonFiniteCheck(const clang::ASTContext &Context, WarningReporter &Reporter)
      : Context(Context), Reporter(Reporter) {}

  /// INFINITY, NAN, HUGE_VAL, members of std::numeric_limits, isnan(), ...
  void checkCall(const clang::CallExpr &Call);
  /// `x != x`, `x - x == 0`, `x > FLT_MAX`, and constants such as `1.0f / 0`.
  void checkBinaryOperator(const clang::BinaryOperator &Operator);
  /// `float(1e300)`.
  void checkCast(const clang::CastExpr &Cast);
  /// `1e39f`, unless clang's -Wliteral-range says enough.
  void checkLiteral(const clang::FloatingLiteral &Literal);

private:
  void checkComparison(const clang::BinaryOperator &Comparison);
  void checkConstant(const clang::Expr &E,
                     llvm::ArrayRef<const clang::Expr *> Operands);
  void warnOfValue(const clang::Expr &E, llvm::StringRef What);
  void warnOfTest(const clang::Expr &E, llvm::StringRef What);
  void warn(const clang::Expr &E, const llvm::Twine &Message);
  bool honorsNaNs(const clang::Expr &E) const;
  bool honorsInfinities(const clang::Expr &E) const;

  const clang::ASTContext &Context;
  WarningReporter &Reporter;
  bool CureIsTold = false;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_NONFINITECHECK_H
