//===- Expressions.cpp - Questions about expressions ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/Expressions.h"
#include "clang/AST/DeclCXX.h"
#include "clang/AST/ExprCXX.h"
#include "clang/Basic/SourceManager.h"

using namespace clang;
using namespace llvm;

namespace tp {

const Expr *unwrap(const Expr *E) {
  for (;;) {
    const Expr *Inner = E->IgnoreParenImpCasts();
    if (const auto *Cleanups = dyn_cast<FullExpr>(Inner))
      Inner = Cleanups->getSubExpr();
    else if (const auto *Bound = dyn_cast<CXXBindTemporaryExpr>(Inner))
      Inner = Bound->getSubExpr();
    else if (const auto *Default = dyn_cast<CXXDefaultArgExpr>(Inner))
      Inner = Default->getExpr();
    if (Inner == E)
      return E;
    E = Inner;
  }
}

const Expr *unwrapFloatingPoint(const Expr *E) {
  for (;;) {
    E = unwrap(E);
    const auto *Cast = dyn_cast<ExplicitCastExpr>(E);
    if (!Cast || !isFloatingPoint(Cast) || !isFloatingPoint(Cast->getSubExpr()))
      return E;
    E = Cast->getSubExpr();
  }
}

const VarDecl *namedVariable(const Expr *E) {
  const auto *Reference = dyn_cast<DeclRefExpr>(unwrap(E));
  return Reference ? dyn_cast<VarDecl>(Reference->getDecl()) : nullptr;
}

StringRef calleeName(const CallExpr &Call) {
  const FunctionDecl *Callee = Call.getDirectCallee();
  return Callee && Callee->getIdentifier() ? Callee->getName() : "";
}

const FunctionDecl *calledDefinition(const CallExpr &Call,
                                     const ASTContext &Context) {
  const FunctionDecl *Callee = Call.getDirectCallee();
  const FunctionDecl *Definition = nullptr;
  if (!Callee || !Callee->getBody(Definition) || !Definition)
    return nullptr;
  const SourceManager &Sources = Context.getSourceManager();
  if (Sources.isInSystemHeader(
          Sources.getExpansionLoc(Definition->getLocation())))
    return nullptr;
  return Definition;
}

// Keeps clang's evaluator from what it can only fail at.
static bool mayBeConstant(const Expr *E) {
  E = unwrapFloatingPoint(E);
  if (isa<FloatingLiteral, IntegerLiteral>(E))
    return true;
  if (const auto *Unary = dyn_cast<UnaryOperator>(E))
    return mayBeConstant(Unary->getSubExpr());
  if (const auto *Binary = dyn_cast<BinaryOperator>(E))
    return mayBeConstant(Binary->getLHS()) && mayBeConstant(Binary->getRHS());
  if (const auto *Cast = dyn_cast<ExplicitCastExpr>(E))
    return mayBeConstant(Cast->getSubExpr());
  if (const auto *Call = dyn_cast<CallExpr>(E)) {
    const FunctionDecl *Callee = Call->getDirectCallee();
    return Callee && Callee->isConstexpr() &&
           all_of(Call->arguments(), mayBeConstant);
  }
  const VarDecl *Variable = namedVariable(E);
  return Variable && Variable->getType().isConstQualified() &&
         !isa<ParmVarDecl>(Variable) && Variable->hasInit();
}

std::optional<APFloat> constantValue(const Expr *E, const ASTContext &Context) {
  Expr::EvalResult Result;
  if (E->isValueDependent() || !mayBeConstant(E) ||
      !E->EvaluateAsRValue(Result, Context) || !Result.Val.isFloat())
    return std::nullopt;
  return Result.Val.getFloat();
}

} // namespace tp
