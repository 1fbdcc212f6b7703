//===- LinkDiagnostics.h - What the linker tells the user -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_LINKDIAGNOSTICS_H
#define TP_LLVM_BACKEND_CLANG_LINK_LINKDIAGNOSTICS_H

#include "llvm-backend/clang/link/SourceMessages.h"
#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "llvm/ADT/Twine.h"
#include "llvm/Support/WithColor.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Prints the linker's errors and counts them.
class LinkDiagnostics {
public:
  void error(const llvm::Twine &Message) {
    ++Errors;
    llvm::WithColor::error(llvm::errs(), "tpcc") << Message << '\n';
  }
  void warning(const llvm::Twine &Message) {
    llvm::WithColor::warning(llvm::errs(), "tpcc") << Message << '\n';
  }
  /// Reports a warning that has an option, at the level that it asks for.
  void report(const WarningOptions &Options, FloatingPointWarning Warning,
              const llvm::Twine &Message) {
    Errors += reportWarning(Options, Warning, Message);
  }
  /// Reports what concerns a place of the source.
  void report(llvm::SourceMgr::DiagKind Kind, const SourcePlace &Place,
              const llvm::Twine &Message) {
    Errors += Kind == llvm::SourceMgr::DK_Error;
    Sources.print(Kind, Place, Message);
  }
  bool hasErrors() const { return Errors != 0; }

private:
  unsigned Errors = 0;
  SourceMessages Sources;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_LINKDIAGNOSTICS_H
