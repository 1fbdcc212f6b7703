//===- ReductionMarks.cpp - Which additions lanes may share ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/Reductions.h"
#include "llvm/Analysis/LoopInfo.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"

using namespace llvm;

static void mark(Instruction &I) {
  I.setMetadata(ReductionMark, MDNode::get(I.getContext(), {}));
}

void llvm::copyReductionMark(const Instruction &From, Instruction &To) {
  if (From.hasMetadata(ReductionMark))
    mark(To);
}

// Whether \p V loads the variable that \p Store writes.
static bool loads(const Value &V, const StoreInst &Store) {
  const auto *Load = dyn_cast<LoadInst>(&V);
  return Load && Load->isSimple() && Load->hasOneUse() &&
         Load->getParent() == Store.getParent() &&
         Load->getPointerOperand() == Store.getPointerOperand();
}

// Whether \p I computes a variable's next value from its last: Sum += X.
static bool isAccumulation(const Instruction &I) {
  bool IsSum = I.getOpcode() == Instruction::FAdd;
  if ((!IsSum && I.getOpcode() != Instruction::FSub) || !I.hasAllowReassoc() ||
      !(I.getType()->isFloatTy() || I.getType()->isDoubleTy()) ||
      !I.hasOneUse())
    return false;
  const auto *Store = dyn_cast<StoreInst>(I.user_back());
  return Store && Store->isSimple() &&
         isa<AllocaInst>(Store->getPointerOperand()) &&
         (loads(*I.getOperand(0), *Store) ||
          (IsSum && loads(*I.getOperand(1), *Store)));
}

bool llvm::markReductions(Function &F) {
  SmallVector<Instruction *, 8> Accumulations;
  for (Instruction &I : instructions(F))
    if (isAccumulation(I))
      Accumulations.push_back(&I);
  if (Accumulations.empty())
    return false;
  DominatorTree Dominators(F);
  LoopInfo Loops(Dominators);
  bool IsAnyMarked = false;
  for (Instruction *I : Accumulations)
    if (const Loop *L = Loops.getLoopFor(I->getParent());
        L && L->isInnermost()) {
      mark(*I);
      IsAnyMarked = true;
    }
  return IsAnyMarked;
}
