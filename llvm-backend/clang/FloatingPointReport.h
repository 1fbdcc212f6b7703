//===- FloatingPointReport.h - Prints how floating point is compiled -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_FLOATINGPOINTREPORT_H
#define TP_LLVM_BACKEND_CLANG_FLOATINGPOINTREPORT_H

#include "llvm-backend/clang/FloatingPointResolver.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Prints a table of each property, its value and the one of \p Options that
/// decided it.
void printFloatingPointTable(llvm::raw_ostream &Stream,
                             const FloatingPointDecisions &Decisions,
                             llvm::ArrayRef<CommandLineOption> Options);

/// Prints \p Settings as one line that starts with `#`.
void printFloatingPointComment(llvm::raw_ostream &Stream,
                               const FloatingPointSettings &Settings);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_FLOATINGPOINTREPORT_H
