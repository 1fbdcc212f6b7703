//===- CommandLineOption.h - The options of a command line ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_COMMANDLINEOPTION_H
#define TP_LLVM_BACKEND_CLANG_COMMANDLINEOPTION_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"

#include <string>
#include <vector>

namespace tp {

/// An option or input of a command line with the values that are words of their
/// own.
struct CommandLineOption {
  llvm::ArrayRef<const char *> Words;
  /// Clang's number for it (`clang::options::OPT_...`), of its alias's target
  /// if it is an alias; OPT_UNKNOWN for tpcc's own.
  unsigned ID;

  llvm::StringRef name() const { return Words.front(); }
  /// As the user wrote it.
  std::string text() const;
};

/// Finds where the options begin and end in \p Words, which the result refers
/// to.
std::vector<CommandLineOption>
splitCommandLine(llvm::ArrayRef<const char *> Words);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_COMMANDLINEOPTION_H
