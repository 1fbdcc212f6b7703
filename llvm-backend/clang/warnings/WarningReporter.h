//===- WarningReporter.h - Reports the -Wtp-fp warnings ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_WARNINGREPORTER_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_WARNINGREPORTER_H

#include "llvm-backend/clang/warnings/DiagnosticPragmas.h"
#include "clang/Basic/Diagnostic.h"
#include "llvm/ADT/DenseSet.h"

namespace tp {

/// Reports warnings through clang's diagnostics, at the level that options and
/// pragmas give them. Clang knows no groups but its own, so the name at the
/// end of a message is part of its text.
class WarningReporter {
public:
  WarningReporter(clang::DiagnosticsEngine &Diags,
                  const DiagnosticPragmas &Pragmas);

  /// Reports \p Message, without its name, unless that is switched off at
  /// \p Location or was said before of the same place, as in another instance
  /// of a template.
  /// \returns whether it was reported, and may have notes.
  bool warn(FloatingPointWarning Warning, clang::SourceLocation Location,
            llvm::StringRef Message, llvm::ArrayRef<clang::SourceRange> Ranges);

  void note(clang::SourceLocation Location, llvm::StringRef Message,
            llvm::ArrayRef<clang::SourceRange> Ranges = {},
            llvm::ArrayRef<clang::FixItHint> FixIts = {});

private:
  void report(unsigned Id, clang::SourceLocation Location,
              llvm::StringRef Message,
              llvm::ArrayRef<clang::SourceRange> Ranges,
              llvm::ArrayRef<clang::FixItHint> FixIts);

  clang::DiagnosticsEngine &Diags;
  const DiagnosticPragmas &Pragmas;
  unsigned WarningId, ErrorId, NoteId;
  llvm::DenseSet<std::pair<unsigned, clang::SourceLocation>> Reported;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_WARNINGREPORTER_H
