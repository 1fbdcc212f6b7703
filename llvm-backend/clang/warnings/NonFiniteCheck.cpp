//===- NonFiniteCheck.cpp - Infinity and NaN under finite math ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/NonFiniteCheck.h"
#include "llvm-backend/clang/warnings/Expressions.h"
#include "clang/AST/DeclCXX.h"
#include "clang/AST/ExprCXX.h"
#include "clang/Basic/DiagnosticSema.h"
#include "clang/Basic/TargetInfo.h"
#include "llvm/ADT/FloatingPointMode.h"
#include "llvm/ADT/StringSwitch.h"

using namespace clang;
using namespace llvm;

namespace tp {

namespace {

/// What a function makes or asks.
enum class Meaning { None, Infinity, NaN, InfinityTest, NaNTest, FiniteTest };

} // namespace

static bool isMember(const FunctionDecl &Function) {
  return isa<CXXMethodDecl>(Function);
}

static Meaning meaningOfMember(const FunctionDecl &Function) {
  const auto *Class = cast<CXXRecordDecl>(Function.getParent());
  if (!Class->isInStdNamespace() || !Class->getIdentifier() ||
      Class->getName() != "numeric_limits")
    return Meaning::None;
  return StringSwitch<Meaning>(Function.getName())
      .Case("infinity", Meaning::Infinity)
      .Cases({"quiet_NaN", "signaling_NaN"}, Meaning::NaN)
      .Default(Meaning::None);
}

static Meaning meaningOfFunction(StringRef Name) {
  Name.consume_front("__builtin_");
  for (StringRef Prefix : {"inf", "huge_val", "nan", "nans"})
    for (StringRef Suffix : {"", "f", "l", "f16", "f128"})
      if (Name == (Prefix + Suffix).str())
        return Prefix.starts_with("nan") ? Meaning::NaN : Meaning::Infinity;
  return StringSwitch<Meaning>(Name)
      .Cases({"isnan", "isnanf", "isnanl", "isunordered"}, Meaning::NaNTest)
      .Cases({"isinf", "isinff", "isinfl", "isinf_sign"}, Meaning::InfinityTest)
      .Cases({"isfinite", "finite", "finitef", "finitel", "fpclassify"},
             Meaning::FiniteTest)
      .Default(Meaning::None);
}

// The mask of __builtin_isfpclass says what it asks.
static Meaning meaningOfClassTest(const CallExpr &Call,
                                  const ASTContext &Context) {
  Expr::EvalResult Mask;
  if (Call.getNumArgs() != 2 || Call.getArg(1)->isValueDependent() ||
      !Call.getArg(1)->EvaluateAsInt(Mask, Context))
    return Meaning::None;
  uint64_t Classes = Mask.Val.getInt().getZExtValue();
  bool AsksNaN = Classes & fcNan;
  bool AsksInfinity = Classes & fcInf;
  if (AsksNaN && AsksInfinity)
    return Meaning::FiniteTest;
  if (AsksNaN)
    return Meaning::NaNTest;
  return AsksInfinity ? Meaning::InfinityTest : Meaning::None;
}

static Meaning meaningOf(const CallExpr &Call, const ASTContext &Context) {
  const FunctionDecl *Callee = Call.getDirectCallee();
  if (!Callee || !Callee->getIdentifier())
    return Meaning::None;
  if (isMember(*Callee))
    return meaningOfMember(*Callee);
  // A user's own function of such a name may look at the bits.
  const SourceManager &Sources = Context.getSourceManager();
  if (!Callee->getBuiltinID() &&
      !Sources.isInSystemHeader(Sources.getExpansionLoc(Callee->getLocation())))
    return Meaning::None;
  if (Callee->getName() == "__builtin_isfpclass")
    return meaningOfClassTest(Call, Context);
  return meaningOfFunction(Callee->getName());
}

bool NonFiniteCheck::honorsNaNs(const Expr &E) const {
  return !E.getFPFeaturesInEffect(Context.getLangOpts()).getNoHonorNaNs();
}

bool NonFiniteCheck::honorsInfinities(const Expr &E) const {
  return !E.getFPFeaturesInEffect(Context.getLangOpts()).getNoHonorInfs();
}

void NonFiniteCheck::warn(const Expr &E, const Twine &Message) {
  if (!Reporter.warn(FloatingPointWarning::NonFinite, E.getExprLoc(),
                     (Message + " under finite math").str(),
                     E.getSourceRange()) ||
      CureIsTold)
    return;
  CureIsTold = true;
  bool HasPragma = Context.getTargetInfo().hasStrictFP() ||
                   Context.getLangOpts().ExpStrictFP;
  StringRef Pragma = ", or '#pragma float_control(precise, on)' before the "
                     "function,";
  Reporter.note(E.getExprLoc(),
                ("'-fno-finite-math-only' after the flags that imply finite "
                 "math" +
                 (HasPragma ? Pragma : StringRef()) +
                 " makes infinities and NaNs count")
                    .str());
}

void NonFiniteCheck::warnOfValue(const Expr &E, StringRef What) {
  warn(E, What + " has no defined effect");
}

void NonFiniteCheck::warnOfTest(const Expr &E, StringRef What) {
  warn(E, "this test for " + What + " may be folded away");
}

void NonFiniteCheck::checkCall(const CallExpr &Call) {
  Meaning Which = meaningOf(Call, Context);
  if (Which == Meaning::None || Call.isTypeDependent())
    return;
  bool IsValue = Which == Meaning::Infinity || Which == Meaning::NaN;
  if (IsValue ? !isFloatingPoint(&Call)
              : none_of(Call.arguments(), isFloatingPoint))
    return;
  switch (Which) {
  case Meaning::Infinity:
    if (!honorsInfinities(Call))
      warnOfValue(Call, "infinity");
    return;
  case Meaning::NaN:
    if (!honorsNaNs(Call))
      warnOfValue(Call, "NaN");
    return;
  case Meaning::InfinityTest:
    if (!honorsInfinities(Call))
      warnOfTest(Call, "infinity");
    return;
  case Meaning::NaNTest:
    if (!honorsNaNs(Call))
      warnOfTest(Call, "NaN");
    return;
  case Meaning::FiniteTest:
    if (!honorsInfinities(Call) || !honorsNaNs(Call))
      warnOfTest(Call, "infinity and NaN");
    return;
  case Meaning::None:
    return;
  }
}

static bool isSameValue(const Expr *A, const Expr *B,
                        const ASTContext &Context) {
  FoldingSetNodeID IdA, IdB;
  unwrap(A)->Profile(IdA, Context, /*Canonical=*/true);
  unwrap(B)->Profile(IdB, Context, /*Canonical=*/true);
  return IdA == IdB && !A->HasSideEffects(Context);
}

// Whether E is x - x, which is 0 for finite x.
static bool isSelfDifference(const Expr *E, const ASTContext &Context) {
  const auto *Difference = dyn_cast<BinaryOperator>(unwrap(E));
  return Difference && Difference->getOpcode() == BO_Sub &&
         isFloatingPoint(Difference) &&
         isSameValue(Difference->getLHS(), Difference->getRHS(), Context);
}

// Whether Comparison asks whether one side is beyond all finite numbers.
static bool isBeyondLargest(const BinaryOperator &Comparison,
                            const ASTContext &Context) {
  auto IsLargest = [&](const Expr *E, bool IsNegative) {
    auto Value = constantValue(E, Context);
    return Value && Value->isLargest() && Value->isNegative() == IsNegative;
  };
  const Expr *Left = Comparison.getLHS();
  const Expr *Right = Comparison.getRHS();
  switch (Comparison.getOpcode()) {
  case BO_GT:
  case BO_LE:
    return IsLargest(Right, false) || IsLargest(Left, true);
  case BO_LT:
  case BO_GE:
    return IsLargest(Left, false) || IsLargest(Right, true);
  default:
    return false;
  }
}

void NonFiniteCheck::checkComparison(const BinaryOperator &Comparison) {
  const Expr *Left = Comparison.getLHS();
  const Expr *Right = Comparison.getRHS();
  bool HonorsInfinities = honorsInfinities(Comparison);
  bool HonorsNaNs = honorsNaNs(Comparison);
  if ((HonorsInfinities && HonorsNaNs) || !isFloatingPoint(Left) ||
      Left->isTypeDependent() || Right->isTypeDependent())
    return;
  if (Comparison.isEqualityOp() &&
      (isSelfDifference(Left, Context) || isSelfDifference(Right, Context)))
    warnOfTest(Comparison, "infinity and NaN");
  else if (Comparison.isEqualityOp() && !HonorsNaNs &&
           isSameValue(Left, Right, Context))
    warnOfTest(Comparison, "NaN");
  else if (!HonorsInfinities && isBeyondLargest(Comparison, Context))
    warnOfTest(Comparison, "infinity");
}

// Warns if E makes an infinity or a NaN of finite constants.
void NonFiniteCheck::checkConstant(const Expr &E,
                                   ArrayRef<const Expr *> Operands) {
  if ((honorsInfinities(E) && honorsNaNs(E)) || !isFloatingPoint(&E))
    return;
  auto Value = constantValue(&E, Context);
  if (!Value || Value->isFinite() || any_of(Operands, [&](const Expr *Operand) {
        auto OperandValue = constantValue(Operand, Context);
        return OperandValue && !OperandValue->isFinite();
      }))
    return;
  if (Value->isNaN() && !honorsNaNs(E))
    warnOfValue(E, "this constant is NaN, which");
  else if (Value->isInfinity() && !honorsInfinities(E))
    warnOfValue(E, "this constant is infinite, which");
}

void NonFiniteCheck::checkBinaryOperator(const BinaryOperator &Operator) {
  if (Operator.isComparisonOp())
    checkComparison(Operator);
  else if (Operator.isAdditiveOp() || Operator.isMultiplicativeOp())
    checkConstant(Operator, {Operator.getLHS(), Operator.getRHS()});
}

void NonFiniteCheck::checkCast(const CastExpr &Cast) {
  if (Cast.getCastKind() == CK_FloatingCast)
    checkConstant(Cast, Cast.getSubExpr());
}

void NonFiniteCheck::checkLiteral(const FloatingLiteral &Literal) {
  if (Literal.getValue().isInfinity() && !honorsInfinities(Literal) &&
      Context.getDiagnostics().isIgnored(diag::warn_float_overflow,
                                         Literal.getLocation()))
    warnOfValue(Literal, "this constant is infinite, which");
}

} // namespace tp
