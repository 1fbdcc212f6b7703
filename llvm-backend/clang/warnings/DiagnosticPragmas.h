//===- DiagnosticPragmas.h - Warning names in pragmas -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_DIAGNOSTICPRAGMAS_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_DIAGNOSTICPRAGMAS_H

#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "clang/Basic/DiagnosticIDs.h"
#include "clang/Lex/PPCallbacks.h"
#include "clang/Lex/Preprocessor.h"

#include <optional>
#include <vector>

namespace tp {

/// Clang's own warning on the subject of FloatingPointWarning::NonFinite. Its
/// name, in options and pragmas, counts for ours, which speaks in its place.
inline constexpr const char ReplacedClangWarning[] = "nan-infinity-disabled";

/// The warning options at each place of a translation unit:
/// `#pragma clang diagnostic` with the names of WarningOptions.
class DiagnosticPragmas {
public:
  DiagnosticPragmas(const clang::SourceManager &Sources,
                    const WarningOptions &CommandLine)
      : Sources(Sources), Current(CommandLine), CommandLine(CommandLine) {}

  /// Pragmas have to come in the order of the translation unit.
  void push() { Pushed.push_back(Current); }
  void pop(clang::SourceLocation Location);
  /// Reads `#pragma clang diagnostic <severity> "-W<group>"`.
  /// \returns whether \p Word is one of our names.
  bool read(clang::SourceLocation Location, llvm::StringRef Severity,
            llvm::StringRef Word);

  const WarningOptions &optionsAt(clang::SourceLocation Location) const;

  /// Whether \p Warning is on at any place.
  bool isAnywhereEnabled(FloatingPointWarning Warning) const;

private:
  struct Transition {
    clang::SourceLocation Location;
    WarningOptions Options;
  };

  void change(clang::SourceLocation Location, const WarningOptions &Options);

  const clang::SourceManager &Sources;
  WarningOptions Current;
  const WarningOptions CommandLine;
  std::vector<WarningOptions> Pushed;
  std::vector<Transition> Transitions;
};

/// Tells DiagnosticPragmas what the preprocessor meets, and keeps clang from
/// calling our names unknown.
class DiagnosticPragmaReader : public clang::PPCallbacks {
public:
  DiagnosticPragmaReader(clang::Preprocessor &PP, DiagnosticPragmas &Pragmas)
      : PP(PP), Pragmas(Pragmas) {}

  void PragmaDirective(clang::SourceLocation Location,
                       clang::PragmaIntroducerKind Introducer) override;

private:
  void silenceUnknownNames(clang::SourceLocation Location);
  void restoreUnknownNames(clang::SourceLocation Location);

  clang::Preprocessor &PP;
  DiagnosticPragmas &Pragmas;
  /// What clang made of unknown names before they were silenced.
  std::optional<clang::diag::Severity> UnknownNameSeverity;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_DIAGNOSTICPRAGMAS_H
