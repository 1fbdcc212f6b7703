//===- TPTargetInfo.cpp - The TP in LLVM's target registry ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TargetInfo/TPTargetInfo.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Support/Compiler.h"

using namespace llvm;

Target &llvm::getTheTPTarget() {
  static Target TheTPTarget;
  return TheTPTarget;
}

// llvm::Triple has no TP; the target is found by its name.
extern "C" LLVM_EXTERNAL_VISIBILITY void LLVMInitializeTPTargetInfo() {
  RegisterTarget<Triple::UnknownArch> X(getTheTPTarget(), "tp",
                                        "Thread processor (32-bit)", "TP");
}
