//===- FunctionalRun.cpp - A run, or its beginning, without timing --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/FunctionalRun.h"

#include "simulator/functional/FunctionalJit.h"
#include "simulator/functional/FunctionalMachine.h"
#include "simulator/stats/FunctionalReport.h"
#include "simulator/tools/CheckTask.h"
#include "simulator/tools/InstructionTrace.h"
#include "simulator/tools/Interrupt.h"
#include "simulator/tools/RunResults.h"

using namespace llvm;

namespace tp {

static Expected<RunResult> run(FunctionalMachine &Machine,
                               const Options &Request, RunSetup &Loaded,
                               RunConsole &Console,
                               std::optional<uint32_t> StopMarker) {
  if (Request.GenerateCode && Request.InstructionTraceOutput.empty() &&
      Request.Checkers.empty()) {
    Expected<std::unique_ptr<FunctionalCodeGenerator>> Generator =
        makeFunctionalJit();
    if (!Generator)
      return Generator.takeError();
    Machine.setCodeGenerator(std::move(*Generator));
  }
  Machine.setOutput(
      [&](int Fd, std::string_view Bytes) { Console.write(Fd, Bytes); });
  Machine.setObserver(Loaded.Rays.get());
  FunctionalLimits Limits;
  Limits.StopMarker = StopMarker;
  Limits.Stop = &stopOnInterrupt();
  Limits.Report = [&](const Progress &Now) { Console.report(Now); };
  return Machine.run(Limits);
}

static void explainEnd(const RunResult &Result, const Options &Request,
                       const ChipConfig &Chip, const RunSetup &Loaded,
                       const FunctionalMachine &Machine) {
  explainEnd(Result, Request, Chip, Loaded.Elf, TrapClock::Instructions,
             [&](unsigned Register) {
               return Machine.registerOf(Result.TrapInfo->Thread, Register);
             });
}

Expected<int> runFunctionally(const Options &Request, const ChipConfig &Chip,
                              RunSetup &Loaded, RunConsole &Console) {
  FunctionalMachine Machine(Chip, Loaded.Text, Loaded.Global);
  if (!Machine.error().empty())
    return createStringError(Machine.error());
  InstructionTrace Trace;
  if (!Request.InstructionTraceOutput.empty())
    if (llvm::Error Failure = Trace.start(Machine, Chip, Request))
      return Failure;
  std::unique_ptr<CheckTask> Checks;
  if (!Request.Checkers.empty())
    if (llvm::Error Failure =
            CheckTask::start(Request, Chip, Loaded, Machine).moveInto(Checks))
      return Failure;
  Expected<RunResult> Ended =
      run(Machine, Request, Loaded, Console, std::nullopt);
  if (!Ended)
    return Ended.takeError();
  if (llvm::Error Failure = Trace.finish())
    return Failure;
  const RunResult &Result = *Ended;
  HostSpeed Speed{Console.finish(), 1};

  Statistics Stats = Machine.statistics();
  RunSummary Run = summaryOf(Result, Request, Loaded, Chip, Stats);
  llvm::Error Failures =
      writeResults(Run, Request, Loaded, writeFunctionalJson);
  Failures = joinErrors(std::move(Failures), checkFunctionalSums(Chip, Stats));
  if (!Request.Quiet)
    writeFunctionalTable(Run, Speed, errs());
  explainEnd(Result, Request, Chip, Loaded, Machine);
  if (Checks)
    Failures = joinErrors(std::move(Failures), Checks->finish(Result));
  if (Failures)
    return Failures;
  if (Checks && Checks->hasFaults() && Run.ExitStatus == 0)
    return 1;
  return Run.ExitStatus;
}

Expected<std::optional<int>> fastForward(const Options &Request,
                                         const ChipConfig &Chip,
                                         RunSetup &Loaded, RunConsole &Console,
                                         Engine &Machine) {
  FunctionalMachine Beginning(Chip, Loaded.Text, Loaded.Global);
  if (!Beginning.error().empty())
    return createStringError(Beginning.error());
  Expected<RunResult> Ended =
      run(Beginning, Request, Loaded, Console, Request.FastForward);
  if (!Ended)
    return Ended.takeError();
  const RunResult &Result = *Ended;
  if (Result.End == RunResult::Halted)
    return createStringError(
        "--fast-forward " + Twine(*Request.FastForward) +
        ": all threads halted before that marker; the program passes it "
        "nowhere (__builtin_tp_prof), or only some threads do");
  if (Result.End != RunResult::Paused) {
    Console.finish();
    explainEnd(Result, Request, Chip, Loaded, Beginning);
    return exitStatus(Result);
  }
  Machine.setInitialState(Beginning.threads());
  if (Loaded.Source)
    Loaded.RaysBefore =
        readRayCounts(Loaded.Block, Loaded.ThreadCount, Loaded.Launch);
  return std::nullopt;
}

} // namespace tp
