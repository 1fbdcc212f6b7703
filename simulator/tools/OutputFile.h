//===- OutputFile.h - Files that a command writes ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_OUTPUTFILE_H
#define TP_SIMULATOR_TOOLS_OUTPUTFILE_H

#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <string>

namespace tp {

/// Writes what \p Write writes to the file at \p Path, or to standard output if
/// that is `-`.
llvm::Error writeTo(const std::string &Path,
                    llvm::function_ref<void(llvm::raw_ostream &)> Write);

/// Whether all that went to standard output arrived there.
llvm::Error flushOutput();

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_OUTPUTFILE_H
