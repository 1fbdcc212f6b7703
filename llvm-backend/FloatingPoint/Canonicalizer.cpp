//===- Canonicalizer.cpp - Fast math independent of context ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalizer.h"
#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm/IR/Function.h"
#include "llvm/IR/Module.h"

using namespace llvm;

static constexpr StringRef CanonicalAttribute = "tp-fp-canonical";

PreservedAnalyses FloatingPointCanonicalizerPass::run(Module &M,
                                                      ModuleAnalysisManager &) {
  if (!isFloatingPointCanonicalizationEnabled())
    return PreservedAnalyses::all();
  for (Function &F : M)
    if (!F.isDeclaration())
      F.addFnAttr(CanonicalAttribute);
  return PreservedAnalyses::none();
}
