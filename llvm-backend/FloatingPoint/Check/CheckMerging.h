//===- CheckMerging.h - Fewer branches for the checks -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKMERGING_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKMERGING_H

#include "llvm/IR/PassManager.h"

namespace llvm {

/// Lets consecutive checks of the checked mode share one branch, at the end of
/// a function's optimization: what stands between them becomes one block, in
/// which the code generator can move loads ahead. The branch leads to code that
/// finds the check that failed first. Nothing with an effect is moved before a
/// check, and nothing behind the check of a conversion, whose result may be
/// part of an address.
class FloatingPointCheckMergingPass
    : public PassInfoMixin<FloatingPointCheckMergingPass> {
public:
  PreservedAnalyses run(Function &F, FunctionAnalysisManager &AM);
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKMERGING_H
