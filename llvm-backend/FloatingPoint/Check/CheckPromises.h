//===- CheckPromises.h - What fast math rules out ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKPROMISES_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKPROMISES_H

#include "llvm-backend/FloatingPoint/Check/CheckConditions.h"
#include "llvm/IR/Attributes.h"

namespace llvm {

/// What the flags `nnan` and `ninf` of \p I rule out in its operands and its
/// result.
NonFinite ruledOutBy(const Instruction &I);

/// What the attribute `nofpclass` among \p Attributes rules out.
NonFinite ruledOutBy(AttributeSet Attributes);

/// Whether \p V is never one of \p Classes where it is used, because it is a
/// constant or because the checks at its definition see to that.
bool isCheckedBefore(const Value *V, NonFinite Classes);

/// The operands of \p I, an instruction whose flags rule out \p Classes, that a
/// check of its result would not find out.
SmallVector<Value *, 2> operandsToCheck(const Instruction &I,
                                        NonFinite Classes);

/// Whether the result of \p I, whose flags rule out \p Classes, can be one of
/// them although the operands have been checked.
bool isResultToCheck(const Instruction &I, NonFinite Classes);

/// Removes everything from \p F that promises the absence of NaNs and
/// infinities.
void dropPromises(Function &F);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKPROMISES_H
