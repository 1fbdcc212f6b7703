//===- AssemblerJob.h - One run of the assembler ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_ASSEMBLERJOB_H
#define TP_LLVM_BACKEND_CLANG_ASSEMBLERJOB_H

#include "clang/Basic/Diagnostic.h"
#include "llvm/ADT/ArrayRef.h"

namespace tp {

/// Assembles one file in this process.
/// \param Arguments what follows `-cc1as` on the command line.
/// \returns false after an error, which has been reported.
bool runAssembler(llvm::ArrayRef<const char *> Arguments,
                  clang::DiagnosticsEngine &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_ASSEMBLERJOB_H
