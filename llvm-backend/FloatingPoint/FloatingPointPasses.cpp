//===- FloatingPointPasses.cpp - Their place in the pipeline --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/FloatingPointPasses.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Canonicalizer.h"
#include "llvm-backend/FloatingPoint/Check/CheckMerging.h"
#include "llvm-backend/FloatingPoint/Check/CheckPass.h"
#include "llvm-backend/FloatingPoint/Scope/Scope.h"
#include "llvm/Passes/PassBuilder.h"

using namespace llvm;

static void addFloatingPointPasses(ModulePassManager &PM) {
#define FLOATING_POINT_PASS(Name, Class) PM.addPass(Class());
#include "llvm-backend/FloatingPoint/FloatingPointPasses.def"
}

static bool addFloatingPointPass(StringRef Name, ModulePassManager &PM) {
#define FLOATING_POINT_PASS(PassName, Class)                                   \
  if (Name == PassName) {                                                      \
    PM.addPass(Class());                                                       \
    return true;                                                               \
  }
#include "llvm-backend/FloatingPoint/FloatingPointPasses.def"
  return false;
}

void llvm::registerFloatingPointPasses(PassBuilder &PB) {
  auto AddPasses = [](ModulePassManager &PM, auto...) {
    addFloatingPointPasses(PM);
  };
  PB.registerPipelineStartEPCallback(AddPasses);
  PB.registerFullLinkTimeOptimizationEarlyEPCallback(AddPasses);
  auto AddLastPasses = [](ModulePassManager &PM, OptimizationLevel Level,
                          auto...) {
    if (Level != OptimizationLevel::O0)
      PM.addPass(
          createModuleToFunctionPassAdaptor(FloatingPointCheckMergingPass()));
  };
  PB.registerOptimizerLastEPCallback(AddLastPasses);
  PB.registerFullLinkTimeOptimizationLastEPCallback(AddLastPasses);
  PB.registerPipelineParsingCallback(
      [](StringRef Name, ModulePassManager &PM,
         ArrayRef<PassBuilder::PipelineElement>) {
        return addFloatingPointPass(Name, PM);
      });
}
