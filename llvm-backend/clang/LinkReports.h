//===- LinkReports.h - Options for the reports of the link ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINKREPORTS_H
#define TP_LLVM_BACKEND_CLANG_LINKREPORTS_H

#include "llvm-backend/clang/TimeReports.h"
#include "llvm-backend/clang/link/ProgramReports.h"
#include "llvm/Option/ArgList.h"

namespace tp {

/// Reads from clang's options what the link of the program \p OutputPath
/// reports: -Rpass=, -fsave-optimization-record, -fstack-usage, -save-temps and
/// their variants.
ProgramReports readProgramReports(const llvm::opt::ArgList &Arguments,
                                  llvm::StringRef OutputPath);

/// Reads the options of -ftime-trace for the link of \p OutputPath.
TimeTrace::Settings readTimeTrace(const llvm::opt::ArgList &Arguments,
                                  llvm::StringRef OutputPath);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINKREPORTS_H
