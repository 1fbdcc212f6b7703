//===- Expressions.cpp - Parts of floating-point expressions --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/Expressions.h"
#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm/ADT/PostOrderIterator.h"
#include "llvm/Analysis/ConstantFolding.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/PatternMatch.h"
#include "llvm/Transforms/Utils/Local.h"

using namespace llvm;
using namespace PatternMatch;

bool llvm::isRewrittenType(const Type &T) {
  const Type &Scalar = *T.getScalarType();
  return (Scalar.isFloatTy() || Scalar.isDoubleTy()) &&
         !isa<ScalableVectorType>(T);
}

void llvm::forEachInstruction(Function &F,
                              function_ref<void(Instruction &)> Rewrite) {
  SmallVector<WeakVH, 64> Instructions;
  for (BasicBlock *Block : ReversePostOrderTraversal(&F))
    for (Instruction &I : *Block)
      Instructions.emplace_back(&I);
  for (WeakVH &Handle : Instructions)
    if (Value *I = Handle)
      Rewrite(*cast<Instruction>(I));
}

FastMathFlags llvm::getRewriteFlags(const Instruction &I) {
  FastMathFlags Flags = I.getFastMathFlags();
  if (isFloatingPointCheckEnabled())
    return Flags;
  Flags.setNoNaNs(false);
  Flags.setNoInfs(false);
  return Flags;
}

void llvm::replaceExpression(Instruction &Old, Value &New) {
  if (auto *NewInstruction = dyn_cast<Instruction>(&New))
    if (!NewInstruction->hasName())
      NewInstruction->takeName(&Old);
  Old.replaceAllUsesWith(&New);
  SmallVector<WeakTrackingVH, 4> Operands(Old.operands());
  // Also if it is a call that might set errno.
  Old.eraseFromParent();
  RecursivelyDeleteTriviallyDeadInstructionsPermissive(Operands);
}

bool llvm::isPartOf(const Value &V, const Instruction &User) {
  const auto *I = dyn_cast<Instruction>(&V);
  return I && I->hasOneUse() && I->getParent() == User.getParent();
}

//===----------------------------------------------------------------------===//
// Equality
//===----------------------------------------------------------------------===//

// Deeper expressions count as different.
static constexpr unsigned MaxDepth = 8;

static bool mayChangeMemory(const Instruction &I) {
  return I.mayWriteToMemory() && !isa<LifetimeIntrinsic>(I) &&
         !isa<AssumeInst>(I) && !I.isDebugOrPseudoInst();
}

static bool isMemoryUnchangedBetween(const Instruction &A,
                                     const Instruction &B) {
  if (A.getParent() != B.getParent())
    return false;
  const Instruction &First = A.comesBefore(&B) ? A : B;
  const Instruction &Last = &First == &A ? B : A;
  return none_of(make_range(First.getIterator(), Last.getIterator()),
                 mayChangeMemory);
}

static bool isSame(const Value *A, const Value *B, unsigned Depth);

static bool haveSameOperands(const User &A, const User &B, unsigned Depth) {
  return equal(A.operands(), B.operands(), [=](const Use &L, const Use &R) {
    return isSame(L.get(), R.get(), Depth);
  });
}

static bool isRepeatable(const Instruction &I) {
  if (const auto *Load = dyn_cast<LoadInst>(&I))
    return Load->isSimple();
  if (const auto *Call = dyn_cast<CallInst>(&I))
    return Call->doesNotAccessMemory() && !Call->isConvergent() &&
           !Call->hasOperandBundles();
  return isa<GetElementPtrInst, CastInst, BinaryOperator, UnaryOperator,
             ExtractElementInst, ExtractValueInst, ShuffleVectorInst>(I);
}

static bool isSame(const Value *A, const Value *B, unsigned Depth) {
  if (A == B)
    return true;
  const auto *I = dyn_cast<Instruction>(A);
  const auto *J = dyn_cast<Instruction>(B);
  if (Depth == MaxDepth || !I || !J || !isRepeatable(*I) || !isRepeatable(*J) ||
      !I->isSameOperationAs(J, Instruction::CompareIgnoringAlignment))
    return false;
  if (isa<LoadInst>(I) && !isMemoryUnchangedBetween(*I, *J))
    return false;
  return haveSameOperands(*I, *J, Depth + 1);
}

bool llvm::isSameValue(const Value *A, const Value *B) {
  return isSame(A, B, 0);
}

//===----------------------------------------------------------------------===//
// Constants
//===----------------------------------------------------------------------===//

bool llvm::isOne(const Value &V) { return match(&V, m_FPOne()); }

bool llvm::isNormalConstant(const Constant &C) {
  if (const auto *Scalar = dyn_cast<ConstantFP>(&C))
    return Scalar->getType()->isFloatingPointTy() &&
           Scalar->getValueAPF().isNormal();
  const auto *Vector = dyn_cast<FixedVectorType>(C.getType());
  if (!Vector)
    return false;
  for (unsigned Lane = 0; Lane != Vector->getNumElements(); ++Lane) {
    const auto *Element =
        dyn_cast_or_null<ConstantFP>(C.getAggregateElement(Lane));
    if (!Element || !Element->getValueAPF().isNormal())
      return false;
  }
  return true;
}

static Constant *foldNormal(Instruction::BinaryOps Opcode, Constant &A,
                            Constant &B) {
  Constant *Result = ConstantFoldBinaryInstruction(Opcode, &A, &B);
  return Result && isNormalConstant(*Result) ? Result : nullptr;
}

Constant *llvm::divideConstants(Constant &Dividend, Constant &Divisor) {
  return foldNormal(Instruction::FDiv, Dividend, Divisor);
}

Constant *llvm::multiplyConstants(Constant &A, Constant &B) {
  return foldNormal(Instruction::FMul, A, B);
}

//===----------------------------------------------------------------------===//
// Powers
//===----------------------------------------------------------------------===//

Value *llvm::createPower(IRBuilderBase &Builder, Value &Base,
                         unsigned Exponent) {
  Value *Result = nullptr;
  Value *Square = &Base;
  for (;; Square = Builder.CreateFMul(Square, Square)) {
    if (Exponent & 1)
      Result = Result ? Builder.CreateFMul(Result, Square) : Square;
    Exponent >>= 1;
    if (Exponent == 0)
      return Result;
  }
}
