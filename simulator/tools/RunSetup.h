//===- RunSetup.h - What a run of tpsim starts from -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_RUNSETUP_H
#define TP_SIMULATOR_TOOLS_RUNSETUP_H

#include "kernels/profile/RayProfiler.h"
#include "scenes/loader/SceneLoader.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Program.h"
#include "simulator/tools/Options.h"
#include "simulator/tools/ProgramMemory.h"

#include "llvm/Support/Error.h"

#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// Everything that a run needs, in the order in which it is set up.
struct RunSetup {
  ElfProgram Elf;
  std::optional<Scene> Source;
  Program Text;
  Memory Global;
  ProgramMemory Launch;
  LaunchBlock Block = {};
  uint32_t ThreadCount = 0;
  std::vector<MemoryDump> Dumps;
  /// Rays by thread in the part of the run that has no timing; empty if there
  /// is none.
  std::vector<uint32_t> RaysBefore;
  /// Who interprets the run's ray events; null if the user will not see what
  /// they say, also not after a restore.
  std::unique_ptr<RayProfiler> Rays;

  RunSetup(ElfProgram Loaded, std::optional<Scene> Source,
           uint64_t MemoryBytes);

  /// The words of the text.
  std::vector<Opcode> opcodes() const;
};

/// Loads what \p Request names into the memory of \p Chip. Fails now and not
/// after hours if a result could not be written.
llvm::Expected<std::unique_ptr<RunSetup>> setUp(const Options &Request,
                                                const ChipConfig &Chip);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_RUNSETUP_H
