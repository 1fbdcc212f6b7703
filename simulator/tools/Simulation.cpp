//===- Simulation.cpp - One run of tpsim ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/Simulation.h"

#include "simulator/core/Engine.h"
#include "simulator/jit/Jit.h"
#include "simulator/stats/JsonReport.h"
#include "simulator/stats/SumCheck.h"
#include "simulator/stats/TableReport.h"
#include "simulator/tools/CheckpointTask.h"
#include "simulator/tools/FunctionalRun.h"
#include "simulator/tools/Interrupt.h"
#include "simulator/tools/IntervalTask.h"
#include "simulator/tools/ProfileOutputs.h"
#include "simulator/tools/ProfileTask.h"
#include "simulator/tools/RegionTask.h"
#include "simulator/tools/RunLoop.h"
#include "simulator/tools/RunResults.h"
#include "simulator/tools/TraceTask.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

namespace tp {

void reportError(llvm::Error E) {
  std::string Lines = toString(std::move(E));
  for (StringRef Line : split(Lines, '\n'))
    WithColor::error(errs(), "tpsim") << Line << '\n';
}

/// What is to be done in the pauses of a run.
struct RunTasks {
  std::unique_ptr<CheckpointTask> Checkpoints;
  std::unique_ptr<RegionTask> Regions;
  std::unique_ptr<IntervalTask> Intervals;
  std::unique_ptr<ProfileTask> Profile;
  std::unique_ptr<TraceTask> Trace;

  SmallVector<RunTask *> all() const {
    SmallVector<RunTask *> Tasks;
    for (RunTask *Task : std::initializer_list<RunTask *>{
             Checkpoints.get(), Regions.get(), Intervals.get(), Profile.get()})
      if (Task)
        Tasks.push_back(Task);
    return Tasks;
  }
};

/// Those that must exist before anything has run.
/// \p Recorder is the machine's, if it has one.
static RunTasks makeTasks(const Options &Request, const ChipConfig &Chip,
                          RunSetup &Loaded, RunConsole &Console,
                          ExecutionRecorder *Recorder) {
  RunTasks Tasks;
  if (Request.Profile)
    Tasks.Profile = std::make_unique<ProfileTask>(Chip, Loaded, *Recorder);
  if (Request.Regions)
    Tasks.Regions = std::make_unique<RegionTask>(Request, Loaded);
  if (!Request.CheckpointOutput.empty() || !Request.RestoreInput.empty()) {
    std::vector<RunTask *> Others;
    append_range(Others, Tasks.all());
    Tasks.Checkpoints = std::make_unique<CheckpointTask>(
        Request, Chip, Loaded, Console, std::move(Others));
  }
  return Tasks;
}

/// Writes the profile's files and table.
static llvm::Error writeProfile(const Profile &Data,
                                const ProfileRequest &Request, bool IsQuiet) {
  if (!IsQuiet) {
    errs() << '\n';
    writeProfileTable(Data, Request.Table, errs());
  }
  return writeProfileFiles(Data, Request);
}

/// Writes the results of a run that has ended.
static Expected<int> report(const RunResult &Result, const Options &Request,
                            const ChipConfig &Chip, RunSetup &Loaded,
                            const RunTasks &Tasks, const HostSpeed &Speed,
                            const Engine &Machine) {
  llvm::Error Failures = llvm::Error::success();
  auto Note = [&Failures](llvm::Error E) {
    Failures = joinErrors(std::move(Failures), std::move(E));
  };
  Statistics Stats = Machine.statistics();
  RunSummary Run = summaryOf(Result, Request, Loaded, Chip, Stats);
  if (Tasks.Regions) {
    if (llvm::Error E = Tasks.Regions->statistics(Machine).moveInto(Stats))
      Note(std::move(E));
    Run.Rays = Tasks.Regions->rays();
  }
  Note(writeResults(Run, Request, Loaded, writeJson));
  if (Tasks.Intervals)
    Note(Tasks.Intervals->finish(Machine));
  Note(checkSums(Chip, Stats, Run.Opcodes));
  if (!Request.Quiet)
    writeTable(Run, Speed, errs());
  if (Tasks.Profile && Request.Profile)
    Note(writeProfile(Tasks.Profile->finish(Run), *Request.Profile,
                      Request.Quiet));
  if (Tasks.Trace)
    Note(Tasks.Trace->finish(Run.Stats));
  explainEnd(Result, Request, Chip, Loaded.Elf, TrapClock::Cycles,
             [&](unsigned Register) {
               return Machine.registerOf(Result.TrapInfo->Thread, Register);
             });
  if (Failures)
    return Failures;
  return Run.ExitStatus;
}

/// Runs \p Machine to its end and reports.
static Expected<int> runInCycles(const Options &Request, const ChipConfig &Chip,
                                 RunSetup &Loaded, RunConsole &Console,
                                 RunTasks &Tasks, Engine &Machine) {
  RunLimits Limits;
  Limits.MaxCycles = Request.MaxCycles;
  Limits.Stop = &stopOnInterrupt();
  Limits.Report = [&](const Progress &Now) { Console.report(Now); };
  if (Request.Interval != 0)
    if (llvm::Error E =
            IntervalTask::start(Request, Chip, Loaded.opcodes(), Machine)
                .moveInto(Tasks.Intervals))
      return E;
  uint64_t Before = Machine.progress().Instructions;
  Expected<RunResult> Result = runToEnd(Machine, Limits, Tasks.all());
  HostSpeed Speed{Console.finish(), Request.HostThreads,
                  Machine.progress().Instructions - Before};
  if (!Result)
    return Result.takeError();
  return report(*Result, Request, Chip, Loaded, Tasks, Speed, Machine);
}

Expected<int> simulate(const Options &Request, const ChipConfig &Chip) {
  Expected<std::unique_ptr<RunSetup>> Setup = setUp(Request, Chip);
  if (!Setup)
    return Setup.takeError();
  RunSetup &Loaded = **Setup;
  RunConsole Console(Request, Loaded);
  if (Request.Functional)
    return runFunctionally(Request, Chip, Loaded, Console);

  Engine Machine(Chip, Loaded.Text, Loaded.Global, makeMemorySystem(Chip));
  if (!Machine.error().empty())
    return createStringError(Machine.error());
  Machine.setHostThreads(Request.HostThreads);
  std::unique_ptr<ExecutionRecorder> Recorder;
  if (Request.Profile || Request.Trace) {
    Recorder = makeRecorder(Chip, Loaded);
    Machine.setRecorder(*Recorder);
  }
  if (Request.GenerateCode) {
    Expected<std::unique_ptr<CodeGenerator>> Generator = makeJit();
    if (!Generator)
      return Generator.takeError();
    Machine.setCodeGenerator(std::move(*Generator));
  }
  Machine.setOutput(
      [&](int Fd, std::string_view Bytes) { Console.write(Fd, Bytes); });
  Machine.setObserver(Loaded.Rays.get());
  RunTasks Tasks = makeTasks(Request, Chip, Loaded, Console, Recorder.get());
  if (Request.Trace)
    if (llvm::Error E =
            TraceTask::start(*Request.Trace, Chip, Loaded, *Recorder, Machine)
                .moveInto(Tasks.Trace))
      return E;
  if (!Request.RestoreInput.empty()) {
    if (llvm::Error E = Tasks.Checkpoints->restore(Machine))
      return E;
  } else if (Request.FastForward) {
    Expected<std::optional<int>> End =
        fastForward(Request, Chip, Loaded, Console, Machine);
    if (!End)
      return End.takeError();
    if (const std::optional<int> &Status = *End)
      return *Status;
  }
  return runInCycles(Request, Chip, Loaded, Console, Tasks, Machine);
}

} // namespace tp
