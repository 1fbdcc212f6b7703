//===- MixedRounding.h - Rounded results of two arguments -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_MIXEDROUNDING_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_MIXEDROUNDING_H

#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"

#include <optional>

namespace tp {

/// Who may fuse a product with a sum, besides what the options of each
/// expression allow.
struct ContractionRules {
  /// Whether the canonicalizer chooses what is fused: never a*b - c*d, which is
  /// then 0 for equal products.
  bool IsCanonical;
};

/// A sum or difference of what comes from both arguments of a comparator, whose
/// sign the comparator reads.
struct MixedRounding {
  enum class Cause { Contraction, Reassociation, Reciprocal };

  const clang::BinaryOperator *Operator;
  /// The function that contains Operator: the comparator or one it calls.
  const clang::FunctionDecl *Function;
  Cause Why;
};

/// Looks into \p Comparator, a function of two arguments with a body, and what
/// it calls, for the first sum or difference that its answer depends on and
/// that may be inconsistent under the options in effect there.
std::optional<MixedRounding>
findMixedRounding(const clang::FunctionDecl &Comparator,
                  clang::ASTContext &Context, const ContractionRules &Rules);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_MIXEDROUNDING_H
