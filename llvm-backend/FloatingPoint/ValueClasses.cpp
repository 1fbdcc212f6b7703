//===- ValueClasses.cpp - Promises of what values are not -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/ValueClasses.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/InstrTypes.h"

using namespace llvm;

bool llvm::promisesValueClasses(const AttributeList &Attributes) {
  return Attributes.hasAttrSomewhere(Attribute::NoFPClass);
}

AttributeList llvm::withoutValueClasses(LLVMContext &Context,
                                        AttributeList Attributes) {
  for (unsigned Index : Attributes.indexes())
    Attributes =
        Attributes.removeAttributeAtIndex(Context, Index, Attribute::NoFPClass);
  return Attributes;
}

void llvm::dropValueClasses(Function &F) {
  LLVMContext &Context = F.getContext();
  F.setAttributes(withoutValueClasses(Context, F.getAttributes()));
  for (Instruction &I : instructions(F))
    if (auto *Call = dyn_cast<CallBase>(&I))
      Call->setAttributes(withoutValueClasses(Context, Call->getAttributes()));
}
