//===- ValueClasses.h - Promises of what values are not -------- -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_VALUECLASSES_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_VALUECLASSES_H

#include "llvm/IR/Attributes.h"

namespace llvm {

class Function;

/// Whether a parameter or the result is promised (`nofpclass`) to be no NaN or
/// no infinity.
bool promisesValueClasses(const AttributeList &Attributes);

/// \p Attributes without those promises.
AttributeList withoutValueClasses(LLVMContext &Context,
                                  AttributeList Attributes);

/// Removes the promises of \p F and of the calls in it.
void dropValueClasses(Function &F);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_VALUECLASSES_H
