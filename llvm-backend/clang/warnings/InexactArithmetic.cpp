//===- InexactArithmetic.cpp - What fast math rounds otherwise ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/InexactArithmetic.h"
#include "llvm-backend/clang/warnings/Expressions.h"
#include "clang/AST/ExprCXX.h"
#include "llvm/ADT/StringSwitch.h"

using namespace clang;
using namespace llvm;

namespace tp {

// The argument of a function such as floor, which rounds it or drops its sign;
// null if E is no such call.
static const Expr *roundedArgument(const Expr *E) {
  const auto *Call = dyn_cast<CallExpr>(E);
  if (!Call || Call->getNumArgs() != 1)
    return nullptr;
  StringRef Name = calleeName(*Call);
  Name.consume_front("__builtin_");
  Name.consume_back("f");
  bool Rounds = StringSwitch<bool>(Name)
                    .Cases({"floor", "ceil", "round", "trunc", "rint",
                            "nearbyint", "fabs", "abs"},
                           true)
                    .Default(false);
  return Rounds ? Call->getArg(0) : nullptr;
}

bool InexactArithmetic::isConstant(const Expr *E) const {
  return constantValue(E, Context).has_value();
}

bool InexactArithmetic::isSimple(const Expr *E) const {
  E = unwrapFloatingPoint(E);
  return isa<DeclRefExpr, MemberExpr>(E) || !isFloatingPoint(E) ||
         isConstant(E) ||
         (isa<ExplicitCastExpr>(E) &&
          !isFloatingPoint(cast<ExplicitCastExpr>(E)->getSubExpr()));
}

bool InexactArithmetic::isBounded(const Expr *Value) {
  Entered.clear();
  return isBoundedIn(Value);
}

bool InexactArithmetic::isBoundedIn(const Expr *Value) {
  Value = unwrapFloatingPoint(Value);
  if (isa<AbstractConditionalOperator>(Value))
    return true;
  if (const Expr *Argument = roundedArgument(Value))
    return isBoundedIn(Argument);
  if (const auto *Call = dyn_cast<CallExpr>(Value))
    return isBoundingCall(*Call);
  if (const auto *Operator = dyn_cast<BinaryOperator>(Value)) {
    const Expr *Left = Operator->getLHS();
    const Expr *Right = Operator->getRHS();
    if (Operator->getOpcode() == BO_Div)
      return isSimple(Right) && isBoundedIn(Left);
    return (isSimple(Right) && isBoundedIn(Left)) ||
           (isSimple(Left) && isBoundedIn(Right));
  }
  const VarDecl *Variable = namedVariable(Value);
  if (!Variable || !Entered.insert(Variable).second)
    return false;
  return Facts.isExamined(Variable) ||
         any_of(Facts.valuesOf(Variable),
                [&](const Expr *Assigned) { return isBoundedIn(Assigned); });
}

const BinaryOperator *InexactArithmetic::findInexact(const Expr *Value) {
  Entered.clear();
  return findIn(Value, /*User=*/nullptr);
}

static BinaryOperatorKind plainOpcode(const BinaryOperator &Operator) {
  return Operator.isCompoundAssignmentOp()
             ? BinaryOperator::getOpForCompoundAssignment(Operator.getOpcode())
             : Operator.getOpcode();
}

// Whether Operator multiplies by a power of two, which rounds nothing.
bool InexactArithmetic::isExactScaling(const BinaryOperator &Operator) const {
  auto IsPowerOfTwo = [&](const Expr *E) {
    auto Factor = constantValue(E, Context);
    return Factor && Factor->getExactInverse(nullptr);
  };
  return (plainOpcode(Operator) == BO_Div && IsPowerOfTwo(Operator.getRHS())) ||
         (plainOpcode(Operator) == BO_Mul &&
          (IsPowerOfTwo(Operator.getLHS()) || IsPowerOfTwo(Operator.getRHS())));
}

bool InexactArithmetic::mayUseReciprocal(const BinaryOperator &Operator) const {
  FPOptions Options = Operator.getFPFeaturesInEffect(Context.getLangOpts());
  if (plainOpcode(Operator) != BO_Div || !Options.getAllowReciprocal())
    return false;
  auto Dividend = constantValue(Operator.getLHS(), Context);
  return !Dividend || !Dividend->isExactlyValue(1.0);
}

// Whether fast math may compute Operator, or it together with User which takes
// its result, in a way that rounds otherwise.
bool InexactArithmetic::isInexact(const BinaryOperator &Operator,
                                  const BinaryOperator *User) const {
  if (isExactScaling(Operator))
    return false;
  const LangOptions &Language = Context.getLangOpts();
  FPOptions Options = Operator.getFPFeaturesInEffect(Language);
  if (mayUseReciprocal(Operator))
    return true;
  if (!User || isExactScaling(*User) || !Options.getAllowFPReassociate() ||
      !User->getFPFeaturesInEffect(Language).getAllowFPReassociate())
    return false;
  if (isAdditive(plainOpcode(Operator)) == isAdditive(plainOpcode(*User)))
    return true;
  // (x - Constant) * Factor is x * Factor - Product, with constants.
  return isAdditive(plainOpcode(Operator)) &&
         (isConstant(Operator.getLHS()) || isConstant(Operator.getRHS())) &&
         (isConstant(User->getLHS()) || isConstant(User->getRHS()));
}

const BinaryOperator *InexactArithmetic::findIn(const Expr *Value,
                                                const BinaryOperator *User) {
  Value = unwrapFloatingPoint(Value);
  if (!isFloatingPoint(Value))
    return nullptr;
  if (const Expr *Argument = roundedArgument(Value))
    return findIn(Argument, /*User=*/nullptr);
  if (const auto *Unary = dyn_cast<UnaryOperator>(Value))
    return Unary->isArithmeticOp() ? findIn(Unary->getSubExpr(), User)
                                   : nullptr;
  if (const auto *Operator = dyn_cast<BinaryOperator>(Value)) {
    if (Operator->isAssignmentOp() && !Operator->isCompoundAssignmentOp())
      return findIn(Operator->getRHS(), User);
    BinaryOperatorKind Opcode = plainOpcode(*Operator);
    if (!isAdditive(Opcode) && !BinaryOperator::isMultiplicativeOp(Opcode))
      return nullptr;
    if (isConstant(Operator))
      return nullptr;
    if (isInexact(*Operator, User))
      return Operator;
    if (const BinaryOperator *Found = findIn(Operator->getLHS(), Operator))
      return Found;
    return findIn(Operator->getRHS(), Operator);
  }
  const VarDecl *Variable = namedVariable(Value);
  if (!Variable || !Entered.insert(Variable).second)
    return nullptr;
  for (const Expr *Assigned : Facts.valuesOf(Variable))
    if (const BinaryOperator *Found = findIn(Assigned, User))
      return Found;
  return nullptr;
}

} // namespace tp
