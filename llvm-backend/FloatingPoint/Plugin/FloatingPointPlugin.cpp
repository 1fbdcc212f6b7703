//===- FloatingPointPlugin.cpp - The passes for stock clang ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm-backend/FloatingPoint/FloatingPointPasses.h"
#include "llvm-backend/FloatingPoint/Scope/Scope.h"
#include "llvm/Plugins/PassPlugin.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

// The code generator must not fuse what the canonicalizer has left apart.
static bool forbidFusion(Module &M, TargetMachine &Machine, CodeGenFileType,
                         raw_pwrite_stream &) {
  if (isFloatingPointCanonicalizationEnabled())
    Machine.Options.AllowFPOpFusion = FPOpFusion::Strict;
  else if (isPartlyStrict(M))
    Machine.Options.AllowFPOpFusion = FPOpFusion::Standard;
  return false;
}

extern "C" LLVM_EXTERNAL_VISIBILITY PassPluginLibraryInfo
llvmGetPassPluginInfo() {
  return {LLVM_PLUGIN_API_VERSION, "TPFloatingPoint", TP_VERSION,
          registerFloatingPointPasses, forbidFusion};
}
