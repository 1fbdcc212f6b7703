//===- TPAtomicLoops.cpp - The first loads of compare-exchange loops ------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// An atomic operation without an instruction becomes a loop around a compare-
// exchange. Its first guess comes from a load that does no harm if it is
// wrong, but that others may write meanwhile: an atomic load.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TP.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/InitializePasses.h"
#include "llvm/Pass.h"

using namespace llvm;

#define DEBUG_TYPE "tp-atomic-loops"

namespace {

class TPAtomicLoops : public FunctionPass {
public:
  static char ID;

  TPAtomicLoops() : FunctionPass(ID) {}

  StringRef getPassName() const override { return "TP atomic loops"; }

  void getAnalysisUsage(AnalysisUsage &AU) const override {
    AU.setPreservesCFG();
  }

  bool runOnFunction(Function &F) override;
};

} // namespace

char TPAtomicLoops::ID = 0;

INITIALIZE_PASS(TPAtomicLoops, DEBUG_TYPE,
                "Make the first loads of compare-exchange loops atomic", false,
                false)

FunctionPass *llvm::createTPAtomicLoopsPass() { return new TPAtomicLoops(); }

/// The load that \p Value comes from, if nothing but arithmetic is between.
static LoadInst *loadBehind(Value *Value) {
  while (isa<CastInst, BinaryOperator>(Value))
    Value = cast<Instruction>(Value)->getOperand(0);
  return dyn_cast<LoadInst>(Value);
}

/// The load of the first value that is compared, where the loop makes the next
/// ones itself.
static LoadInst *firstLoad(AtomicCmpXchgInst &Exchange) {
  Value *Guess = Exchange.getCompareOperand();
  while (isa<CastInst, BinaryOperator>(Guess))
    Guess = cast<Instruction>(Guess)->getOperand(0);
  if (auto *Phi = dyn_cast<PHINode>(Guess))
    for (Value *Incoming : Phi->incoming_values())
      if (LoadInst *Load = loadBehind(Incoming))
        return Load;
  return nullptr;
}

bool TPAtomicLoops::runOnFunction(Function &F) {
  bool Changed = false;
  for (Instruction &I : instructions(F)) {
    auto *Exchange = dyn_cast<AtomicCmpXchgInst>(&I);
    if (!Exchange)
      continue;
    LoadInst *Load = firstLoad(*Exchange);
    if (!Load || Load->isAtomic() ||
        !(Load->getType()->isIntegerTy() || Load->getType()->isFloatTy()) ||
        Load->getPointerOperand() != Exchange->getPointerOperand())
      continue;
    Load->setAtomic(AtomicOrdering::Unordered);
    Changed = true;
  }
  return Changed;
}
