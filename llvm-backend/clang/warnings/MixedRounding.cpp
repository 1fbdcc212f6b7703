//===- MixedRounding.cpp - Rounded results of two arguments ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/MixedRounding.h"
#include "llvm-backend/clang/warnings/Expressions.h"
#include "clang/AST/ExprCXX.h"
#include "clang/AST/RecursiveASTVisitor.h"
#include "clang/Basic/TargetInfo.h"
#include "llvm/ADT/DenseMap.h"

using namespace clang;
using namespace llvm;

namespace tp {

namespace {

enum ArgumentMask : unsigned { NoArgument = 0, BothArguments = 3 };

/// What is known of a value in a comparator.
struct Value {
  /// The arguments that it depends on, one bit each.
  unsigned Arguments = NoArgument;
  /// Whether it is a product that the sum it is written in may absorb.
  bool IsProduct = false;
  /// As IsProduct, also through variables and calls.
  bool IsDistantProduct = false;
  bool IsQuotient = false;
  bool IsArithmetic = false;
  /// Whether exchanging the arguments may do more than negate it, if products
  /// are fused. It does not for (a.x - b.x) * n.x + (a.y - b.y) * n.y.
  bool IsAsymmetric = false;
  /// Whether a regrouped sum that it is part of may take a difference of the
  /// arguments apart.
  bool HasDifference = false;
  /// The first hazard in its computation.
  std::optional<MixedRounding> Hazard;

  void join(const Value &Other) {
    Arguments |= Other.Arguments;
    IsProduct |= Other.IsProduct;
    IsDistantProduct |= Other.IsDistantProduct;
    IsQuotient |= Other.IsQuotient;
    IsArithmetic |= Other.IsArithmetic;
    IsAsymmetric |= Other.IsAsymmetric;
    HasDifference |= Other.HasDifference;
    if (!Hazard)
      Hazard = Other.Hazard;
  }
  /// What a variable or a function's result passes on.
  Value fromElsewhere() const {
    Value Result = *this;
    Result.IsProduct = false;
    return Result;
  }
  /// What a function makes of it that is not looked into.
  Value throughFunction() const {
    Value Result;
    Result.Arguments = Arguments;
    Result.IsAsymmetric = Arguments != NoArgument;
    Result.Hazard = Hazard;
    return Result;
  }
};

/// Follows values through one call of a function. The statements are met in
/// the order of the source; a variable holds all it has been assigned so far.
class Evaluator : public RecursiveASTVisitor<Evaluator> {
public:
  Evaluator(ASTContext &Context, const ContractionRules &Rules,
            const FunctionDecl &Function, ArrayRef<Value> Arguments,
            const Value &Object, Evaluator *Caller)
      : Context(Context), Rules(Rules), Function(Function), Object(Object),
        Caller(Caller), Depth(Caller ? Caller->Depth + 1 : 0),
        CallsLeft(Caller ? Caller->CallsLeft : OwnCallsLeft) {
    for (auto [Parameter, Argument] : zip(Function.parameters(), Arguments))
      Variables[Parameter] = Argument;
  }

  void run() { TraverseStmt(Function.getBody()); }

  /// The first hazard whose result decides something.
  const std::optional<MixedRounding> &decisive() const { return Decisive; }
  const Value &result() const { return Result; }

  bool VisitVarDecl(VarDecl *Variable) {
    if (Variable->getInit())
      Variables[Variable].join(evaluate(Variable->getInit()).fromElsewhere());
    return true;
  }
  bool VisitReturnStmt(ReturnStmt *Return) {
    if (Return->getRetValue())
      Result.join(evaluate(Return->getRetValue()).fromElsewhere());
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *Operator);
  bool VisitCastExpr(CastExpr *Cast) {
    CastKind Kind = Cast->getCastKind();
    if (Kind == CK_FloatingToIntegral || Kind == CK_FloatingToBoolean)
      decide(evaluate(Cast->getSubExpr()));
    return true;
  }
  bool VisitCallExpr(CallExpr *Call) {
    // Its own comparisons decide too.
    evaluate(Call);
    return true;
  }
  /// Its body runs when it is called.
  bool TraverseLambdaExpr(LambdaExpr *) { return true; }

private:
  /// What is deeper or comes later counts as opaque.
  static constexpr unsigned MaxDepth = 4;
  static constexpr unsigned MaxCalls = 256;

  Value evaluate(const Expr *E);
  Value valueOf(const VarDecl *Variable) const;
  Value evaluateOperator(const BinaryOperator &Operator);
  Value evaluateCall(const CallExpr &Call);
  Value enterCall(const CallExpr &Call);
  Value evaluateOperands(const Stmt &S);
  bool isAsymmetric(const BinaryOperator &Operator, BinaryOperatorKind Opcode,
                    const Value &Left, const Value &Right) const;
  std::optional<MixedRounding::Cause> causeOf(const BinaryOperator &Operator,
                                              const Value &Left,
                                              const Value &Right) const;
  bool mayFuse(const BinaryOperator &Operator, const Value &Left,
               const Value &Right) const;
  bool hasFusedInstructions() const;
  bool isRunning(const FunctionDecl *Callee) const;
  void decide(const Value &V) {
    if (!Decisive)
      Decisive = V.Hazard;
  }

  ASTContext &Context;
  const ContractionRules &Rules;
  const FunctionDecl &Function;
  const Value Object;
  const Evaluator *const Caller;
  const unsigned Depth;
  unsigned OwnCallsLeft = MaxCalls;
  unsigned &CallsLeft;
  DenseMap<const VarDecl *, Value> Variables;
  DenseMap<const CallExpr *, Value> Calls;
  Value Result;
  std::optional<MixedRounding> Decisive;
};

} // namespace

bool Evaluator::hasFusedInstructions() const {
  switch (Context.getTargetInfo().getTriple().getArch()) {
  case Triple::aarch64:
  case Triple::aarch64_be:
  case Triple::aarch64_32:
  case Triple::ppc:
  case Triple::ppcle:
  case Triple::ppc64:
  case Triple::ppc64le:
  case Triple::systemz:
  case Triple::amdgcn:
  case Triple::nvptx:
  case Triple::nvptx64:
    return true;
  default:
    break;
  }
  StringMap<bool> Features;
  Context.getFunctionFeatureMap(Features, &Function);
  bool IsRiscV = Context.getTargetInfo().getTriple().isRISCV();
  return Features.lookup("fma") || Features.lookup("fma4") ||
         Features.lookup("vfp4") || (IsRiscV && Features.lookup("f"));
}

bool Evaluator::mayFuse(const BinaryOperator &Operator, const Value &Left,
                        const Value &Right) const {
  FPOptions Options = Operator.getFPFeaturesInEffect(Context.getLangOpts());
  bool Across = Options.allowFPContractAcrossStatement();
  if (!Across && !Options.allowFPContractWithinStatement())
    return false;
  bool LeftIsProduct = Across ? Left.IsDistantProduct : Left.IsProduct;
  bool RightIsProduct = Across ? Right.IsDistantProduct : Right.IsProduct;
  if (!LeftIsProduct && !RightIsProduct)
    return false;
  bool IsDifference =
      Operator.getOpcode() == BO_Sub || Operator.getOpcode() == BO_SubAssign;
  if (Rules.IsCanonical && IsDifference && LeftIsProduct && RightIsProduct)
    return false;
  return hasFusedInstructions();
}

std::optional<MixedRounding::Cause>
Evaluator::causeOf(const BinaryOperator &Operator, const Value &Left,
                   const Value &Right) const {
  if ((Left.Arguments | Right.Arguments) != BothArguments)
    return std::nullopt;
  bool IsAsymmetric = Left.IsAsymmetric || Right.IsAsymmetric;
  if (!IsAsymmetric && !Left.HasDifference && !Right.HasDifference)
    return std::nullopt;
  if (IsAsymmetric && mayFuse(Operator, Left, Right))
    return MixedRounding::Cause::Contraction;
  FPOptions Options = Operator.getFPFeaturesInEffect(Context.getLangOpts());
  if (Options.getAllowFPReassociate() &&
      (Left.IsArithmetic || Right.IsArithmetic))
    return MixedRounding::Cause::Reassociation;
  if (Options.getAllowReciprocal() && (Left.IsQuotient || Right.IsQuotient))
    return MixedRounding::Cause::Reciprocal;
  return std::nullopt;
}

// Whether exchanging the arguments may do more than negate the result.
bool Evaluator::isAsymmetric(const BinaryOperator &Operator,
                             BinaryOperatorKind Opcode, const Value &Left,
                             const Value &Right) const {
  // a.x - b.x
  const auto *LeftMember = dyn_cast<MemberExpr>(unwrap(Operator.getLHS()));
  const auto *RightMember = dyn_cast<MemberExpr>(unwrap(Operator.getRHS()));
  if (Opcode == BO_Sub && LeftMember && RightMember &&
      LeftMember->getMemberDecl() == RightMember->getMemberDecl() &&
      !Left.IsArithmetic && !Right.IsArithmetic &&
      (Left.Arguments | Right.Arguments) == BothArguments &&
      (Left.Arguments & Right.Arguments) == NoArgument)
    return false;
  bool BothDepend =
      Left.Arguments != NoArgument && Right.Arguments != NoArgument;
  return Left.IsAsymmetric || Right.IsAsymmetric ||
         BothDepend != isAdditive(Opcode);
}

Value Evaluator::evaluateOperator(const BinaryOperator &Operator) {
  Value Left = evaluate(Operator.getLHS());
  Value Right = evaluate(Operator.getRHS());
  BinaryOperatorKind Opcode = Operator.getOpcode();
  if (Opcode == BO_Comma || Opcode == BO_Assign)
    return Right;
  if (Operator.isCompoundAssignmentOp())
    Opcode = BinaryOperator::getOpForCompoundAssignment(Opcode);
  Value Joined = Left.throughFunction();
  Joined.join(Right.throughFunction());
  bool IsProduct = Opcode == BO_Mul;
  bool IsQuotient = Opcode == BO_Div;
  if (!isFloatingPoint(&Operator) ||
      !(isAdditive(Opcode) || IsProduct || IsQuotient))
    return Joined;
  if (isAdditive(Opcode) && !Joined.Hazard)
    if (auto Cause = causeOf(Operator, Left, Right))
      Joined.Hazard = MixedRounding{&Operator, &Function, *Cause};
  Joined.IsArithmetic = true;
  Joined.IsProduct = Joined.IsDistantProduct = IsProduct;
  Joined.IsQuotient = IsQuotient;
  Joined.HasDifference =
      isAdditive(Opcode) && (Left.HasDifference || Right.HasDifference ||
                             !Left.IsArithmetic || !Right.IsArithmetic);
  Joined.IsAsymmetric = isAsymmetric(Operator, Opcode, Left, Right);
  return Joined;
}

bool Evaluator::isRunning(const FunctionDecl *Callee) const {
  for (const Evaluator *Frame = this; Frame; Frame = Frame->Caller)
    if (&Frame->Function == Callee)
      return true;
  return false;
}

Value Evaluator::evaluateCall(const CallExpr &Call) {
  if (auto Known = Calls.find(&Call); Known != Calls.end())
    return Known->second;
  Value Entered = enterCall(Call);
  Calls[&Call] = Entered;
  return Entered;
}

Value Evaluator::enterCall(const CallExpr &Call) {
  Value CalledObject;
  SmallVector<Value, 4> Arguments;
  for (const Expr *Argument : Call.arguments())
    Arguments.push_back(evaluate(Argument).fromElsewhere());
  if (const auto *Member = dyn_cast<CXXMemberCallExpr>(&Call))
    CalledObject = evaluate(Member->getImplicitObjectArgument());
  const FunctionDecl *Callee = calledDefinition(Call, Context);
  if (!Callee || Depth == MaxDepth || CallsLeft == 0 || isRunning(Callee)) {
    Value Joined = CalledObject.throughFunction();
    for (const Value &Argument : Arguments)
      Joined.join(Argument.throughFunction());
    // As signbit() and lround() do.
    if (Call.getType()->isIntegerType())
      decide(Joined);
    return Joined;
  }
  const auto *Method = dyn_cast<CXXMethodDecl>(Callee);
  if (isa<CXXOperatorCallExpr>(Call) && Method &&
      !Method->isExplicitObjectMemberFunction() && !Arguments.empty()) {
    CalledObject = Arguments.front();
    Arguments.erase(Arguments.begin());
  }
  --CallsLeft;
  Evaluator Frame(Context, Rules, *Callee, Arguments, CalledObject, this);
  Frame.run();
  if (Frame.decisive() && !Decisive)
    Decisive = Frame.decisive();
  return Frame.result();
}

// The values that S is put together from, as an object of its members.
Value Evaluator::evaluateOperands(const Stmt &S) {
  Value Joined;
  for (const Stmt *Child : S.children())
    if (const auto *Operand = dyn_cast_or_null<Expr>(Child))
      Joined.join(evaluate(Operand).fromElsewhere());
  return Joined;
}

// A lambda may read the variables of its callers.
Value Evaluator::valueOf(const VarDecl *Variable) const {
  for (const Evaluator *Frame = this; Frame; Frame = Frame->Caller)
    if (auto Known = Frame->Variables.find(Variable);
        Known != Frame->Variables.end())
      return Known->second;
  return Value();
}

Value Evaluator::evaluate(const Expr *E) {
  E = unwrapFloatingPoint(E);
  if (const auto *Operator = dyn_cast<BinaryOperator>(E))
    return evaluateOperator(*Operator);
  if (const auto *Call = dyn_cast<CallExpr>(E))
    return evaluateCall(*Call);
  if (isa<CXXThisExpr>(E))
    return Object;
  if (const auto *Reference = dyn_cast<DeclRefExpr>(E)) {
    // What a structured binding names.
    if (const auto *Binding = dyn_cast<BindingDecl>(Reference->getDecl()))
      return Binding->getBinding() ? evaluate(Binding->getBinding()) : Value();
    return valueOf(dyn_cast<VarDecl>(Reference->getDecl()));
  }
  if (const auto *Unary = dyn_cast<UnaryOperator>(E))
    return evaluate(Unary->getSubExpr());
  if (const auto *Member = dyn_cast<MemberExpr>(E))
    return evaluate(Member->getBase());
  if (const auto *Cast = dyn_cast<CastExpr>(E)) {
    Value Inner = evaluate(Cast->getSubExpr());
    return isFloatingPoint(E) ? Inner.throughFunction() : Inner;
  }
  if (isa<LambdaExpr, UnaryExprOrTypeTraitExpr>(E))
    return Value();
  return evaluateOperands(*E);
}

bool Evaluator::VisitBinaryOperator(BinaryOperator *Operator) {
  if (Operator->isComparisonOp()) {
    if (isFloatingPoint(Operator->getLHS())) {
      decide(evaluate(Operator->getLHS()));
      decide(evaluate(Operator->getRHS()));
    }
    return true;
  }
  if (!Operator->isAssignmentOp())
    return true;
  if (const VarDecl *Variable = namedVariable(Operator->getLHS())) {
    Value Assigned = evaluateOperator(*Operator).fromElsewhere();
    Variables[Variable].join(Assigned);
  }
  return true;
}

std::optional<MixedRounding> findMixedRounding(const FunctionDecl &Comparator,
                                               ASTContext &Context,
                                               const ContractionRules &Rules) {
  Value First, Second, Object;
  First.Arguments = 1;
  Second.Arguments = 2;
  First.IsAsymmetric = Second.IsAsymmetric = true;
  SmallVector<Value, 2> Arguments{First, Second};
  // A member operator compares its object with its argument.
  if (Comparator.getNumParams() == 1) {
    Object = First;
    Arguments = {Second};
  }
  Evaluator Frame(Context, Rules, Comparator, Arguments, Object,
                  /*Caller=*/nullptr);
  Frame.run();
  return Frame.decisive();
}

} // namespace tp
