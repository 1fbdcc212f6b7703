//===- TargetChoice.h - Options that name the target ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_TARGETCHOICE_H
#define TP_LLVM_BACKEND_CLANG_TARGETCHOICE_H

#include "llvm-backend/clang/CommandLineOption.h"
#include "llvm/Support/Error.h"

namespace tp {

/// Whether \p Option names a target, an architecture or a processor. There is
/// only one of each, so that the option changes nothing.
bool isTargetChoice(const CommandLineOption &Option);

/// \returns an error if \p Option, for which isTargetChoice() holds, asks for
/// something else than the TP.
llvm::Error checkTargetChoice(const CommandLineOption &Option);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_TARGETCHOICE_H
