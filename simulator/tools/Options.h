//===- Options.h - Command line of tpsim ------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_OPTIONS_H
#define TP_SIMULATOR_TOOLS_OPTIONS_H

#include "kernels/common/LaunchSetup.h"
#include "kernels/profile/DeletionRecorder.h"
#include "simulator/tools/MemoryDump.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// More threads than this are a mistake.
inline constexpr unsigned MaxHostThreads = 1024;

/// What the user asked for.
struct Options {
  bool Help = false;
  bool Version = false;
  bool Quiet = false;
  bool PrintChip = false;
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
  std::vector<MemoryDumpRequest> MemoryDumps;
  /// JSON file for a deletion in a cache; empty: none.
  std::string CacheTraceOutput;
  DeletionRequest TracedDeletion;
  unsigned HostThreads = 1;
  /// 0: no limit.
  uint64_t MaxCycles = 0;
};

/// Parses the arguments after the program's name. Errors say what is allowed.
llvm::Expected<Options> parseOptions(llvm::ArrayRef<const char *> Arguments);

/// Prints the help text.
void printHelp(llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_OPTIONS_H
