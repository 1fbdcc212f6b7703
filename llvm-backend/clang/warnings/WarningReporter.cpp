//===- WarningReporter.cpp - Reports the -Wtp-fp warnings -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/WarningReporter.h"
#include "llvm/ADT/ScopeExit.h"

using namespace clang;
using namespace llvm;

namespace tp {

// A diagnostic whose text is its argument. It is shown in macros of system
// headers too, such as INFINITY, where the user expands them.
static unsigned addDiagnostic(DiagnosticsEngine &Diags, diag::Severity Severity,
                              unsigned Class) {
  return Diags.getDiagnosticIDs()->getCustomDiagID(
      DiagnosticIDs::CustomDiagDesc(Severity, "%0", Class,
                                    /*ShowInSystemHeader=*/false,
                                    /*ShowInSystemMacro=*/true));
}

WarningReporter::WarningReporter(DiagnosticsEngine &Diags,
                                 const DiagnosticPragmas &Pragmas)
    : Diags(Diags), Pragmas(Pragmas),
      WarningId(addDiagnostic(Diags, diag::Severity::Warning,
                              DiagnosticIDs::CLASS_WARNING)),
      ErrorId(addDiagnostic(Diags, diag::Severity::Error,
                            DiagnosticIDs::CLASS_ERROR)),
      NoteId(addDiagnostic(Diags, diag::Severity::Fatal,
                           DiagnosticIDs::CLASS_NOTE)) {}

void WarningReporter::report(unsigned Id, SourceLocation Location,
                             StringRef Message, ArrayRef<SourceRange> Ranges,
                             ArrayRef<FixItHint> FixIts) {
  DiagnosticBuilder Builder = Diags.Report(Location, Id);
  Builder << Message;
  for (SourceRange Range : Ranges)
    Builder << Range;
  for (const FixItHint &FixIt : FixIts)
    Builder << FixIt;
}

bool WarningReporter::warn(FloatingPointWarning Warning,
                           SourceLocation Location, StringRef Message,
                           ArrayRef<SourceRange> Ranges) {
  const SourceManager &Sources = Diags.getSourceManager();
  if (Sources.isInSystemHeader(Sources.getExpansionLoc(Location)))
    return false;
  const WarningOptions &Options = Pragmas.optionsAt(Location);
  WarningLevel Level = Options.level(Warning);
  if (Level == WarningLevel::Ignored ||
      !Reported.insert({static_cast<unsigned>(Warning), Location}).second)
    return false;
  // Clang would make an error of it under -Werror, whatever we have found that
  // -Wno-error= says.
  bool AllAreErrors = Diags.getWarningsAsErrors();
  scope_exit Restore([&] { Diags.setWarningsAsErrors(AllAreErrors); });
  Diags.setWarningsAsErrors(false);
  std::string Text = Message.str();
  if (Diags.getDiagnosticOptions().ShowOptionNames)
    Text += Options.suffix(Warning);
  report(Level == WarningLevel::Error ? ErrorId : WarningId, Location, Text,
         Ranges, {});
  return true;
}

void WarningReporter::note(SourceLocation Location, StringRef Message,
                           ArrayRef<SourceRange> Ranges,
                           ArrayRef<FixItHint> FixIts) {
  report(NoteId, Location, Message, Ranges, FixIts);
}

} // namespace tp
