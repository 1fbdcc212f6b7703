//===- Scope.h - Fast math in part of a program ---------------- -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPE_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPE_H

#include "llvm/IR/PassManager.h"

namespace llvm {

/// Makes everything strict that the file of `-tp-fp-scope=` does not select
/// (see ScopeFile.h), and lists what there is to select in the file of
/// `-tp-fp-scope-list=`. A search for the expression that fast math breaks
/// narrows a build down with it. Where the file selects everything, the module
/// stays as it is.
class FloatingPointScopePass : public PassInfoMixin<FloatingPointScopePass> {
public:
  PreservedAnalyses run(Module &M, ModuleAnalysisManager &AM);
  static bool isRequired() { return true; }
};

/// Whether the pass has made part of \p M strict. Then the code generator must
/// not fuse but where an instruction says so.
bool isPartlyStrict(const Module &M);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPE_H
