//===- RefusedOptions.h - What clang can and the TP cannot ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_REFUSEDOPTIONS_H
#define TP_LLVM_BACKEND_CLANG_REFUSEDOPTIONS_H

#include "llvm/Option/ArgList.h"
#include "llvm/Support/Error.h"

namespace tp {

/// Looks for options of clang's that need what the TP or its runtime does not
/// have: threads, exceptions, type information, a profile's file.
/// \returns an error with a line for each, which says why and what to do.
llvm::Error checkRefusedOptions(const llvm::opt::ArgList &Arguments);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_REFUSEDOPTIONS_H
