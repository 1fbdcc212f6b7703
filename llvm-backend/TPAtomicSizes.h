//===- TPAtomicSizes.h - Atomic objects that are too large ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPATOMICSIZES_H
#define TP_LLVM_BACKEND_TPATOMICSIZES_H

#include "llvm/IR/PassManager.h"

namespace llvm {

/// Reports an error for each atomic operation on more than eight bytes. The
/// front end makes it a call of the runtime, which has such for less only.
class TPAtomicSizesPass : public PassInfoMixin<TPAtomicSizesPass> {
public:
  PreservedAnalyses run(Module &M, ModuleAnalysisManager &);
  static bool isRequired() { return true; }
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPATOMICSIZES_H
