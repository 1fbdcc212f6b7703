//===- LldbWords.h - lldb's commands in gdb's words -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_LLDBWORDS_H
#define TP_DEBUGGER_CLI_LLDBWORDS_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <string>

namespace tp {

/// The command that means what \p Line, in lldb's words, does; \p Line itself
/// if it is not in those. The error names an option that is not known.
llvm::Expected<std::string> fromLldb(llvm::StringRef Line);

} // namespace tp

#endif // TP_DEBUGGER_CLI_LLDBWORDS_H
