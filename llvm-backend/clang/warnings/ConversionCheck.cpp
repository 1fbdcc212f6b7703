//===- ConversionCheck.cpp - Indexes from inexact numbers -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/ConversionCheck.h"
#include "llvm-backend/clang/warnings/Expressions.h"
#include "llvm-backend/clang/warnings/InexactArithmetic.h"
#include "clang/AST/ExprCXX.h"

using namespace clang;
using namespace llvm;

namespace tp {

/// A conversion that makes an index, and the operation that makes it inexact.
struct ConversionCheck::Finding {
  const CastExpr *Conversion;
  const BinaryOperator *Inexact;
  bool IsReciprocal;
};

/// Looks for the conversion that an integer comes from, through variables and
/// the functions that this translation unit defines.
class ConversionCheck::Search {
public:
  explicit Search(ConversionCheck &Check) : Check(Check) {}

  std::optional<Finding> find(const Expr *Integer, const VariableFacts &Facts);

private:
  std::optional<Finding> findInVariable(const VarDecl *Variable,
                                        const VariableFacts &Facts);
  std::optional<Finding> findInCall(const CallExpr &Call);

  ConversionCheck &Check;
  DenseSet<const Decl *> Entered;
};

std::optional<ConversionCheck::Finding>
ConversionCheck::Search::findInVariable(const VarDecl *Variable,
                                        const VariableFacts &Facts) {
  if (!Entered.insert(Variable).second || Facts.isExamined(Variable))
    return std::nullopt;
  for (const Expr *Value : Facts.valuesOf(Variable))
    if (std::optional<Finding> Found = find(Value, Facts))
      return Found;
  return std::nullopt;
}

std::optional<ConversionCheck::Finding>
ConversionCheck::Search::findInCall(const CallExpr &Call) {
  if (isBoundingCall(Call))
    return std::nullopt;
  const FunctionDecl *Callee = calledDefinition(Call, Check.Context);
  if (!Callee || !Entered.insert(Callee).second)
    return std::nullopt;
  const VariableFacts &Facts = Check.factsOf(*Callee);
  for (const Expr *Value : Facts.returned())
    if (std::optional<Finding> Found = find(Value, Facts))
      return Found;
  return std::nullopt;
}

std::optional<ConversionCheck::Finding>
ConversionCheck::Search::find(const Expr *Integer, const VariableFacts &Facts) {
  Integer = Integer->IgnoreParens();
  if (const auto *Full = dyn_cast<FullExpr>(Integer))
    return find(Full->getSubExpr(), Facts);
  if (const auto *Cast = dyn_cast<CastExpr>(Integer)) {
    if (Cast->getCastKind() != CK_FloatingToIntegral)
      return find(Cast->getSubExpr(), Facts);
    InexactArithmetic Arithmetic(Facts, Check.Context);
    const Expr *Number = Cast->getSubExpr();
    if (Arithmetic.isBounded(Number))
      return std::nullopt;
    if (const BinaryOperator *Inexact = Arithmetic.findInexact(Number))
      return Finding{Cast, Inexact, Arithmetic.mayUseReciprocal(*Inexact)};
    return std::nullopt;
  }
  if (const auto *Operator = dyn_cast<BinaryOperator>(Integer)) {
    switch (Operator->getOpcode()) {
    case BO_Rem:
    case BO_And:
      return std::nullopt;
    case BO_Assign:
      return find(Operator->getRHS(), Facts);
    default:
      break;
    }
    if (std::optional<Finding> Found = find(Operator->getLHS(), Facts))
      return Found;
    return find(Operator->getRHS(), Facts);
  }
  if (const auto *Call = dyn_cast<CallExpr>(Integer))
    return findInCall(*Call);
  const VarDecl *Variable = namedVariable(Integer);
  return Variable ? findInVariable(Variable, Facts) : std::nullopt;
}

const VariableFacts &ConversionCheck::factsOf(const FunctionDecl &Function) {
  std::unique_ptr<VariableFacts> &Known = Facts[&Function];
  if (!Known)
    Known = std::make_unique<VariableFacts>(*Function.getBody());
  return *Known;
}

void ConversionCheck::report(const Finding &Found, const Expr &Index) {
  const CastExpr &Conversion = *Found.Conversion;
  const Expr &Number = *Conversion.getSubExpr();
  if (!Reporter.warn(FloatingPointWarning::Conversion, Conversion.getExprLoc(),
                     "an index out of range may come of this conversion: fast "
                     "math may round its operand up to the next integer",
                     {Number.getSourceRange()}))
    return;
  const BinaryOperator &Inexact = *Found.Inexact;
  FPOptions Options = Inexact.getFPFeaturesInEffect(Context.getLangOpts());
  std::string Note =
      Found.IsReciprocal
          ? "this division may become a multiplication by the "
            "reciprocal; '#pragma clang fp reciprocal(off)"
          : "this operation may be regrouped with its neighbors; "
            "'#pragma clang fp";
  if (Options.getAllowFPReassociate())
    Note += " reassociate(off)";
  Reporter.note(Inexact.getOperatorLoc(), Note + "' keeps it as written",
                {Inexact.getSourceRange()});
  Reporter.note(Index.getExprLoc(),
                "used as an index here; clamp it to the range of the array",
                {Index.getSourceRange()});
}

void ConversionCheck::checkFunction(const FunctionDecl &Function) {
  const VariableFacts &Own = factsOf(Function);
  for (const Expr *Index : Own.indexes())
    if (!Index->isInstantiationDependent())
      if (std::optional<Finding> Found = Search(*this).find(Index, Own))
        report(*Found, *Index);
}

} // namespace tp
