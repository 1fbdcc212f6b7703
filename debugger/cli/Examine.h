//===- Examine.h - Memory by format and unit --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_EXAMINE_H
#define TP_DEBUGGER_CLI_EXAMINE_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>

namespace tp {

class Shell;

/// Behind the slash of `x/4xw`, `p/x`, `output/d`.
struct FormatLetters {
  uint64_t Count = 1;
  /// 0: none given.
  char Format = 0;
  /// Bytes of a unit; 0: none given.
  unsigned Unit = 0;
};

/// Reads \p Text; the error names the letter.
llvm::Expected<FormatLetters> parseFormat(llvm::StringRef Text);

/// Whether \p Format is one of x and not of print: it has a count or unit, or
/// is `i` or `s`.
bool isMemoryFormat(llvm::StringRef Format);

/// Prints memory at \p Address, an expression, or where the last one ended.
llvm::Error examine(Shell &S, llvm::StringRef Format, llvm::StringRef Address);

} // namespace tp

#endif // TP_DEBUGGER_CLI_EXAMINE_H
