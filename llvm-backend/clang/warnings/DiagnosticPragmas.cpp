//===- DiagnosticPragmas.cpp - Warning names in pragmas -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/DiagnosticPragmas.h"
#include "clang/Basic/DiagnosticLex.h"
#include "clang/Lex/LiteralSupport.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringSwitch.h"

using namespace clang;
using namespace llvm;

namespace tp {

//===----------------------------------------------------------------------===//
// DiagnosticPragmas
//===----------------------------------------------------------------------===//

void DiagnosticPragmas::change(SourceLocation Location,
                               const WarningOptions &Options) {
  Current = Options;
  Transitions.push_back({Sources.getExpansionLoc(Location), Options});
}

void DiagnosticPragmas::pop(SourceLocation Location) {
  // Clang warns of a pop without a push.
  if (Pushed.empty())
    return;
  change(Location, Pushed.back());
  Pushed.pop_back();
}

bool DiagnosticPragmas::read(SourceLocation Location, StringRef Severity,
                             StringRef Word) {
  std::string Name = Word.str();
  bool IsReplaced =
      Word.drop_front(StringRef("-W").size()) == ReplacedClangWarning;
  if (IsReplaced)
    Name = "-Wtp-fp-nonfinite";
  if (!WarningOptions::isOwnWord(Name))
    return false;
  StringRef Group = StringRef(Name).drop_front(StringRef("-W").size());
  SmallVector<std::string, 2> Words;
  if (Severity == "ignored")
    Words = {("-Wno-" + Group).str()};
  else if (Severity == "warning")
    Words = {("-W" + Group).str(), ("-Wno-error=" + Group).str()};
  else if (Severity == "error" || Severity == "fatal")
    Words = {("-Werror=" + Group).str()};
  WarningOptions Options = Current;
  for (const std::string &Single : Words)
    if (Error Unknown = Options.readOwnWord(Single)) {
      consumeError(std::move(Unknown));
      return false;
    }
  change(Location, Options);
  return !IsReplaced;
}

const WarningOptions &
DiagnosticPragmas::optionsAt(SourceLocation Location) const {
  SourceLocation Place = Sources.getExpansionLoc(Location);
  auto After = partition_point(Transitions, [&](const Transition &Earlier) {
    return Sources.isBeforeInTranslationUnit(Earlier.Location, Place);
  });
  return After == Transitions.begin() ? CommandLine : std::prev(After)->Options;
}

bool DiagnosticPragmas::isAnywhereEnabled(FloatingPointWarning Warning) const {
  return CommandLine.level(Warning) != WarningLevel::Ignored ||
         any_of(Transitions, [&](const Transition &Change) {
           return Change.Options.level(Warning) != WarningLevel::Ignored;
         });
}

//===----------------------------------------------------------------------===//
// DiagnosticPragmaReader
//===----------------------------------------------------------------------===//

namespace {

/// Reads a pragma's words from the text of its file, without the preprocessor.
class PragmaText {
public:
  PragmaText(StringRef Text, const LangOptions &Language)
      : Words(SourceLocation(), Language, Text.begin(), Text.begin(),
              Text.end()) {}

  /// The next word's spelling, or the contents of the next string.
  /// Empty at the end of the line.
  std::string next() {
    Token Word;
    Words.LexFromRawLexer(Word);
    if (Word.is(tok::eof) || (Word.isAtStartOfLine() && !IsFirst))
      return "";
    IsFirst = false;
    if (Word.is(tok::raw_identifier))
      return Word.getRawIdentifier().str();
    StringRef Spelling(Words.getBufferLocation() - Word.getLength(),
                       Word.getLength());
    if (Word.is(tok::string_literal) && Spelling.consume_front("\""))
      return unescape(Spelling.drop_back());
    return Spelling.str();
  }

private:
  static std::string unescape(StringRef Text) {
    std::string Result;
    for (size_t I = 0; I < Text.size(); ++I) {
      if (Text[I] == '\\' && I + 1 < Text.size())
        ++I;
      Result.push_back(Text[I]);
    }
    return Result;
  }

  Lexer Words;
  bool IsFirst = true;
};

} // namespace

// What follows `#pragma` or stands in `_Pragma("...")`; empty where that is not
// written out at Location.
static std::string pragmaContents(const char *Text, const char *End,
                                  const LangOptions &Language) {
  StringRef Rest(Text, End - Text);
  PragmaText Words(Rest, Language);
  std::string Introducer = Words.next();
  if (Introducer == "#") {
    Words.next();
    return Rest.take_until([](char C) { return C == '\n'; }).str();
  }
  if (Introducer != "_Pragma" || Words.next() != "(")
    return "";
  return "#pragma " + Words.next();
}

void DiagnosticPragmaReader::silenceUnknownNames(SourceLocation Location) {
  DiagnosticsEngine &Diags = PP.getDiagnostics();
  switch (Diags.getDiagnosticLevel(diag::warn_pragma_diagnostic_unknown_warning,
                                   Location)) {
  case DiagnosticsEngine::Ignored:
    return;
  case DiagnosticsEngine::Warning:
    UnknownNameSeverity = diag::Severity::Warning;
    break;
  default:
    UnknownNameSeverity = diag::Severity::Error;
    break;
  }
  Diags.setSeverity(diag::warn_pragma_diagnostic_unknown_warning,
                    diag::Severity::Ignored, Location);
}

void DiagnosticPragmaReader::restoreUnknownNames(SourceLocation Location) {
  if (!UnknownNameSeverity)
    return;
  PP.getDiagnostics().setSeverity(diag::warn_pragma_diagnostic_unknown_warning,
                                  *UnknownNameSeverity, Location);
  UnknownNameSeverity.reset();
}

void DiagnosticPragmaReader::PragmaDirective(SourceLocation Location,
                                             PragmaIntroducerKind) {
  const SourceManager &Sources = PP.getSourceManager();
  SourceLocation Place = Sources.getExpansionLoc(Location);
  restoreUnknownNames(Place);
  auto [File, Offset] = Sources.getDecomposedSpellingLoc(Location);
  StringRef Buffer = Sources.getBufferData(File);
  std::string Contents =
      pragmaContents(Buffer.data() + Offset, Buffer.end(), PP.getLangOpts());
  PragmaText Words(Contents, PP.getLangOpts());
  Words.next();
  Words.next();
  std::string Namespace = Words.next();
  if ((Namespace != "clang" && Namespace != "GCC") ||
      Words.next() != "diagnostic")
    return;
  std::string Action = Words.next();
  if (Action == "push")
    Pragmas.push();
  else if (Action == "pop")
    Pragmas.pop(Place);
  else if (Pragmas.read(Place, Action, Words.next()))
    silenceUnknownNames(Place);
}

} // namespace tp
