//===- CheckEmitter.h - Code that reports a failed check --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKEMITTER_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKEMITTER_H

#include "llvm-backend/FloatingPoint/Check/CheckFailure.h"
#include "llvm/IR/IRBuilder.h"
#include <optional>

namespace llvm {

/// What the report of a check shows: its result, which may be missing, and its
/// operands, as far as there are any. Scalars of one type.
struct CheckedValues {
  Value *Result = nullptr;
  Value *First = nullptr;
  Value *Second = nullptr;
};

/// Inserts branches to code that reports a failed check and does not come back.
/// That code stands at the end of its function, off every expected path.
class CheckEmitter {
public:
  explicit CheckEmitter(Module &M);

  /// At \p Builder's place, stops the program if \p Failed. \p Builder goes on
  /// behind that.
  void failIf(IRBuilderBase &Builder, Value *Failed, tp::CheckKind Kind,
              tp::CheckOperation Operation, CheckedValues Values);

private:
  void reportOnChip(IRBuilderBase &Builder, uint32_t Code,
                    CheckedValues Values);
  void reportOnHost(IRBuilderBase &Builder, uint32_t Code,
                    CheckedValues Values);

  Module &M;
  bool IsChip;
};

/// The check whose failure \p Block reports, if it is such a block.
std::optional<tp::CheckFailure> findReport(const BasicBlock &Block);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKEMITTER_H
