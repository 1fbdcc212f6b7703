//===- TPPointedVariables.cpp - Variables behind pointers -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A struct that is passed by value is declared to debuggers as a variable in
// the memory that a pointer argument names, an array of variable size as one in
// the memory that the stack is grown by. Instruction selection expects declared
// memory to have a fixed place in the frame and otherwise forgets the variable.
// Here the declaration becomes one that follows the pointer: in unoptimized
// code a slot of the frame keeps it for the whole function, in optimized code
// it is a value like others.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TP.h"
#include "llvm/CodeGen/TargetPassConfig.h"
#include "llvm/IR/DebugInfo.h"
#include "llvm/IR/DebugProgramInstruction.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/InitializePasses.h"
#include "llvm/Pass.h"

using namespace llvm;

#define DEBUG_TYPE "tp-pointed-variables"

namespace {

class TPPointedVariables : public FunctionPass {
public:
  static char ID;

  TPPointedVariables() : FunctionPass(ID) {}

  StringRef getPassName() const override { return "TP pointed variables"; }

  void getAnalysisUsage(AnalysisUsage &AU) const override {
    AU.setPreservesCFG();
    AU.addRequired<TargetPassConfig>();
  }

  bool runOnFunction(Function &F) override;
};

} // namespace

char TPPointedVariables::ID = 0;

INITIALIZE_PASS_BEGIN(TPPointedVariables, DEBUG_TYPE,
                      "Follow pointers to variables", false, false)
INITIALIZE_PASS_DEPENDENCY(TargetPassConfig)
INITIALIZE_PASS_END(TPPointedVariables, DEBUG_TYPE,
                    "Follow pointers to variables", false, false)

FunctionPass *llvm::createTPPointedVariablesPass() {
  return new TPPointedVariables();
}

/// Whether \p Pointer is the place of an object of variable size.
static bool isVariableSize(const Value *Pointer) {
  const auto *Object = dyn_cast_or_null<AllocaInst>(Pointer);
  return Object && !Object->isStaticAlloca();
}

/// Makes a variable of the frame that holds the pointer of each by-value
/// argument and each object of variable size, with and without debug
/// information, so that the code is the same.
static DenseMap<Value *, AllocaInst *> keepInFrame(Function &F) {
  SmallVector<AllocaInst *> Objects;
  for (Instruction &I : instructions(F))
    if (isVariableSize(&I))
      Objects.push_back(cast<AllocaInst>(&I));
  DenseMap<Value *, AllocaInst *> Slots;
  BasicBlock &Entry = F.getEntryBlock();
  IRBuilder<> Builder(&Entry, Entry.begin());
  for (AllocaInst *Object : Objects)
    Slots[Object] = Builder.CreateAlloca(Object->getType());
  for (Argument &Pointer : F.args()) {
    if (!Pointer.hasByValAttr())
      continue;
    Slots[&Pointer] = Builder.CreateAlloca(Pointer.getType());
    Builder.CreateStore(&Pointer, Slots[&Pointer]);
  }
  for (AllocaInst *Object : Objects) {
    Builder.SetInsertPoint(Object->getNextNode());
    Builder.CreateStore(Object, Slots[Object]);
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

/// The declarations of variables in memory that an argument points to or that
/// the stack is grown by.
static SmallVector<DbgVariableRecord *> findDeclarations(Function &F) {
  SmallVector<DbgVariableRecord *> Declarations;
  for (Instruction &I : instructions(F))
    for (DbgVariableRecord &Record : filterDbgVars(I.getDbgRecordRange())) {
      const Value *Pointer = Record.getVariableLocationOp(0);
      if (Record.isDbgDeclare() &&
          (isa_and_nonnull<Argument>(Pointer) || isVariableSize(Pointer)))
        Declarations.push_back(&Record);
    }
  return Declarations;
}

bool TPPointedVariables::runOnFunction(Function &F) {
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
