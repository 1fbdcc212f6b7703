//===- TPBuiltinAttributes.h - Attributes of the TP builtins ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPBUILTINATTRIBUTES_H
#define TP_LLVM_BACKEND_TPBUILTINATTRIBUTES_H

#include "llvm/IR/PassManager.h"

namespace llvm {

/// Gives the declarations of the TP builtins the attributes that the Effect
/// column of TPBuiltins.def promises, so that the optimizer may move, merge and
/// delete their calls accordingly.
class TPBuiltinAttributesPass : public PassInfoMixin<TPBuiltinAttributesPass> {
public:
  PreservedAnalyses run(Module &M, ModuleAnalysisManager &);
  static bool isRequired() { return true; }
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPBUILTINATTRIBUTES_H
