//===- TraceTask.cpp - The trace of chosen TPs ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/TraceTask.h"

#include "simulator/profile/TraceFile.h"
#include "simulator/tools/OutputFile.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp {

Expected<std::unique_ptr<TraceTask>>
TraceTask::start(const TraceRequest &Request, const ChipConfig &Chip,
                 const RunSetup &Loaded, ExecutionRecorder &Recorder,
                 Engine &Machine) {
  std::vector<uint32_t> Threads;
  for (const TracedTp &Which : Request.Tps) {
    if (Which.Tm >= Chip.TmCount || Which.Tp >= Chip.TpsPerTm)
      return createStringError("--trace-tps " + Twine(Which.Tm) + "." +
                               Twine(Which.Tp) + ": the chip has TMs 0 to " +
                               Twine(Chip.TmCount - 1) + " with TPs 0 to " +
                               Twine(Chip.TpsPerTm - 1));
    uint32_t Thread = Which.Tm * Chip.TpsPerTm + Which.Tp;
    if (!is_contained(Threads, Thread))
      Threads.push_back(Thread);
  }
  std::unique_ptr<TraceTask> Task(
      new TraceTask(Request, Chip, Loaded, Recorder, Threads));
  Machine.setIssueObserver(
      &Task->Tracer,
      std::vector<bool>(Loaded.Text.instructions().size(), true));
  return Task;
}

TraceTask::TraceTask(const TraceRequest &Request, const ChipConfig &Chip,
                     const RunSetup &Loaded, ExecutionRecorder &Recorder,
                     ArrayRef<uint32_t> Threads)
    : Request(Request), Chip(Chip), Loaded(Loaded), Recorder(Recorder),
      Tracer(Chip, Loaded.Text, Threads,
             {Request.FirstCycle, Request.EndCycle}) {
  for (uint32_t Thread : Threads)
    Recorder.traceRequests(Thread, Request.FirstCycle, Request.EndCycle);
}

llvm::Error TraceTask::finish(const Statistics &Now) {
  std::vector<ThreadTrace> Traces =
      Tracer.finish(Now, Recorder.tracedRequests());
  return writeTo(Request.Output, [&](raw_ostream &OS) {
    writeThreadTraces(Traces, Chip, Loaded.Elf, OS);
  });
}

} // namespace tp
