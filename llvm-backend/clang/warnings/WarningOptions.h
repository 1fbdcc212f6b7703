//===- WarningOptions.h - Which -Wtp-fp warnings are on ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_WARNINGS_WARNINGOPTIONS_H
#define TP_LLVM_BACKEND_CLANG_WARNINGS_WARNINGOPTIONS_H

#include "llvm/ADT/StringRef.h"
#include "llvm/ADT/Twine.h"
#include "llvm/Support/Error.h"

#include <array>
#include <string>
#include <vector>

namespace tp {

/// A warning about floating point with a -W name of its own.
enum class FloatingPointWarning {
  FlagOrder,
  IgnoredFlag,
  NonFinite,
  Conversion,
  Comparator,
  MixedInfinities,
  Double
};

/// What a warning does to a compilation.
enum class WarningLevel { Ignored, Warning, Error };

/// The name of the plug-in that warns in the front end.
inline constexpr const char WarningPlugInName[] = "tp-fp";

/// The front end's option that hands the plug-in one of the user's -Wtp words.
inline constexpr const char WarningPlugInOption[] = "-plugin-arg-tp-fp";

/// The -Wtp words of a command line: `-Wtp-fp-<name>`, `-Wno-tp-fp-<name>`,
/// `-Werror=tp-fp-<name>`, `-Wno-error=tp-fp-<name>`, the same for the group
/// `tp-fp` of all of these, and for `tp-double`, which alone is off unless
/// asked for. They combine as clang's do.
class WarningOptions {
public:
  WarningOptions() { stateOf(FloatingPointWarning::Double).IsEnabled = false; }

  /// Whether \p Word sets one of these warnings (or, misspelt, tries to).
  static bool isOwnWord(llvm::StringRef Word);

  /// Reads a word for which isOwnWord() holds.
  /// \returns an error if there is no warning of that name.
  llvm::Error readOwnWord(llvm::StringRef Word);

  /// Reads a word of clang's that concerns all warnings: `-Werror`, `-w`,
  /// `-Wno-everything` and their opposites. Ignores any other.
  void readGeneralWord(llvm::StringRef Word);

  /// Takes over what -Werror and -w say, where only clang's diagnostics engine
  /// knows.
  void setGeneral(bool WarningsAreErrors, bool IgnoreWarnings) {
    AllAreErrors = WarningsAreErrors;
    IgnoreAll = IgnoreWarnings;
  }

  WarningLevel level(FloatingPointWarning Warning) const;

  /// What ends the message of \p Warning: ` [-Wtp-fp-<name>]`, with `-Werror,`
  /// before the name if the warning is an error.
  std::string suffix(FloatingPointWarning Warning) const;

private:
  struct State {
    bool IsEnabled = true;
    bool IsError = false;
    bool IsNeverError = false;
  };
  static constexpr size_t NumWarnings =
      static_cast<size_t>(FloatingPointWarning::Double) + 1;

  State &stateOf(FloatingPointWarning Warning) {
    return States[static_cast<size_t>(Warning)];
  }

  std::array<State, NumWarnings> States;
  bool AllAreErrors = false;
  bool IgnoreAll = false;
};

/// Prints \p Message, unless \p Warning is off, as tpcc's own: about the
/// command line or the whole program, not about a place in the source.
/// \returns whether the warning is an error.
bool reportWarning(const WarningOptions &Options, FloatingPointWarning Warning,
                   const llvm::Twine &Message);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_WARNINGS_WARNINGOPTIONS_H
