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

/// The load that \p Guess comes from, through what computes a guess from it.
static LoadInst *firstLoad(Value *Guess, const BasicBlock *Loop) {
  while (auto *I = dyn_cast<Instruction>(Guess)) {
    if (auto *Load = dyn_cast<LoadInst>(I))
      return Load;
    if (isa<CastInst>(I) || isa<BinaryOperator>(I)) {
      Guess = I->getOperand(0);
      continue;
    }
    auto *Phi = dyn_cast<PHINode>(I);
    if (!Phi || Phi->getParent() != Loop)
      return nullptr;
    Value *Entering = nullptr;
    for (unsigned From = 0; From != Phi->getNumIncomingValues(); ++From)
      if (isa<LoadInst, CastInst, BinaryOperator>(
              Phi->getIncomingValue(From)) &&
          Phi->getIncomingBlock(From) != Loop)
        Entering = Phi->getIncomingValue(From);
    if (!Entering)
      return nullptr;
    Guess = Entering;
    Loop = nullptr;
  }
  return nullptr;
}

bool TPAtomicLoops::runOnFunction(Function &F) {
  bool Changed = false;
  for (Instruction &I : instructions(F)) {
    auto *Exchange = dyn_cast<AtomicCmpXchgInst>(&I);
    if (!Exchange)
      continue;
    LoadInst *Load =
        firstLoad(Exchange->getCompareOperand(), Exchange->getParent());
    if (!Load || Load->isAtomic() ||
        !(Load->getType()->isIntegerTy() || Load->getType()->isFloatTy()) ||
        Load->getPointerOperand() != Exchange->getPointerOperand())
      continue;
    Load->setAtomic(AtomicOrdering::Unordered);
    Changed = true;
  }
  return Changed;
}
