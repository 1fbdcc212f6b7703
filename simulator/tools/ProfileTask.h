//===- ProfileTask.h - The profile of a run ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_PROFILETASK_H
#define TP_SIMULATOR_TOOLS_PROFILETASK_H

#include "simulator/core/ExecutionRecorder.h"
#include "simulator/profile/UtilisationSampler.h"
#include "simulator/stats/RunSummary.h"
#include "simulator/tools/RunLoop.h"
#include "simulator/tools/RunSetup.h"

namespace tp {

/// Records what a profile needs beyond the statistics. It must exist before the
/// machine gets its code generator and outlive it.
class ProfileTask : public RunTask {
public:
  ProfileTask(const ChipConfig &Chip, const RunSetup &Loaded, Engine &Machine);

  uint64_t nextPause() const override { return Tms.nextLook(); }
  llvm::Error pause(Engine &Machine, RunResult::EndKind Now) override;

  /// The profile of the run, which has ended and which \p Run is about.
  Profile finish(const RunSummary &Run);

private:
  const RunSetup &Loaded;
  ExecutionRecorder Recorder;
  UtilisationSampler Tms;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_PROFILETASK_H
