//===- ComparedRun.h - What is compared of a run ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_COMPARE_COMPAREDRUN_H
#define TP_SIMULATOR_COMPARE_COMPAREDRUN_H

#include "simulator/compare/CycleCounts.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A line of the source within a function. Empty or 0 is what nothing is known
/// of.
struct SourceLine {
  std::string Function;
  std::string File;
  uint32_t Line = 0;

  auto operator<=>(const SourceLine &) const = default;
};

/// A number that a run has beside its thread-cycles.
struct Figure {
  /// A share is a number from 0 to 1.
  enum Kind { Count, Share, Number };

  std::string Name;
  Kind Is = Count;
  double Value = 0;
};

/// Thread-cycles of a run, or its instructions if it had no timing.
struct ComparedRun {
  /// Where it was read from.
  std::string Path;
  /// False for a functional run: it has issued instructions and nothing else.
  bool HasCycles = true;
  /// Profiles name files otherwise than statistics do.
  bool IsProfile = false;
  std::string Outcome;
  std::string Chip;
  uint64_t TmCount = 0;
  uint64_t TpsPerTm = 0;
  uint64_t Cycles = 0;
  CycleCounts Counts{};
  /// By innermost source line. Together with the waits of halted threads,
  /// which are at no line, they are Counts. Nothing if the file does not have
  /// them.
  std::optional<std::map<SourceLine, CycleCounts>> Lines;
  /// Instructions issued, by mnemonic.
  std::map<std::string, int64_t> Opcodes;
  std::vector<Figure> Figures;

  uint64_t threads() const { return TmCount * TpsPerTm; }
};

/// Takes a run from \p Text, what `--stats` or `--profile` has written to \p
/// Path. Errors name the file; counts that do not add up are one.
llvm::Expected<ComparedRun> readComparedRun(const std::string &Path,
                                            llvm::StringRef Text);

/// The same from the file.
llvm::Expected<ComparedRun> loadComparedRun(const std::string &Path);

} // namespace tp

#endif // TP_SIMULATOR_COMPARE_COMPAREDRUN_H
