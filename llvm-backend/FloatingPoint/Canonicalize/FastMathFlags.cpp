//===- FastMathFlags.cpp - The end of the freedom to round ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

static FastMathFlags onlyFiniteMath(FastMathFlags Flags) {
  FastMathFlags Result;
  Result.setNoNaNs(Flags.noNaNs());
  Result.setNoInfs(Flags.noInfs());
  return Result;
}

void llvm::stripFastMathFlags(Function &F) {
  for (Instruction &I : instructions(F))
    if (isa<FPMathOperator>(I)) {
      I.copyFastMathFlags(onlyFiniteMath(I.getFastMathFlags()));
      I.setMetadata(LLVMContext::MD_fpmath, nullptr);
    }
  for (StringRef Promise :
       {"unsafe-fp-math", "no-signed-zeros-fp-math", "approx-func-fp-math",
        "reciprocal-estimates", "less-precise-fpmad"})
    F.removeFnAttr(Promise);
}
