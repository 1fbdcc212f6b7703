//===- Completion.h - What can stand at the cursor --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_COMPLETION_H
#define TP_DEBUGGER_CLI_COMPLETION_H

#include "llvm/ADT/StringRef.h"

#include <string>
#include <vector>

namespace tp {

class Shell;

/// Whole words that can stand in place of the last one of \p Line, sorted.
std::vector<std::string> complete(Shell &S, llvm::StringRef Line);

/// The last word of \p Line, which completions replace.
llvm::StringRef lastWord(llvm::StringRef Line);

} // namespace tp

#endif // TP_DEBUGGER_CLI_COMPLETION_H
