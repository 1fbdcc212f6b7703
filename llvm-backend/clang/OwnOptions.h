//===- OwnOptions.h - The options that only tpcc has ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_OWNOPTIONS_H
#define TP_LLVM_BACKEND_CLANG_OWNOPTIONS_H

#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <vector>

namespace tp {

/// A command line after tpcc's own options have been replaced by clang's.
struct TranslatedCommandLine {
  /// What the user's options override.
  std::vector<const char *> Defaults;
  std::vector<const char *> Words;
  /// The -Wtp words, for the front end.
  std::vector<const char *> WarningWords;
  WarningOptions Warnings;
  /// Whether --print-fp was given.
  bool PrintsFloatingPoint = false;
};

/// Translates \p Words. Among options that exclude each other the last counts;
/// a floating-point preset also makes clang forget every floating-point option
/// before it.
/// \returns an error if an option has a value that it cannot have.
llvm::Expected<TranslatedCommandLine>
translateOwnOptions(llvm::ArrayRef<const char *> Words);

/// Whether \p Word is one of tpcc's own options about floating point.
bool isOwnFloatingPointOption(llvm::StringRef Word);

/// Prints name and meaning of tpcc's own options.
void printOwnOptions(llvm::raw_ostream &Stream);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_OWNOPTIONS_H
