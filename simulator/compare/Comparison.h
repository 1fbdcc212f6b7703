//===- Comparison.h - What changed between two runs -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_COMPARE_COMPARISON_H
#define TP_SIMULATOR_COMPARE_COMPARISON_H

#include "simulator/compare/ComparedRun.h"

#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Thread-cycles of the two runs.
struct ComparedCounts {
  CycleCounts Before{};
  CycleCounts After{};

  /// Of one use, or of all.
  int64_t change(unsigned Use) const { return After[Use] - Before[Use]; }
  int64_t change() const { return sumOf(After) - sumOf(Before); }
  bool operator==(const ComparedCounts &) const = default;
};

/// What was counted at a place.
struct ComparedPlace {
  /// Of a function line 0.
  SourceLine Name;
  ComparedCounts Counts;

  int64_t change() const { return Counts.change(); }
};

/// Instructions issued with one operation code.
struct ComparedOpcode {
  std::string Name;
  int64_t Before = 0;
  int64_t After = 0;

  int64_t change() const { return After - Before; }
};

/// Two runs and how the second differs from the first.
struct Comparison {
  const ComparedRun &Before;
  const ComparedRun &After;
  ComparedCounts Counts;
  /// Whether both runs have lines that can be compared; otherwise there are no
  /// places.
  bool HasPlaces = false;
  /// All functions and lines of either run, the largest change first. Waits of
  /// halted threads are at none of them.
  std::vector<ComparedPlace> Functions;
  std::vector<ComparedPlace> Lines;
  /// All of either run, the largest change first.
  std::vector<ComparedOpcode> Opcodes;
};

/// Compares two runs, which are kept by reference. Fails if one has cycles and
/// the other has none.
llvm::Expected<Comparison> compare(const ComparedRun &Before,
                                   const ComparedRun &After);

/// For people: \p Rows places of each kind, and the rest of them as one.
void writeTable(const Comparison &Runs, unsigned Rows, llvm::raw_ostream &OS);

/// For programs, everything; docs/comparison.schema.json describes the names.
void writeJson(const Comparison &Runs, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_COMPARE_COMPARISON_H
