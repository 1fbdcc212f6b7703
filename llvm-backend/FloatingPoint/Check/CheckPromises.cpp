//===- CheckPromises.cpp - What fast math rules out -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckPromises.h"
#include "llvm-backend/FloatingPoint/ValueClasses.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

NonFinite llvm::ruledOutBy(const Instruction &I) {
  if (!isa<FPMathOperator>(I))
    return {};
  return {I.hasNoNaNs(), I.hasNoInfs()};
}

NonFinite llvm::ruledOutBy(AttributeSet Attributes) {
  FPClassTest Classes = Attributes.getNoFPClass();
  return {(Classes & fcNan) != 0, (Classes & fcInf) != 0};
}

static Intrinsic::ID intrinsicOf(const Instruction &I) {
  auto *Call = dyn_cast<CallBase>(&I);
  return Call ? Call->getIntrinsicID() : Intrinsic::not_intrinsic;
}

static bool isMinimumOrMaximum(const Instruction &I) {
  switch (intrinsicOf(I)) {
  case Intrinsic::minnum:
  case Intrinsic::maxnum:
  case Intrinsic::minimum:
  case Intrinsic::maximum:
  case Intrinsic::minimumnum:
  case Intrinsic::maximumnum:
    return true;
  default:
    return false;
  }
}

/// Whether the result is one of the operands but for its sign.
static bool choosesOperand(const Instruction &I) {
  return isa<SelectInst, PHINode>(I) || I.getOpcode() == Instruction::FNeg ||
         intrinsicOf(I) == Intrinsic::fabs || isMinimumOrMaximum(I);
}

static bool isCheckedBefore(const Value *V, NonFinite Classes, unsigned Depth);

static bool areOperandsCheckedBefore(const Instruction &I, NonFinite Classes,
                                     unsigned Depth) {
  return all_of(I.operands(), [&](const Value *Operand) {
    return !Operand->getType()->isFPOrFPVectorTy() ||
           isCheckedBefore(Operand, Classes, Depth);
  });
}

static bool isCheckedBefore(const Value *V, NonFinite Classes, unsigned Depth) {
  if (auto *C = dyn_cast<Constant>(V)) {
    if (auto *Splat = C->getType()->isVectorTy() ? C->getSplatValue() : C)
      C = Splat;
    auto *Number = dyn_cast<ConstantFP>(C);
    return Number && !(Classes.NaN && Number->isNaN()) &&
           !(Classes.Infinity && Number->isInfinity());
  }
  auto *I = dyn_cast<Instruction>(V);
  if (!I)
    return false;
  if (ruledOutBy(*I).covers(Classes))
    return true;
  // 64-bit integers are far below the greatest float.
  if (isa<SIToFPInst, UIToFPInst>(I))
    return I->getOperand(0)->getType()->getScalarSizeInBits() <= 64 &&
           I->getType()->getScalarSizeInBits() >= 32;
  constexpr unsigned MaximumDepth = 4;
  return choosesOperand(*I) && Depth < MaximumDepth &&
         areOperandsCheckedBefore(*I, Classes, Depth + 1);
}

bool llvm::isCheckedBefore(const Value *V, NonFinite Classes) {
  return ::isCheckedBefore(V, Classes, /*Depth=*/0);
}

/// Whether an operand that is NaN makes the result NaN, and one that is
/// infinite makes it infinite or NaN.
static bool passesNonFiniteOn(const Instruction &I, const Use &Operand) {
  switch (I.getOpcode()) {
  case Instruction::FAdd:
  case Instruction::FSub:
  case Instruction::FMul:
  case Instruction::FNeg:
  case Instruction::FPExt:
  case Instruction::FPTrunc:
    return true;
  case Instruction::FDiv:
  case Instruction::FRem:
    return Operand.getOperandNo() == 0;
  default:
    break;
  }
  switch (intrinsicOf(I)) {
  case Intrinsic::fabs:
  case Intrinsic::fma:
  case Intrinsic::fmuladd:
  case Intrinsic::sqrt:
    return true;
  default:
    return false;
  }
}

SmallVector<Value *, 2> llvm::operandsToCheck(const Instruction &I,
                                              NonFinite Classes) {
  SmallVector<Value *, 2> Operands;
  // Only the operand that they choose counts: that is the result.
  if (isa<SelectInst, PHINode>(I))
    return Operands;
  auto *Call = dyn_cast<CallBase>(&I);
  for (const Use &Operand : I.operands()) {
    if (Call && !Call->isArgOperand(&Operand))
      continue;
    // An infinite operand may also leave a NaN, which counts only if both do.
    bool IsFound =
        (Classes.NaN || !Classes.Infinity) && passesNonFiniteOn(I, Operand);
    if (!IsFound && Operand->getType()->isFPOrFPVectorTy() &&
        !isCheckedBefore(Operand, Classes))
      Operands.push_back(Operand);
  }
  return Operands;
}

bool llvm::isResultToCheck(const Instruction &I, NonFinite Classes) {
  return I.getType()->isFPOrFPVectorTy() && !isMinimumOrMaximum(I) &&
         !(choosesOperand(I) &&
           areOperandsCheckedBefore(I, Classes, /*Depth=*/1));
}

void llvm::dropPromises(Function &F) {
  dropValueClasses(F);
  F.removeFnAttr("no-nans-fp-math");
  F.removeFnAttr("no-infs-fp-math");
  for (Instruction &I : instructions(F))
    if (isa<FPMathOperator>(I)) {
      I.setHasNoNaNs(false);
      I.setHasNoInfs(false);
    }
}
