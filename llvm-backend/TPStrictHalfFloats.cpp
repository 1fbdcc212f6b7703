//===- TPStrictHalfFloats.cpp - Strict arithmetic of half floats ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The legalizer cannot make constrained arithmetic of half floats that of wider
// ones. Here, behind the optimizer, it may be ordinary arithmetic: the TP has
// no exception flags and one rounding.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TP.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/InitializePasses.h"
#include "llvm/Pass.h"

using namespace llvm;

#define DEBUG_TYPE "tp-strict-half-floats"

static bool concernsHalf(const ConstrainedFPIntrinsic &Strict) {
  auto IsHalf = [](const Type *Type) {
    return Type->getScalarType()->is16bitFPTy();
  };
  return IsHalf(Strict.getType()) || any_of(Strict.args(), [&](const Use &Arg) {
           return IsHalf(Arg->getType());
         });
}

static Value *createOperation(unsigned Opcode, ArrayRef<Value *> Operands,
                              Type *Result, IRBuilder<> &Builder) {
  if (Instruction::isBinaryOp(Opcode))
    return Builder.CreateBinOp(static_cast<Instruction::BinaryOps>(Opcode),
                               Operands[0], Operands[1]);
  return Builder.CreateCast(static_cast<Instruction::CastOps>(Opcode),
                            Operands[0], Result);
}

/// The same without constraints.
static Value *createOrdinary(const ConstrainedFPIntrinsic &Strict,
                             IRBuilder<> &Builder) {
  SmallVector<Value *, 3> Operands(
      Strict.arg_begin(), Strict.arg_begin() + Strict.getNonMetadataArgCount());
  Type *Result = Strict.getType();
  switch (Strict.getIntrinsicID()) {
#define DAG_INSTRUCTION(Name, Arguments, Rounding, ID, Node)                   \
  case Intrinsic::ID:                                                          \
    return createOperation(Instruction::Name, Operands, Result, Builder);
#define CMP_INSTRUCTION(Name, Arguments, Rounding, ID, Node)                   \
  case Intrinsic::ID:                                                          \
    return Builder.CreateFCmp(                                                 \
        cast<ConstrainedFPCmpIntrinsic>(Strict).getPredicate(), Operands[0],   \
        Operands[1]);
#define DAG_FUNCTION(Name, Arguments, Rounding, ID, Node)                      \
  FUNCTION(Name, Arguments, Rounding, ID)
#define FUNCTION(Name, Arguments, Rounding, ID)                                \
  case Intrinsic::ID:                                                          \
    return Builder.CreateIntrinsic(Result, Intrinsic::Name, Operands);
#include "llvm/IR/ConstrainedOps.def"
  default:
    llvm_unreachable("no constrained operation");
  }
}

namespace {

class TPStrictHalfFloats : public FunctionPass {
public:
  static char ID;

  TPStrictHalfFloats() : FunctionPass(ID) {}

  StringRef getPassName() const override { return "TP strict half floats"; }

  void getAnalysisUsage(AnalysisUsage &AU) const override {
    AU.setPreservesCFG();
  }

  bool runOnFunction(Function &F) override;
};

} // namespace

char TPStrictHalfFloats::ID = 0;

INITIALIZE_PASS(TPStrictHalfFloats, DEBUG_TYPE,
                "Make constrained arithmetic of half floats ordinary", false,
                false)

FunctionPass *llvm::createTPStrictHalfFloatsPass() {
  return new TPStrictHalfFloats();
}

bool TPStrictHalfFloats::runOnFunction(Function &F) {
  bool Changed = false;
  for (Instruction &I : make_early_inc_range(instructions(F))) {
    auto *Strict = dyn_cast<ConstrainedFPIntrinsic>(&I);
    if (!Strict || !concernsHalf(*Strict))
      continue;
    IRBuilder<> Builder(Strict);
    Value *Ordinary = createOrdinary(*Strict, Builder);
    Ordinary->takeName(Strict);
    Strict->replaceAllUsesWith(Ordinary);
    Strict->eraseFromParent();
    Changed = true;
  }
  return Changed;
}
