//===- Canonicalizer.h - Fast math independent of context ----- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_CANONICALIZER_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_CANONICALIZER_H

#include "llvm/IR/PassManager.h"

namespace llvm {

/// Performs the rewrites that fast-math flags allow, each in one form that
/// depends on the source expression alone, then removes the flags that allowed
/// them: every later pass keeps the bits. So an expression has the same value
/// inlined, hoisted, unrolled, called through a pointer, and at every -O level.
class FloatingPointCanonicalizerPass
    : public PassInfoMixin<FloatingPointCanonicalizerPass> {
public:
  PreservedAnalyses run(Module &M, ModuleAnalysisManager &AM);
  /// Also at -O0: the promise holds at every level.
  static bool isRequired() { return true; }
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_CANONICALIZER_H
