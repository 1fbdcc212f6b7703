//===- CheckOperations.h - What reports call an instruction -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKOPERATIONS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKOPERATIONS_H

#include "llvm-backend/FloatingPoint/Check/CheckConditions.h"
#include "llvm-backend/FloatingPoint/Check/CheckEmitter.h"
#include <optional>

namespace llvm {

/// What \p I does to its operands; the result is not among the values.
std::pair<tp::CheckOperation, CheckedValues> describeOperation(Instruction &I);

/// The comparison \p Predicate, which is not constant.
tp::CheckOperation describeComparison(CmpInst::Predicate Predicate);

/// The conversion to an integer that \p I is, if it is one. Its operand is the
/// first.
std::optional<IntegerConversion> integerConversion(const Instruction &I);
tp::CheckOperation describeConversion(IntegerConversion Conversion);

/// The predicate of \p I if it compares its first two operands.
std::optional<CmpInst::Predicate> floatPredicate(const Instruction &I);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKOPERATIONS_H
