//===- CheckedProgram.h - What checkers know of a program -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_CHECKEDPROGRAM_H
#define TP_SIMULATOR_CHECK_CHECKEDPROGRAM_H

#include "runtime/include/tp/check.h"
#include "simulator/check/CallContexts.h"
#include "simulator/check/MemoryNames.h"
#include "simulator/check/Report.h"

#include <cstdint>
#include <vector>

namespace tp {

/// A program that runs under checks, and what has been found out about it. All
/// checkers of the run share it.
struct CheckedProgram {
  const ElfProgram &Elf;
  const MemoryNames &Names;
  Reports &Found;
  /// Free memory, which the program's heap gets: [HeapBegin, HeapEnd).
  uint32_t HeapBegin = 0;
  uint32_t HeapEnd = 0;
  /// The globals that have padding behind them.
  std::vector<CheckedGlobal> Globals;
  /// By address.
  std::vector<LaunchPart> Launch;
  CallContexts Contexts;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_CHECKEDPROGRAM_H
