//===- TPByValArguments.h - Structs passed by value -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPBYVALARGUMENTS_H
#define TP_LLVM_BACKEND_TPBYVALARGUMENTS_H

#include "llvm/IR/PassManager.h"

namespace llvm {

/// Writes out what `byval` means on the TP: the caller makes a copy and passes
/// its address. The optimizer can then avoid the copy, where the code generator
/// would always make it. The calling convention stays as it is.
class TPByValArgumentsPass : public PassInfoMixin<TPByValArgumentsPass> {
public:
  PreservedAnalyses run(Module &M, ModuleAnalysisManager &);
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPBYVALARGUMENTS_H
