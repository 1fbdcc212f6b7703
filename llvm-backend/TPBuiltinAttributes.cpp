//===- TPBuiltinAttributes.cpp - Attributes of the TP builtins ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPBuiltinAttributes.h"
#include "llvm-backend/TP.h"
#include "llvm-backend/TPBuiltins.h"
#include "llvm/IR/Module.h"
#include "llvm/InitializePasses.h"
#include "llvm/Pass.h"

using namespace llvm;

#define DEBUG_TYPE "tp-builtin-attributes"

static void addAttributes(Function &F, TPBuiltin::ID Builtin) {
  F.setDoesNotThrow();
  bool Returns = !TPBuiltin::isNoReturn(Builtin);
  if (!Returns)
    F.setDoesNotReturn();
  switch (TPBuiltin::getEffect(Builtin)) {
  case TPBuiltin::Effect::Const:
    F.setMemoryEffects(MemoryEffects::none());
    F.setWillReturn();
    F.setSpeculatable();
    break;
  case TPBuiltin::Effect::Inaccessible:
    F.setMemoryEffects(MemoryEffects::inaccessibleMemOnly());
    if (Returns)
      F.setWillReturn();
    break;
  case TPBuiltin::Effect::Memory:
    break;
  }
}

static bool addAttributes(Module &M) {
  bool Changed = false;
  for (Function &F : M) {
    TPBuiltin::ID Builtin = TPBuiltin::getID(F);
    if (Builtin == TPBuiltin::ID::None)
      continue;
    addAttributes(F, Builtin);
    Changed = true;
  }
  return Changed;
}

PreservedAnalyses TPBuiltinAttributesPass::run(Module &M,
                                               ModuleAnalysisManager &) {
  return addAttributes(M) ? PreservedAnalyses::none()
                          : PreservedAnalyses::all();
}

namespace {

class TPBuiltinAttributesLegacy : public ModulePass {
public:
  static char ID;

  TPBuiltinAttributesLegacy() : ModulePass(ID) {}

  StringRef getPassName() const override { return "TP builtin attributes"; }
  bool runOnModule(Module &M) override { return addAttributes(M); }
};

} // namespace

char TPBuiltinAttributesLegacy::ID = 0;

INITIALIZE_PASS(TPBuiltinAttributesLegacy, DEBUG_TYPE,
                "Attributes of the TP builtins", false, false)

ModulePass *llvm::createTPBuiltinAttributesPass() {
  return new TPBuiltinAttributesLegacy();
}
