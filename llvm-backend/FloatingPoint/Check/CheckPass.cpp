//===- CheckPass.cpp - Traps on invalid floating-point values -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckPass.h"
#include "llvm-backend/FloatingPoint/Check/CheckOperations.h"
#include "llvm-backend/FloatingPoint/Check/CheckPromises.h"
#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"

using namespace llvm;
using tp::CheckKind;
using tp::CheckOperation;

namespace {

/// Inserts the checks of one function.
class FunctionChecker {
public:
  FunctionChecker(Function &F, CheckEmitter &Emitter)
      : F(F), Emitter(Emitter) {}

  void run();

private:
  using Condition = function_ref<Value *(IRBuilderBase &, CheckedValues)>;

  void check(Instruction &I);
  void checkConversion(Instruction &I, IntegerConversion Conversion);
  void checkComparison(Instruction &I, CmpInst::Predicate Predicate);
  void checkArguments(CallBase &Call);
  void checkReturnedValue(ReturnInst &Return);
  void checkOperands(Instruction &I, NonFinite RuledOut);
  void checkResult(Instruction &I, NonFinite RuledOut);
  void failIf(IRBuilderBase &Builder, CheckKind Kind, CheckOperation Operation,
              CheckedValues Values, Condition Failed);

  Function &F;
  CheckEmitter &Emitter;
};

} // namespace

static bool isCheckable(const Type *Ty) {
  if (auto *Vector = dyn_cast<FixedVectorType>(Ty))
    Ty = Vector->getElementType();
  return isCheckableScalar(Ty);
}

/// Element \p Lane of a vector, a scalar itself, nothing of nothing.
static Value *laneOf(IRBuilderBase &Builder, Value *V, unsigned Lane) {
  if (!V || !V->getType()->isVectorTy())
    return V;
  return Builder.CreateExtractElement(V, Lane);
}

void FunctionChecker::failIf(IRBuilderBase &Builder, CheckKind Kind,
                             CheckOperation Operation, CheckedValues Values,
                             Condition Failed) {
  Type *Ty = (Values.Result ? Values.Result : Values.First)->getType();
  if (!isCheckable(Ty))
    return;
  auto *Vector = dyn_cast<FixedVectorType>(Ty);
  for (unsigned Lane : seq(Vector ? Vector->getNumElements() : 1)) {
    CheckedValues Scalars{laneOf(Builder, Values.Result, Lane),
                          laneOf(Builder, Values.First, Lane),
                          laneOf(Builder, Values.Second, Lane)};
    Emitter.failIf(Builder, Failed(Builder, Scalars), Kind, Operation, Scalars);
  }
}

void FunctionChecker::checkConversion(Instruction &I,
                                      IntegerConversion Conversion) {
  IRBuilder<> Builder(&I);
  failIf(Builder, CheckKind::Conversion, describeConversion(Conversion),
         {/*Result=*/nullptr, I.getOperand(0)},
         [&](IRBuilderBase &Builder, CheckedValues Values) {
           return isOutOfRange(Builder, Values.First, Conversion);
         });
}

//===----------------------------------------------------------------------===//
// Comparisons
//===----------------------------------------------------------------------===//

/// Whether \p A and \p B are one variable, read twice in one expression. At the
/// start of the pipeline each use of a variable is a load.
static bool isSameVariable(const Value *A, const Value *B) {
  if (A == B)
    return true;
  auto *First = dyn_cast<Instruction>(A), *Second = dyn_cast<Instruction>(B);
  if (!First || !Second || !First->isSameOperationAs(Second) ||
      First->getParent() != Second->getParent())
    return false;
  if (!isa<LoadInst, GetElementPtrInst, CastInst>(First) || First->isVolatile())
    return false;
  if (Second->comesBefore(First))
    std::swap(First, Second);
  if (isa<LoadInst>(First))
    for (const Instruction *I = First; I != Second; I = I->getNextNode())
      if (I->mayWriteToMemory())
        return false;
  return all_of(zip(First->operands(), Second->operands()),
                [](const auto &Pair) {
                  return isSameVariable(std::get<0>(Pair), std::get<1>(Pair));
                });
}

/// Whether the comparison is there to find NaNs: `x != x`, `isunordered(x, y)`.
static bool isTestForNaN(CmpInst::Predicate Predicate, const Value *Left,
                         const Value *Right) {
  switch (Predicate) {
  case CmpInst::FCMP_FALSE:
  case CmpInst::FCMP_TRUE:
  case CmpInst::FCMP_ORD:
  case CmpInst::FCMP_UNO:
    return true;
  case CmpInst::FCMP_OEQ:
  case CmpInst::FCMP_UNE:
    return isSameVariable(Left, Right);
  default:
    return false;
  }
}

void FunctionChecker::checkComparison(Instruction &I,
                                      CmpInst::Predicate Predicate) {
  Value *Left = I.getOperand(0), *Right = I.getOperand(1);
  constexpr NonFinite NaN{/*NaN=*/true, /*Infinity=*/false};
  bool LeftIsNumber = isCheckedBefore(Left, NaN);
  bool RightIsNumber = isCheckedBefore(Right, NaN);
  if (isTestForNaN(Predicate, Left, Right) || (LeftIsNumber && RightIsNumber))
    return;
  IRBuilder<> Builder(&I);
  failIf(Builder, CheckKind::Comparison, describeComparison(Predicate),
         {/*Result=*/nullptr, Left, Right},
         [&](IRBuilderBase &Builder, CheckedValues Values) -> Value * {
           if (LeftIsNumber)
             return isNonFinite(Builder, Values.Second, NaN);
           Value *IsNaN = isNonFinite(Builder, Values.First, NaN);
           if (RightIsNumber)
             return IsNaN;
           return Builder.CreateOr(IsNaN,
                                   isNonFinite(Builder, Values.Second, NaN));
         });
}

//===----------------------------------------------------------------------===//
// Promises of fast math
//===----------------------------------------------------------------------===//

void FunctionChecker::checkArguments(CallBase &Call) {
  if (isa<IntrinsicInst>(Call))
    return;
  NonFinite ByFlags = ruledOutBy(Call);
  IRBuilder<> Builder(&Call);
  for (unsigned Number : seq(Call.arg_size())) {
    Value *Argument = Call.getArgOperand(Number);
    NonFinite RuledOut =
        ByFlags | ruledOutBy(Call.getAttributes().getParamAttrs(Number));
    if (!RuledOut.any() || !Argument->getType()->isFPOrFPVectorTy() ||
        isCheckedBefore(Argument, RuledOut))
      continue;
    failIf(Builder, CheckKind::Consumed, CheckOperation::Argument,
           {/*Result=*/nullptr, Argument},
           [&](IRBuilderBase &Builder, CheckedValues Values) {
             return isNonFinite(Builder, Values.First, RuledOut);
           });
  }
}

void FunctionChecker::checkReturnedValue(ReturnInst &Return) {
  Value *Returned = Return.getReturnValue();
  NonFinite RuledOut = ruledOutBy(F.getAttributes().getRetAttrs());
  if (!Returned || !RuledOut.any() ||
      Return.getParent()->getTerminatingMustTailCall() ||
      isCheckedBefore(Returned, RuledOut))
    return;
  IRBuilder<> Builder(&Return);
  failIf(Builder, CheckKind::Consumed, CheckOperation::ReturnedValue,
         {/*Result=*/nullptr, Returned},
         [&](IRBuilderBase &Builder, CheckedValues Values) {
           return isNonFinite(Builder, Values.First, RuledOut);
         });
}

void FunctionChecker::checkOperands(Instruction &I, NonFinite RuledOut) {
  auto [Operation, Values] = describeOperation(I);
  SmallVector<Value *, 2> Operands = operandsToCheck(I, RuledOut);
  bool ChecksFirst = is_contained(Operands, Values.First);
  bool ChecksSecond = is_contained(Operands, Values.Second);
  if (!ChecksFirst && !ChecksSecond)
    return;
  IRBuilder<> Builder(&I);
  failIf(Builder, CheckKind::Consumed, Operation, Values,
         [&](IRBuilderBase &Builder, CheckedValues Values) -> Value * {
           if (!ChecksFirst)
             return isNonFinite(Builder, Values.Second, RuledOut);
           Value *Failed = isNonFinite(Builder, Values.First, RuledOut);
           if (!ChecksSecond || Values.First == Values.Second)
             return Failed;
           return Builder.CreateOr(
               Failed, isNonFinite(Builder, Values.Second, RuledOut));
         });
}

void FunctionChecker::checkResult(Instruction &I, NonFinite RuledOut) {
  auto *Call = dyn_cast<CallBase>(&I);
  if (!isResultToCheck(I, RuledOut) || (Call && Call->isMustTailCall()))
    return;
  std::optional<BasicBlock::iterator> Behind = I.getInsertionPointAfterDef();
  if (!Behind)
    return;
  auto [Operation, Values] = describeOperation(I);
  Values.Result = &I;
  bool IsChosen = Operation == CheckOperation::SelectedValue;
  IRBuilder<> Builder((*Behind)->getParent(), *Behind);
  Builder.SetCurrentDebugLocation(I.getDebugLoc());
  failIf(Builder, IsChosen ? CheckKind::Consumed : CheckKind::Produced,
         Operation, Values, [&](IRBuilderBase &Builder, CheckedValues Values) {
           return isNonFinite(Builder, Values.Result, RuledOut);
         });
}

//===----------------------------------------------------------------------===//
// The function as a whole
//===----------------------------------------------------------------------===//

void FunctionChecker::check(Instruction &I) {
  NonFinite RuledOut = ruledOutBy(I);
  if (std::optional<IntegerConversion> Conversion = integerConversion(I))
    checkConversion(I, *Conversion);
  // The promise includes the comparison.
  if (std::optional<CmpInst::Predicate> Predicate = floatPredicate(I);
      Predicate && !RuledOut.NaN)
    checkComparison(I, *Predicate);
  if (auto *Return = dyn_cast<ReturnInst>(&I))
    checkReturnedValue(*Return);
  if (auto *Call = dyn_cast<CallBase>(&I))
    checkArguments(*Call);
  if (!RuledOut.any())
    return;
  if (!isa<CallBase>(I) || isa<IntrinsicInst>(I))
    checkOperands(I, RuledOut);
  checkResult(I, RuledOut);
}

void FunctionChecker::run() {
  SmallVector<Instruction *, 64> Instructions(
      make_pointer_range(instructions(F)));
  for (Instruction *I : Instructions)
    check(*I);
  dropPromises(F);
  // A check that fails neither returns nor leaves everything alone.
  F.setMemoryEffects(F.getMemoryEffects() |
                     MemoryEffects::inaccessibleMemOnly());
  F.removeFnAttr(Attribute::WillReturn);
  F.addFnAttr(CheckedFunctionAttribute);
}

/// Turns `__attribute__((annotate("tp-fp-unchecked")))` into the attribute.
static void readAnnotations(Module &M) {
  auto *Annotations = M.getNamedGlobal("llvm.global.annotations");
  if (!Annotations || !Annotations->hasInitializer())
    return;
  for (const Use &Entry : Annotations->getInitializer()->operands()) {
    auto *Fields = dyn_cast<ConstantStruct>(Entry);
    if (!Fields || Fields->getNumOperands() < 2)
      continue;
    auto *F = dyn_cast<Function>(Fields->getOperand(0)->stripPointerCasts());
    auto *Text =
        dyn_cast<GlobalVariable>(Fields->getOperand(1)->stripPointerCasts());
    if (!F || !Text || !Text->hasInitializer())
      continue;
    auto *Characters = dyn_cast<ConstantDataArray>(Text->getInitializer());
    if (Characters && Characters->isCString() &&
        Characters->getAsCString() == UncheckedFunctionAttribute)
      F->addFnAttr(UncheckedFunctionAttribute);
  }
}

static bool shouldCheck(const Function &F) {
  return !F.isDeclaration() && !F.hasFnAttribute(CheckedFunctionAttribute) &&
         !F.hasFnAttribute(UncheckedFunctionAttribute) &&
         !F.hasFnAttribute(Attribute::Naked);
}

PreservedAnalyses FloatingPointCheckPass::run(Module &M,
                                              ModuleAnalysisManager &) {
  if (!isFloatingPointCheckEnabled())
    return PreservedAnalyses::all();
  readAnnotations(M);
  CheckEmitter Emitter(M);
  for (Function &F : M)
    if (shouldCheck(F))
      FunctionChecker(F, Emitter).run();
  return PreservedAnalyses::none();
}
