//===- tpcc.cpp - Compiler of the thread processor ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPTargetMachine.h"
#include "llvm-backend/clang/Driver.h"
#include "llvm/Support/InitLLVM.h"

int main(int ArgumentCount, char **Arguments) {
  llvm::InitLLVM Initialization(ArgumentCount, Arguments);
  LLVMInitializeTPTarget();
  return tp::runDriver(llvm::ArrayRef<const char *>(Arguments, ArgumentCount),
                       reinterpret_cast<void *>(&main));
}
