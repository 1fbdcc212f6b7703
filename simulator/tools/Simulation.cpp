//===- Simulation.cpp - One run of tpsim ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/Simulation.h"

#include "simulator/core/Engine.h"
#include "simulator/stats/JsonReport.h"
#include "simulator/stats/SumCheck.h"
#include "simulator/stats/TableReport.h"
#include "simulator/tools/FunctionalRun.h"
#include "simulator/tools/Interrupt.h"
#include "simulator/tools/IntervalTask.h"
#include "simulator/tools/RunLoop.h"
#include "simulator/tools/RunResults.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

namespace tp {

void reportError(llvm::Error E) {
  std::string Lines = toString(std::move(E));
  for (StringRef Line : split(Lines, '\n'))
    WithColor::error(errs(), "tpsim") << Line << '\n';
}

/// Runs \p Machine to its end and reports.
static Expected<int> runInCycles(const Options &Request, const ChipConfig &Chip,
                                 RunSetup &Loaded, RunConsole &Console,
                                 Engine &Machine) {
  RunLimits Limits;
  Limits.MaxCycles = Request.MaxCycles;
  Limits.Stop = &stopOnInterrupt();
  Limits.Report = [&](const Progress &Now) { Console.report(Now); };
  SmallVector<RunTask *> Tasks;
  std::unique_ptr<IntervalTask> Intervals;
  if (Request.Interval != 0) {
    if (llvm::Error E =
            IntervalTask::start(Request, Chip, Loaded.opcodes(), Machine)
                .moveInto(Intervals))
      return E;
    Tasks.push_back(Intervals.get());
  }
  Expected<RunResult> Result = runToEnd(Machine, Limits, Tasks);
  HostSpeed Speed{Console.finish(), Request.HostThreads};
  if (!Result)
    return Result.takeError();

  Statistics Stats = Machine.statistics();
  RunSummary Run = summaryOf(*Result, Request, Loaded, Chip, Stats);
  llvm::Error Failures = writeResults(Run, Request, Loaded, writeJson);
  if (Intervals)
    Failures = joinErrors(std::move(Failures), Intervals->finish(Machine));
  Failures =
      joinErrors(std::move(Failures), checkSums(Chip, Stats, Run.Opcodes));
  if (!Request.Quiet)
    writeTable(Run, Speed, errs());
  explainEnd(*Result, Request, Chip, Loaded.Elf, TrapClock::Cycles,
             [&](unsigned Register) {
               return Machine.registerOf(Result->TrapInfo->Thread, Register);
             });
  if (Failures)
    return Failures;
  return Run.ExitStatus;
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
  Machine.setOutput(
      [&](int Fd, std::string_view Bytes) { Console.write(Fd, Bytes); });
  Machine.setObserver(Loaded.Rays.get());
  if (Request.FastForward) {
    Expected<std::optional<int>> End =
        fastForward(Request, Chip, Loaded, Console, Machine);
    if (!End)
      return End.takeError();
    if (*End)
      return **End;
  }
  return runInCycles(Request, Chip, Loaded, Console, Machine);
}

} // namespace tp
