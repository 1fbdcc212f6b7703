//===- ScopeItems.h - Where a function is free to round -------- -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPEITEMS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPEITEMS_H

#include "llvm/ADT/SmallVector.h"

namespace llvm {

class Function;
class Instruction;

/// One place of a function that lets the compiler change values: an
/// instruction with fast-math flags, one that may be fused, a call whose values
/// are said to be no NaN or infinity; or, without instruction, the function's
/// own promises about its parameters, its result and its arithmetic.
struct ScopeItem {
  Instruction *Place = nullptr;
};

/// The items of \p F in their order, which numbers them from 0: its own
/// promises if it has any, then its instructions.
SmallVector<ScopeItem> scopeItems(Function &F);

/// Takes the freedom of \p Item away: flags and promises go, a multiply-add
/// that may be fused becomes a multiply and an add.
void makeStrict(ScopeItem Item, Function &F);

/// Takes the promises of a mere declaration away.
void makeDeclarationStrict(Function &F);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPEITEMS_H
