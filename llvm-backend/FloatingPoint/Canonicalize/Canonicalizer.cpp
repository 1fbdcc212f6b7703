//===- Canonicalizer.cpp - Fast math independent of context ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/Canonicalizer.h"
#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Reductions.h"
#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm-backend/FloatingPoint/FloatingPointTarget.h"
#include "llvm-backend/FloatingPoint/FloatingPointUnits.h"
#include "llvm-backend/FloatingPoint/ValueClasses.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

/// Marks the functions that have been rewritten: at link time the pass meets
/// them again, optimized and among others that it has never seen.
static constexpr StringRef CanonicalAttribute = "tp-fp-canonical";

//===----------------------------------------------------------------------===//
// What the linker reads
//===----------------------------------------------------------------------===//

static bool assumesFiniteMath(const Instruction &I) {
  return I.hasNoNaNs() || I.hasNoInfs();
}

// Adds !tp.floating_point: the source file, and whether one of its
// floating-point instructions takes NaN or infinity for impossible.
static void describeUnit(Module &M) {
  if (!floatingPointUnits(M).empty())
    return;
  bool HasFloatingPoint = false, IsFinite = false;
  for (const Function &F : M)
    for (const Instruction &I : instructions(F))
      if (isa<FPMathOperator>(I)) {
        HasFloatingPoint = true;
        IsFinite |= assumesFiniteMath(I);
      }
  if (HasFloatingPoint)
    addFloatingPointUnit(M, {M.getSourceFileName(), IsFinite});
}

//===----------------------------------------------------------------------===//
// The pass
//===----------------------------------------------------------------------===//

static bool isToBeRewritten(const Function &F) {
  return !F.isDeclaration() && !F.hasFnAttribute(CanonicalAttribute) &&
         !F.hasFnAttribute(Attribute::StrictFP);
}

static void canonicalize(Function &F, FunctionAnalysisManager &Analyses) {
  FloatingPointTarget Target(F);
  splitMultiplyAdds(F);
  expandPowers(F);
  replaceDivisions(F, Target);
  rebuildProducts(F);
  factorSums(F);
  bool HasReductions = markReductions(F);
  contractSums(F, Target);
  fixMathFunctions(F);
  stripFastMathFlags(F);
  if (HasReductions)
    splitReductions(F, Analyses);
  F.addFnAttr(CanonicalAttribute);
}

PreservedAnalyses
FloatingPointCanonicalizerPass::run(Module &M, ModuleAnalysisManager &AM) {
  describeUnit(M);
  if (!isFloatingPointCanonicalizationEnabled())
    return PreservedAnalyses::all();
  SmallVector<Function *> Functions;
  for (Function &F : M)
    if (isToBeRewritten(F))
      Functions.push_back(&F);
  // A wrapper is recognized before it is rewritten itself.
  for (Function *F : Functions)
    forwardMathWrappers(*F);
  FunctionAnalysisManager &Analyses =
      AM.getResult<FunctionAnalysisManagerModuleProxy>(M).getManager();
  for (Function *F : Functions)
    canonicalize(*F, Analyses);
  // Without `nnan` and `ninf` on the instructions around it, LLVM 22.1 makes
  // wrong code of `nofpclass`: InstCombine puts a copysign behind its use. The
  // checked mode looks for the promises, and removes them itself.
  if (!isFloatingPointCheckEnabled())
    for (Function &F : M)
      dropValueClasses(F);
  return PreservedAnalyses::none();
}
