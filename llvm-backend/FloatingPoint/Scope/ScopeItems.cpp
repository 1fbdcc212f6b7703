//===- ScopeItems.cpp - Where a function is free to round -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Scope/ScopeItems.h"
#include "llvm-backend/FloatingPoint/ValueClasses.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

static constexpr StringRef FunctionPromises[] = {
    "approx-func-fp-math",     "no-infs-fp-math",      "no-nans-fp-math",
    "no-signed-zeros-fp-math", "reciprocal-estimates", "unsafe-fp-math",
};

static bool isMultiplyAdd(const Instruction &I) {
  const auto *Call = dyn_cast<IntrinsicInst>(&I);
  return Call && Call->getIntrinsicID() == Intrinsic::fmuladd;
}

static bool isFree(const Instruction &I) {
  if (isa<FPMathOperator>(I) && I.getFastMathFlags().any())
    return true;
  if (const auto *Call = dyn_cast<CallBase>(&I))
    return isMultiplyAdd(I) || promisesValueClasses(Call->getAttributes());
  return false;
}

// What a function promises of its arithmetic matters only if it has some.
static bool hasPromises(Function &F) {
  if (promisesValueClasses(F.getAttributes()))
    return true;
  bool PromisesOfArithmetic = any_of(FunctionPromises, [&](StringRef Promise) {
    return F.hasFnAttribute(Promise);
  });
  return PromisesOfArithmetic &&
         any_of(instructions(F),
                [](const Instruction &I) { return isa<FPMathOperator>(I); });
}

SmallVector<ScopeItem> llvm::scopeItems(Function &F) {
  SmallVector<ScopeItem> Items;
  if (hasPromises(F))
    Items.push_back({});
  for (Instruction &I : instructions(F))
    if (isFree(I))
      Items.push_back({&I});
  return Items;
}

static void removePromises(Function &F) {
  F.setAttributes(withoutValueClasses(F.getContext(), F.getAttributes()));
  for (StringRef Promise : FunctionPromises)
    F.removeFnAttr(Promise);
}

static void splitMultiplyAdd(IntrinsicInst &MultiplyAdd) {
  IRBuilder<> Builder(&MultiplyAdd);
  Value *Product = Builder.CreateFMul(MultiplyAdd.getArgOperand(0),
                                      MultiplyAdd.getArgOperand(1));
  Value *Sum = Builder.CreateFAdd(Product, MultiplyAdd.getArgOperand(2));
  Sum->takeName(&MultiplyAdd);
  MultiplyAdd.replaceAllUsesWith(Sum);
  MultiplyAdd.eraseFromParent();
}

static void makeStrict(Instruction &I) {
  if (isMultiplyAdd(I)) {
    splitMultiplyAdd(cast<IntrinsicInst>(I));
    return;
  }
  if (isa<FPMathOperator>(I))
    I.copyFastMathFlags(FastMathFlags());
  if (auto *Call = dyn_cast<CallBase>(&I))
    Call->setAttributes(
        withoutValueClasses(I.getContext(), Call->getAttributes()));
}

void llvm::makeStrict(ScopeItem Item, Function &F) {
  if (Item.Place)
    ::makeStrict(*Item.Place);
  else
    removePromises(F);
}

void llvm::makeDeclarationStrict(Function &F) { removePromises(F); }
