//===- CheckPass.h - Traps on invalid floating-point values -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKPASS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKPASS_H

#include "llvm/IR/PassManager.h"

namespace llvm {

/// On functions with checks: set by the pass.
inline constexpr const char CheckedFunctionAttribute[] = "tp-fp-checked";

/// On functions that the pass leaves alone, with their fast-math flags.
inline constexpr const char UncheckedFunctionAttribute[] = "tp-fp-unchecked";

/// The checked mode (-tp-fp-check): a program stops where a NaN or a number out
/// of range is converted to an integer, where a NaN is compared, and where fast
/// math is told that there are no infinities or NaNs and meets one. The report
/// shows the values.
///
/// It runs behind the canonicalizer, which leaves the flags `nnan` and `ninf`
/// on what it makes, and before every pass that could draw conclusions from
/// them. Afterwards the flags are gone: nothing in a checked function is
/// undefined because of a value.
class FloatingPointCheckPass : public PassInfoMixin<FloatingPointCheckPass> {
public:
  PreservedAnalyses run(Module &M, ModuleAnalysisManager &AM);
  static bool isRequired() { return true; }
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKPASS_H
