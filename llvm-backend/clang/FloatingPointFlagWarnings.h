//===- FloatingPointFlagWarnings.h - Hazards on the command line -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_FLOATINGPOINTFLAGWARNINGS_H
#define TP_LLVM_BACKEND_CLANG_FLOATINGPOINTFLAGWARNINGS_H

#include "llvm-backend/clang/FloatingPointResolver.h"
#include "llvm-backend/clang/warnings/WarningOptions.h"

namespace tp {

/// Warns of floating-point options in \p Options that undo others or do
/// nothing.
/// \returns whether a warning was an error.
bool warnOfFloatingPointFlags(const FloatingPointResolver &Resolver,
                              llvm::ArrayRef<CommandLineOption> Options,
                              const WarningOptions &Warnings);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_FLOATINGPOINTFLAGWARNINGS_H
