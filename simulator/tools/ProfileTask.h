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

/// What a profile or trace needs beyond the statistics.
std::unique_ptr<ExecutionRecorder> makeRecorder(const ChipConfig &Chip,
                                                const RunSetup &Loaded);

/// Looks at the run from time to time, for its profile.
class ProfileTask : public RunTask {
public:
  /// \p Recorder is the machine's.
  ProfileTask(const ChipConfig &Chip, const RunSetup &Loaded,
              ExecutionRecorder &Recorder)
      : Loaded(Loaded), Recorder(Recorder), Tms(Chip) {}

  uint64_t nextPause() const override { return Tms.nextLook(); }
  llvm::Error pause(Engine &Machine, RunResult::EndKind Now) override;
  void serialize(Archive &A) override;

  /// The profile of the run, which has ended and which \p Run is about.
  Profile finish(const RunSummary &Run);

private:
  const RunSetup &Loaded;
  ExecutionRecorder &Recorder;
  UtilisationSampler Tms;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_PROFILETASK_H
