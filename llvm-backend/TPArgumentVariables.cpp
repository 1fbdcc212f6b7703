//===- TPArgumentVariables.cpp - Variables behind pointer arguments -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A struct that is passed by value is declared to debuggers as a variable in
// the memory that a pointer argument names. Instruction selection expects such
// memory in the frame and otherwise forgets the variable. Here the declaration
// becomes one that follows the pointer: in unoptimized code a slot of the frame
// keeps it for the whole function, in optimized code it is a value like others.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TP.h"
#include "llvm/CodeGen/TargetPassConfig.h"
#include "llvm/IR/DebugInfo.h"
#include "llvm/IR/DebugProgramInstruction.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/InitializePasses.h"
#include "llvm/Pass.h"

using namespace llvm;

#define DEBUG_TYPE "tp-argument-variables"

namespace {

class TPArgumentVariables : public FunctionPass {
public:
  static char ID;

  TPArgumentVariables() : FunctionPass(ID) {}

  StringRef getPassName() const override { return "TP argument variables"; }

  void getAnalysisUsage(AnalysisUsage &AU) const override {
    AU.setPreservesCFG();
    AU.addRequired<TargetPassConfig>();
  }

  bool runOnFunction(Function &F) override;
};

} // namespace

char TPArgumentVariables::ID = 0;

INITIALIZE_PASS_BEGIN(TPArgumentVariables, DEBUG_TYPE,
                      "Follow pointer arguments to variables", false, false)
INITIALIZE_PASS_DEPENDENCY(TargetPassConfig)
INITIALIZE_PASS_END(TPArgumentVariables, DEBUG_TYPE,
                    "Follow pointer arguments to variables", false, false)

FunctionPass *llvm::createTPArgumentVariablesPass() {
  return new TPArgumentVariables();
}

/// Makes a variable of the frame that holds each by-value argument's pointer,
/// with and without debug information, so that the code is the same.
static DenseMap<Value *, AllocaInst *> keepInFrame(Function &F) {
  DenseMap<Value *, AllocaInst *> Slots;
  BasicBlock &Entry = F.getEntryBlock();
  IRBuilder<> Builder(&Entry, Entry.begin());
  for (Argument &Pointer : F.args()) {
    if (!Pointer.hasByValAttr())
      continue;
    Slots[&Pointer] = Builder.CreateAlloca(Pointer.getType());
    Builder.CreateStore(&Pointer, Slots[&Pointer]);
  }
  return Slots;
}

static void followPointer(DbgVariableRecord &Declaration, AllocaInst *Slot) {
  Declaration.setExpression(DIExpression::prepend(Declaration.getExpression(),
                                                  DIExpression::DerefBefore));
  if (Slot) {
    Declaration.replaceVariableLocationOp(0u, Slot);
    return;
  }
  DbgVariableRecord *Value = DbgVariableRecord::createDbgVariableRecord(
      Declaration.getVariableLocationOp(0), Declaration.getVariable(),
      Declaration.getExpression(), Declaration.getDebugLoc());
  Value->insertBefore(&Declaration);
  Declaration.eraseFromParent();
}

/// The declarations of variables in memory that an argument points to.
static SmallVector<DbgVariableRecord *> findDeclarations(Function &F) {
  SmallVector<DbgVariableRecord *> Declarations;
  for (BasicBlock &Block : F)
    for (Instruction &I : Block)
      for (DbgVariableRecord &Record : filterDbgVars(I.getDbgRecordRange()))
        if (Record.isDbgDeclare() &&
            isa_and_nonnull<Argument>(Record.getVariableLocationOp(0)))
          Declarations.push_back(&Record);
  return Declarations;
}

bool TPArgumentVariables::runOnFunction(Function &F) {
  const bool IsOptimized =
      getAnalysis<TargetPassConfig>().getOptLevel() != CodeGenOptLevel::None &&
      !F.hasOptNone();
  DenseMap<Value *, AllocaInst *> Slots;
  if (!IsOptimized && !F.hasFnAttribute(Attribute::Naked))
    Slots = keepInFrame(F);
  SmallVector<DbgVariableRecord *> Declarations = findDeclarations(F);
  for (DbgVariableRecord *Declaration : Declarations)
    followPointer(*Declaration,
                  Slots.lookup(Declaration->getVariableLocationOp(0)));
  return !Slots.empty() || !Declarations.empty();
}
