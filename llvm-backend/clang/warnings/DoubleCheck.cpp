//===- DoubleCheck.cpp - Arithmetic in double -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/DoubleCheck.h"
#include "llvm-backend/clang/warnings/Expressions.h"
#include "clang/AST/ExprCXX.h"
#include "clang/Lex/Lexer.h"

using namespace clang;
using namespace llvm;

namespace tp {

static constexpr const char InSoftware[] = ", which the TP does in software";

// Vectors and complex numbers by their elements.
bool DoubleCheck::isDouble(QualType Type) const {
  if (const auto *Vector = Type->getAs<VectorType>())
    Type = Vector->getElementType();
  else if (const auto *Complex = Type->getAs<ComplexType>())
    Type = Complex->getElementType();
  return Type->isRealFloatingType() && Context.getTypeSize(Type) > 32;
}

bool DoubleCheck::isConstant(const Expr &E) const {
  return E.isInstantiationDependent() ||
         E.isEvaluatable(Context, Expr::SE_NoSideEffects);
}

bool DoubleCheck::isArithmeticInDouble(const BinaryOperator &Operator) const {
  if (const auto *Compound = dyn_cast<CompoundAssignOperator>(&Operator))
    return isDouble(Compound->getComputationLHSType());
  return (Operator.isMultiplicativeOp() || Operator.isAdditiveOp() ||
          Operator.isComparisonOp()) &&
         isDouble(Operator.getLHS()->getType());
}

// Nothing of E will be reported any more, except calls.
void DoubleCheck::finish(const Expr *E) {
  Done.insert(E);
  if (const auto *Parentheses = dyn_cast<ParenExpr>(E))
    return finish(Parentheses->getSubExpr());
  if (const auto *Cast = dyn_cast<CastExpr>(E))
    return finish(Cast->getSubExpr());
  if (const auto *Unary = dyn_cast<UnaryOperator>(E))
    return finish(Unary->getSubExpr());
  const auto *Binary = dyn_cast<BinaryOperator>(E);
  if (!Binary || !isArithmeticInDouble(*Binary))
    return;
  finish(Binary->getLHS());
  finish(Binary->getRHS());
}

// Names the literals that make the arithmetic E one of double.
void DoubleCheck::noteLiterals(const Expr *E) {
  E = unwrap(E);
  if (const auto *Unary = dyn_cast<UnaryOperator>(E))
    return noteLiterals(Unary->getSubExpr());
  if (const auto *Binary = dyn_cast<BinaryOperator>(E)) {
    noteLiterals(Binary->getLHS());
    return noteLiterals(Binary->getRHS());
  }
  if (!isa<FloatingLiteral>(E) || !isDouble(E->getType()) ||
      E->getBeginLoc().isMacroID())
    return;
  const SourceManager &Sources = Context.getSourceManager();
  StringRef Text =
      Lexer::getSourceText(CharSourceRange::getTokenRange(E->getSourceRange()),
                           Sources, Context.getLangOpts());
  SourceLocation End = Lexer::getLocForEndOfToken(E->getEndLoc(), 0, Sources,
                                                  Context.getLangOpts());
  Reporter.note(E->getBeginLoc(),
                ("a literal in double; '" + Text + "f' is one in float").str(),
                {E->getSourceRange()}, {FixItHint::CreateInsertion(End, "f")});
}

void DoubleCheck::checkBinaryOperator(const BinaryOperator &Operator) {
  if (isDone(Operator) || !isArithmeticInDouble(Operator) ||
      isConstant(Operator))
    return;
  finish(Operator.getLHS());
  finish(Operator.getRHS());
  const std::string Kind =
      Operator.isComparisonOp() ? "comparison" : "arithmetic";
  if (Reporter.warn(FloatingPointWarning::Double, Operator.getOperatorLoc(),
                    Kind + " in double" + InSoftware,
                    {Operator.getSourceRange()}))
    noteLiterals(&Operator);
}

void DoubleCheck::checkUnaryOperator(const UnaryOperator &Operator) {
  if (isDone(Operator) || !Operator.isIncrementDecrementOp() ||
      !isDouble(Operator.getType()))
    return;
  Reporter.warn(FloatingPointWarning::Double, Operator.getOperatorLoc(),
                std::string("arithmetic in double") + InSoftware,
                {Operator.getSourceRange()});
}

// What arithmetic or a call gives needs no second warning where it is
// converted.
static bool isComputed(const Expr *E) {
  return isa<BinaryOperator, CallExpr>(unwrap(E));
}

void DoubleCheck::checkCast(const CastExpr &Cast) {
  const CastKind Kind = Cast.getCastKind();
  if (isDone(Cast) ||
      (Kind != CK_FloatingCast && Kind != CK_IntegralToFloating &&
       Kind != CK_FloatingToIntegral))
    return;
  const Expr &Operand = *Cast.getSubExpr();
  const bool IsFromDouble = isDouble(Operand.getType());
  if (IsFromDouble == isDouble(Cast.getType()) || isConstant(Operand) ||
      (IsFromDouble && isComputed(&Operand)))
    return;
  finish(&Operand);
  Reporter.warn(FloatingPointWarning::Double, Operand.getExprLoc(),
                "conversion from '" + Operand.getType().getAsString() +
                    "' to '" + Cast.getType().getAsString() + "'" + InSoftware,
                {Operand.getSourceRange()});
}

// Floats become doubles there, as the language says.
void DoubleCheck::checkVariableArguments(const CallExpr &Call, unsigned First) {
  for (unsigned I = First; I < Call.getNumArgs(); ++I)
    if (const auto *Cast = dyn_cast<ImplicitCastExpr>(Call.getArg(I)))
      Done.insert(Cast);
}

// The name of the function that does in float what Name does in double; empty
// if there is none.
static std::string nameInFloat(StringRef Name, const ASTContext &Context) {
  const std::string InFloat = (Name + "f").str();
  auto Known = Context.Idents.find(InFloat);
  return Known != Context.Idents.end() && Known->second->getBuiltinID() != 0
             ? InFloat
             : "";
}

void DoubleCheck::checkCall(const CallExpr &Call) {
  const FunctionDecl *Callee = Call.getDirectCallee();
  if (!Callee || Call.isInstantiationDependent())
    return;
  if (Callee->isVariadic())
    return checkVariableArguments(Call, Callee->getNumParams());
  const SourceManager &Sources = Context.getSourceManager();
  const bool IsLibrary =
      Callee->getBuiltinID() != 0 ||
      Sources.isInSystemHeader(Sources.getExpansionLoc(Callee->getLocation()));
  const bool IsInDouble = any_of(Callee->parameters(), [&](const auto *P) {
    return isDouble(P->getType());
  });
  if (!IsLibrary || !IsInDouble || isConstant(Call))
    return;
  for (const Expr *Argument : Call.arguments())
    if (isDouble(Argument->getType()) && !isComputed(Argument))
      finish(Argument);
  StringRef Name = calleeName(Call);
  std::string Message =
      ("'" + Name + "' computes in double" + InSoftware).str();
  if (std::string InFloat = nameInFloat(Name, Context); !InFloat.empty())
    Message += "; '" + InFloat + "' computes in float";
  Reporter.warn(FloatingPointWarning::Double, Call.getBeginLoc(), Message,
                {Call.getSourceRange()});
}

} // namespace tp
