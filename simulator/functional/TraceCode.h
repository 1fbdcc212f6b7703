//===- TraceCode.h - A trace as an LLVM function ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_TRACECODE_H
#define TP_SIMULATOR_FUNCTIONAL_TRACECODE_H

#include "simulator/functional/Trace.h"

#include "llvm/IR/Module.h"

#include <string>

namespace tp {

/// Adds to \p M, which has the functional step functions, a function with the
/// type of FunctionalHandler for the slot of the trace's first step.
void addTrace(llvm::Module &M, const std::string &Name,
              const FunctionalSubject &Subject, const Trace &Steps);

/// Replaces loads of what does not change in a run: the address space, and
/// where the thread's local store is.
void foldAddresses(llvm::Function &Handler, const FunctionalSubject &Subject);

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_TRACECODE_H
