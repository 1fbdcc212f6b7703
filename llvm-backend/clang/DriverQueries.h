//===- DriverQueries.h - Questions that tpcc answers itself -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_DRIVERQUERIES_H
#define TP_LLVM_BACKEND_CLANG_DRIVERQUERIES_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Option/ArgList.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Prints tpcc's version, clang's version, the target and the tool's folder.
void printVersion(llvm::raw_ostream &Stream, llvm::StringRef ToolPath);

/// Answers --version, --help, -dumpmachine and their like on stdout.
/// \returns whether \p UserArguments asked one of these questions.
bool answerQuery(const llvm::opt::ArgList &UserArguments,
                 llvm::StringRef ToolPath);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_DRIVERQUERIES_H
