//===- Divisions.cpp - Reciprocals instead of divisions -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Expressions.h"
#include "llvm-backend/FloatingPoint/Canonicalize/MathFunctions.h"
#include "llvm-backend/FloatingPoint/FloatingPointTarget.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/PatternMatch.h"

using namespace llvm;
using namespace PatternMatch;

//===----------------------------------------------------------------------===//
// Reciprocal square roots
//===----------------------------------------------------------------------===//

static Value *createBuiltinCall(IRBuilderBase &Builder, Module &M,
                                Value &Radicand) {
  Type *Float = Builder.getFloatTy();
  FunctionCallee Builtin = M.getOrInsertFunction("tp_rsqrt", Float, Float);
  auto *Vector = dyn_cast<FixedVectorType>(Radicand.getType());
  if (!Vector)
    return Builder.CreateCall(Builtin, &Radicand);
  Value *Result = PoisonValue::get(Vector);
  for (unsigned Lane = 0; Lane != Vector->getNumElements(); ++Lane) {
    Value *Element = Builder.CreateExtractElement(&Radicand, Lane);
    Result = Builder.CreateInsertElement(
        Result, Builder.CreateCall(Builtin, Element), Lane);
  }
  return Result;
}

static Value *createReciprocalSquareRoot(Instruction &Place, Value &Radicand,
                                         const FloatingPointTarget &Target) {
  IRBuilder<> Builder(&Place);
  if (Target.isTP())
    return createBuiltinCall(Builder, *Place.getModule(), Radicand);
  Type *Wide = Radicand.getType()->getWithNewType(Builder.getDoubleTy());
  Value *Root = Builder.CreateUnaryIntrinsic(
      Intrinsic::sqrt, Builder.CreateFPExt(&Radicand, Wide));
  Value *Quotient = Builder.CreateFDiv(ConstantFP::get(Wide, 1.0), Root);
  return Builder.CreateFPTrunc(Quotient, Radicand.getType());
}

// The x of sqrt(x) in single precision whose root need not be exact.
static Value *matchApproximateRoot(Value &V) {
  CallBase *Root = matchMathCall(V, MathFunction::SquareRoot);
  if (!Root || !Root->getType()->getScalarType()->isFloatTy() ||
      !Root->hasApproxFunc() ||
      !(Root->doesNotAccessMemory() || Root->hasNoNaNs()))
    return nullptr;
  return Root->getArgOperand(0);
}

// On the TP, (float)(1.0 / sqrt((double)x)) is what rsqrt_s computes.
static void replaceExactReciprocalRoot(Instruction &I,
                                       const FloatingPointTarget &Target) {
  Value *Root, *Radicand;
  if (!Target.isTP() || !I.getType()->isFloatTy() ||
      !match(&I, m_FPTrunc(m_FDiv(m_FPOne(), m_Value(Root)))) ||
      !Root->getType()->isDoubleTy())
    return;
  CallBase *Call = matchMathCall(*Root, MathFunction::SquareRoot);
  if (Call && Call->doesNotAccessMemory() &&
      match(Call->getArgOperand(0), m_FPExt(m_Value(Radicand))) &&
      Radicand->getType()->isFloatTy())
    replaceExpression(I, *createReciprocalSquareRoot(I, *Radicand, Target));
}

//===----------------------------------------------------------------------===//
// Divisions
//===----------------------------------------------------------------------===//

static Value *createReciprocal(IRBuilderBase &Builder, Instruction &Division,
                               const FloatingPointTarget &Target) {
  Value &Divisor = *Division.getOperand(1);
  Constant &One = *ConstantFP::get(Division.getType(), 1.0);
  if (auto *Literal = dyn_cast<Constant>(&Divisor))
    return isNormalConstant(*Literal) ? divideConstants(One, *Literal)
                                      : nullptr;
  if (Value *Radicand = matchApproximateRoot(Divisor);
      Radicand && Division.hasApproxFunc())
    return createReciprocalSquareRoot(Division, *Radicand, Target);
  if (isOne(*Division.getOperand(0)))
    return &Division;
  return Builder.CreateFDiv(&One, &Divisor);
}

static void replaceDivision(Instruction &Division,
                            const FloatingPointTarget &Target) {
  IRBuilder<> Builder(&Division);
  Builder.setFastMathFlags(getRewriteFlags(Division));
  Division.setFastMathFlags(getRewriteFlags(Division));
  Value *Reciprocal = createReciprocal(Builder, Division, Target);
  if (!Reciprocal || Reciprocal == &Division)
    return;
  Value *Dividend = Division.getOperand(0);
  replaceExpression(Division, isOne(*Dividend)
                                  ? *Reciprocal
                                  : *Builder.CreateFMul(Dividend, Reciprocal));
}

void llvm::replaceDivisions(Function &F, const FloatingPointTarget &Target) {
  forEachInstruction(F, [&](Instruction &I) {
    if (isa<FPTruncInst>(I))
      replaceExactReciprocalRoot(I, Target);
    else if (I.getOpcode() == Instruction::FDiv && I.hasAllowReciprocal() &&
             isRewrittenType(*I.getType()))
      replaceDivision(I, Target);
  });
}
