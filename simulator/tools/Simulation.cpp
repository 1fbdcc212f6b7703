//===- Simulation.cpp - One run of tpsim ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/Simulation.h"

#include "simulator/core/Engine.h"
#include "simulator/stats/TableReport.h"
#include "simulator/tools/Interrupt.h"
#include "simulator/tools/ProgressLine.h"
#include "simulator/tools/RunLoop.h"
#include "simulator/tools/RunResults.h"
#include "simulator/tools/RunSetup.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

namespace tp {

void reportError(llvm::Error E) {
  std::string Lines = toString(std::move(E));
  for (StringRef Line : split(Lines, '\n'))
    WithColor::error(errs(), "tpsim") << Line << '\n';
}

/// Passes the program's output on, so that nothing else is on standard output.
static OutputFunction passOn(ProgressLine &Line) {
  return [&Line](int Fd, std::string_view Bytes) {
    Line.clear();
    raw_fd_ostream &OS = Fd == 2 ? errs() : outs();
    OS << Bytes;
    if (OS.is_displayed())
      OS.flush();
  };
}

/// The limits that the user set, with a progress line.
static RunLimits limitsOf(const Options &Request, const RunSetup &Loaded,
                          uint32_t Threads, ProgressLine &Line) {
  RunLimits Limits;
  Limits.MaxCycles = Request.MaxCycles;
  Limits.Stop = &stopOnInterrupt();
  Limits.Report = [&Line, &Loaded, Threads](const Progress &Now) {
    std::optional<double> Share;
    if (Loaded.Source) {
      double Pixels = double(Loaded.Block.Width) * Loaded.Block.Height;
      Share = readPixelsTaken(Loaded.Block, Threads, Loaded.Launch) / Pixels;
    }
    Line.update(Now, Share);
    outs().flush();
  };
  return Limits;
}

Expected<int> simulate(const Options &Request, const ChipConfig &Chip) {
  Expected<std::unique_ptr<RunSetup>> Setup = setUp(Request, Chip);
  if (!Setup)
    return Setup.takeError();
  RunSetup &Loaded = **Setup;
  Engine Machine(Chip, Loaded.Text, Loaded.Global);
  if (!Machine.error().empty())
    return createStringError(Machine.error());
  ProgressLine Line(!Request.Quiet);
  Machine.setHostThreads(Request.HostThreads);
  Machine.setOutput(passOn(Line));
  Machine.setObserver(Loaded.Rays.get());

  SmallVector<RunTask *> Tasks;
  Expected<RunResult> Result = runToEnd(
      Machine, limitsOf(Request, Loaded, Chip.threadCount(), Line), Tasks);
  HostSpeed Speed{Line.seconds(), Request.HostThreads};
  Line.clear();
  if (!Result)
    return Result.takeError();

  Statistics Stats = Machine.statistics();
  RunSummary Run = summaryOf(*Result, Request, Loaded, Chip, Stats);
  llvm::Error Failures = writeResults(Run, Request, Loaded);
  if (!Request.Quiet)
    writeTable(Run, Speed, errs());
  explainEnd(*Result, Request, Chip, Loaded.Elf, [&](unsigned Register) {
    return Machine.registerOf(Result->TrapInfo->Thread, Register);
  });
  if (Failures)
    return Failures;
  return Run.ExitStatus;
}

} // namespace tp
