//===- CheckpointTask.h - Saves a run now and then --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_CHECKPOINTTASK_H
#define TP_SIMULATOR_TOOLS_CHECKPOINTTASK_H

#include "simulator/tools/CheckpointFile.h"
#include "simulator/tools/RunConsole.h"
#include "simulator/tools/RunLoop.h"

namespace tp {

/// Saves a run every so many cycles, where the cycle limit will cut it and
/// where the user stops it; restores it. It must be the first of the run's
/// tasks: what the others do in the same pause they do again after a restore.
class CheckpointTask : public RunTask {
public:
  /// Of a run that has been set up and has not begun. \p Others are the run's
  /// other tasks. Everything must outlive it.
  CheckpointTask(const Options &Request, const ChipConfig &Chip,
                 RunSetup &Loaded, RunConsole &Console,
                 std::vector<RunTask *> Others);

  /// Goes on from the file of --restore.
  llvm::Error restore(Engine &Machine);

  uint64_t nextPause() const override;
  llvm::Error pause(Engine &Machine, RunResult::EndKind Now) override;

private:
  void serializeRun(Archive &A, Engine &Machine);

  const Options &Request;
  RunSetup &Loaded;
  RunConsole &Console;
  const std::vector<RunTask *> Others;
  const RunIdentity Identity;
  /// The last beginning of a window up to the cycle limit; 0 if there is none.
  const uint64_t LastBeforeLimit;
  uint64_t Now = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_CHECKPOINTTASK_H
