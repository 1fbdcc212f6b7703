//===- VariableFacts.cpp - What a function does to its variables ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/VariableFacts.h"
#include "llvm-backend/clang/warnings/Expressions.h"
#include "clang/AST/RecursiveASTVisitor.h"

using namespace clang;
using namespace llvm;

namespace tp {

bool isBoundingCall(const CallExpr &Call) {
  std::string LowerCase = calleeName(Call).lower();
  StringRef Name = LowerCase;
  Name.consume_front("__builtin_");
  for (StringRef Part : {"clamp", "saturate", "remainder", "wrap"})
    if (Name.contains(Part))
      return true;
  // fminf, imax, minimum, fmod, ...
  for (StringRef TypePrefix : {"", "f", "i", "u"})
    for (StringRef Start : {"min", "max", "mod"})
      if (Name.starts_with((TypePrefix + Start).str()))
        return true;
  return false;
}

/// Whether Operator selects an element where a wrong index does harm. A map
/// finds or makes an element for each key.
static bool isElementAccess(const CXXOperatorCallExpr &Operator) {
  if (Operator.getOperator() != OO_Subscript || Operator.getNumArgs() != 2)
    return false;
  const auto *Class = Operator.getArg(0)->getType()->getAsCXXRecordDecl();
  return !Class || !Class->getIdentifier() ||
         !Class->getName().contains_insensitive("map");
}

class VariableFacts::Collector : public RecursiveASTVisitor<Collector> {
public:
  explicit Collector(VariableFacts &Facts) : Facts(Facts) {}

  bool shouldVisitTemplateInstantiations() const { return true; }

  bool VisitVarDecl(VarDecl *Variable) {
    if (Variable->getInit())
      addValue(Variable, Variable->getInit());
    return true;
  }
  bool VisitReturnStmt(ReturnStmt *Return) {
    if (Return->getRetValue() && LambdaDepth == 0)
      Facts.Returned.push_back(Return->getRetValue());
    return true;
  }
  bool TraverseLambdaExpr(LambdaExpr *Lambda) {
    ++LambdaDepth;
    bool Continue = RecursiveASTVisitor::TraverseLambdaExpr(Lambda);
    --LambdaDepth;
    return Continue;
  }
  bool VisitBinaryOperator(BinaryOperator *Operator);
  bool VisitUnaryOperator(UnaryOperator *Operator) {
    if (Operator->getOpcode() == UO_AddrOf)
      examine(namedVariable(Operator->getSubExpr()));
    return true;
  }
  bool VisitArraySubscriptExpr(ArraySubscriptExpr *Element) {
    Facts.Indexes.push_back(Element->getIdx());
    return true;
  }
  bool VisitSwitchStmt(SwitchStmt *Switch) {
    examineAll(Switch->getCond());
    return true;
  }
  bool VisitIfStmt(IfStmt *If) {
    if (If->getCond())
      examineArguments(If->getCond());
    return true;
  }
  bool VisitConditionalOperator(ConditionalOperator *Choice) {
    examineArguments(Choice->getCond());
    return true;
  }
  bool VisitCallExpr(CallExpr *Call);

private:
  void addValue(const VarDecl *Variable, const Expr *Value) {
    Facts.Values[Variable].push_back(Value);
  }
  void examine(const VarDecl *Variable) {
    if (Variable)
      Facts.Examined.insert(Variable);
  }
  void examineAll(const Stmt *S);
  void examineArguments(const Stmt *S);

  VariableFacts &Facts;
  unsigned LambdaDepth = 0;
};

// Examines the variables in S, but for those that only select an element in it.
void VariableFacts::Collector::examineAll(const Stmt *S) {
  if (!S || isa<LambdaExpr>(S))
    return;
  if (const auto *Element = dyn_cast<ArraySubscriptExpr>(S))
    return examineAll(Element->getBase());
  if (const auto *Operator = dyn_cast<CXXOperatorCallExpr>(S);
      Operator && isElementAccess(*Operator))
    return examineAll(Operator->getArg(0));
  if (const auto *Reference = dyn_cast<DeclRefExpr>(S))
    examine(dyn_cast<VarDecl>(Reference->getDecl()));
  for (const Stmt *Child : S->children())
    examineAll(Child);
}

// Examines what functions get that a condition calls.
void VariableFacts::Collector::examineArguments(const Stmt *S) {
  if (!S || isa<LambdaExpr>(S))
    return;
  if (const auto *Operator = dyn_cast<CXXOperatorCallExpr>(S);
      Operator && isElementAccess(*Operator))
    return;
  if (const auto *Call = dyn_cast<CallExpr>(S))
    for (const Expr *Argument : Call->arguments())
      examineAll(Argument);
  for (const Stmt *Child : S->children())
    examineArguments(Child);
}

bool VariableFacts::Collector::VisitBinaryOperator(BinaryOperator *Operator) {
  const Expr *Left = Operator->getLHS();
  const Expr *Right = Operator->getRHS();
  if (Operator->isComparisonOp()) {
    // `x != x` and `x == 0` say nothing of how large x is.
    if (Operator->isEqualityOp() && isFloatingPoint(Left))
      return true;
    examineAll(Left);
    examineAll(Right);
    return true;
  }
  if (Operator->isAdditiveOp() && Operator->getType()->isPointerType()) {
    Facts.Indexes.push_back(Left->getType()->isPointerType() ? Right : Left);
    return true;
  }
  if (!Operator->isAssignmentOp())
    return true;
  if (Operator->isCompoundAssignmentOp() && Left->getType()->isPointerType())
    Facts.Indexes.push_back(Right);
  const VarDecl *Variable = namedVariable(Left);
  if (!Variable)
    return true;
  switch (Operator->getOpcode()) {
  case BO_RemAssign:
  case BO_AndAssign:
    examine(Variable);
    break;
  case BO_Assign:
    addValue(Variable, Right);
    break;
  default:
    // The operation itself: what it computes is the variable's new value.
    addValue(Variable, Operator);
    break;
  }
  return true;
}

bool VariableFacts::Collector::VisitCallExpr(CallExpr *Call) {
  if (const auto *Operator = dyn_cast<CXXOperatorCallExpr>(Call)) {
    if (isElementAccess(*Operator))
      Facts.Indexes.push_back(Operator->getArg(1));
    return true;
  }
  if (isBoundingCall(*Call)) {
    for (const Expr *Argument : Call->arguments())
      examineAll(Argument);
    return true;
  }
  const FunctionDecl *Callee = Call->getDirectCallee();
  if (!Callee)
    return true;
  // What a function gets by reference it may write.
  for (auto [Parameter, Argument] :
       zip(Callee->parameters(), Call->arguments())) {
    QualType Type = Parameter->getType();
    if (Type->isLValueReferenceType() &&
        !Type.getNonReferenceType().isConstQualified())
      examine(namedVariable(Argument));
  }
  return true;
}

VariableFacts::VariableFacts(const Stmt &Body) {
  Collector(*this).TraverseStmt(const_cast<Stmt *>(&Body));
}

ArrayRef<const Expr *> VariableFacts::valuesOf(const VarDecl *Variable) const {
  auto Known = Values.find(Variable);
  return Known == Values.end() ? ArrayRef<const Expr *>()
                               : ArrayRef<const Expr *>(Known->second);
}

} // namespace tp
