//===- Options.h - Command line of tpsim ------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_OPTIONS_H
#define TP_SIMULATOR_TOOLS_OPTIONS_H

#include "kernels/common/LaunchSetup.h"
#include "kernels/profile/DeletionRecorder.h"
#include "simulator/profile/ProfileTable.h"
#include "simulator/tools/MemoryDump.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// More threads than this are a mistake.
inline constexpr unsigned MaxHostThreads = 1024;

/// The profile markers between which a run is measured.
struct MarkerRegion {
  uint32_t Begin = 0;
  uint32_t End = 0;
};

/// Two runs to compare.
struct ComparisonRequest {
  /// JSON files.
  std::string Before;
  std::string After;
  /// JSON file, `-` for standard output; empty: none.
  std::string Output;
  /// Of each part of the table.
  unsigned Rows = 10;
};

/// What to make of a profile, of the run at hand or one that was written.
struct ProfileRequest {
  /// The profile to read instead of running anything; empty: none.
  std::string Input;
  /// JSON, folded stacks, speedscope and HTML files; empty: none.
  std::string Output;
  std::string FoldedOutput;
  std::string SpeedscopeOutput;
  std::string HtmlOutput;
  ProfileTableOptions Table;
};

/// A TP of a chip.
struct TracedTp {
  uint32_t Tm = 0;
  uint32_t Tp = 0;
};

/// What to trace cycle by cycle.
struct TraceRequest {
  std::vector<TracedTp> Tps;
  /// The cycles from the first to before the second.
  uint64_t FirstCycle = 0;
  uint64_t EndCycle = 10000;
  std::string Output;
};

/// What the user asked for.
struct Options {
  bool Help = false;
  bool Version = false;
  bool Quiet = false;
  bool PrintChip = false;
  bool PrintChipSchema = false;
  /// Then there is no run.
  std::optional<ComparisonRequest> Comparison;
  std::optional<ProfileRequest> Profile;
  std::optional<TraceRequest> Trace;
  std::string Program;
  std::vector<std::string> ProgramArguments;
  std::string Chip;
  /// `<path>=<value>` each.
  std::vector<std::string> ChipSettings;
  /// Empty: no scene.
  std::string Scene;
  RenderOptions Rendering;
  /// PNG file; empty: none.
  std::string ImageOutput;
  /// File for the tree that the kernel built; empty: none.
  std::string BvhOutput;
  /// JSON file, `-` for standard output; empty: none.
  std::string StatisticsOutput;
  /// Also the counts of each instruction.
  bool PerPc = false;
  /// Cycles of an interval of the series, and its CSV or JSON file; 0 and
  /// empty: none.
  uint64_t Interval = 0;
  std::string IntervalOutput;
  std::vector<MemoryDumpRequest> MemoryDumps;
  /// JSON file for a deletion in a cache; empty: none.
  std::string CacheTraceOutput;
  DeletionRequest TracedDeletion;
  /// Text file for the instructions of TracedThread; empty: none.
  std::string InstructionTraceOutput;
  uint32_t TracedThread = 0;
  /// Names of Suppressions.h; empty: no checks.
  std::vector<std::string> Checkers;
  /// Text file with the faults not to show; empty: none.
  std::string CheckSuppressions;
  /// JSON file for the faults, `-` for standard output; empty: none.
  std::string CheckOutput;
  unsigned HostThreads = 1;
  /// Compile hot code.
  bool GenerateCode = true;
  /// 0: no limit.
  uint64_t MaxCycles = 0;
  /// All of the run without timing.
  bool Functional = false;
  /// The marker up to which the run has no timing.
  std::optional<uint32_t> FastForward;
  std::optional<MarkerRegion> Regions;
  /// File for the run's state; empty: none.
  std::string CheckpointOutput;
  /// In cycles; 0: only when the run ends early.
  uint64_t CheckpointEvery = 0;
  /// File with the state to go on from; empty: none.
  std::string RestoreInput;
};

/// Parses the arguments after the program's name. Errors say what is allowed.
llvm::Expected<Options> parseOptions(llvm::ArrayRef<const char *> Arguments);

/// Prints the help text.
void printHelp(llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_OPTIONS_H
