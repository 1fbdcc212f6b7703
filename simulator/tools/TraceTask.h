//===- TraceTask.h - The trace of chosen TPs --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_TRACETASK_H
#define TP_SIMULATOR_TOOLS_TRACETASK_H

#include "simulator/core/Engine.h"
#include "simulator/profile/ThreadTrace.h"
#include "simulator/tools/Options.h"
#include "simulator/tools/RunSetup.h"

#include "llvm/Support/Error.h"

namespace tp {

/// Traces threads of a run that has no code generator.
class TraceTask {
public:
  /// Begins before the run. \p Recorder is the machine's. Fails if the chip
  /// does not have the TPs.
  static llvm::Expected<std::unique_ptr<TraceTask>>
  start(const TraceRequest &Request, const ChipConfig &Chip,
        const RunSetup &Loaded, ExecutionRecorder &Recorder, Engine &Machine);

  /// Writes the trace of the run, which has ended with these statistics.
  llvm::Error finish(const Statistics &Now);

private:
  TraceTask(const TraceRequest &Request, const ChipConfig &Chip,
            const RunSetup &Loaded, ExecutionRecorder &Recorder,
            llvm::ArrayRef<uint32_t> Threads);

  const TraceRequest &Request;
  const ChipConfig &Chip;
  const RunSetup &Loaded;
  ExecutionRecorder &Recorder;
  ThreadTracer Tracer;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_TRACETASK_H
