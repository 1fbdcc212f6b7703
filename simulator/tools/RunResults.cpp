//===- RunResults.cpp - What a run of tpsim leaves behind -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/RunResults.h"

#include "kernels/common/BuiltBvh.h"
#include "scenes/image/PngWriter.h"
#include "simulator/tools/CacheTrace.h"
#include "simulator/tools/OutputFile.h"
#include "simulator/tools/Simulation.h"

#include "llvm/Support/WithColor.h"

using namespace llvm;

namespace tp {

static const char *outcomeName(RunResult::EndKind End) {
  switch (End) {
  case RunResult::Halted:
    return "finished";
  case RunResult::Trapped:
    return "trapped";
  case RunResult::CycleLimit:
    return "cycle_limit";
  case RunResult::Stopped:
  case RunResult::Paused:
    return "interrupted";
  }
  llvm_unreachable("every end has a name");
}

int exitStatus(const RunResult &Result) {
  switch (Result.End) {
  case RunResult::Halted:
    return Result.ExitStatus;
  case RunResult::Trapped:
  case RunResult::CycleLimit:
    return 1;
  case RunResult::Stopped:
  case RunResult::Paused:
    return InterruptedStatus;
  }
  llvm_unreachable("every end has a status");
}

RunSummary summaryOf(const RunResult &Result, const Options &Request,
                     const RunSetup &Loaded, const ChipConfig &Chip,
                     const Statistics &Stats) {
  RunSummary Run{Chip, Stats,       outcomeName(Result.End), exitStatus(Result),
                 {},   std::nullopt};
  Run.TextBegin = Loaded.Text.textBegin();
  Run.Opcodes = Loaded.opcodes();
  if (Request.PerPc)
    Run.FramesOf = [Symbols = std::make_shared<Symbolizer>(Loaded.Elf)](
                       uint32_t Pc) { return Symbols->frames(Pc); };
  if (!Loaded.Source)
    return Run;
  const RenderOptions &Image = Request.Rendering;
  Run.Rays = readRayCounts(Loaded.Block, Chip.threadCount(), Loaded.Launch);
  for (size_t I = 0; I != Loaded.RaysBefore.size(); ++I)
    Run.Rays[I] -= Loaded.RaysBefore[I];
  Run.Image = ImageSettings{Image.Width, Image.Height, Image.SamplesPerPixel,
                            Image.MaxDepth, Image.Seed};
  return Run;
}

/// Checks the run's ray events and adds them to \p Run.
static llvm::Error addRayProfiles(const RayProfiler &Rays, RunSummary &Run) {
  if (Status S = Rays.check(); !S)
    return createStringError(S.message());
  std::vector<RayProfile> Threads = Rays.threads();
  if (sumOf(Threads))
    Run.RayProfiles = std::move(Threads);
  return llvm::Error::success();
}

/// Verifies the tree that a finished kernel built, and prints what it is.
static llvm::Error checkBvh(const Options &Request, const LaunchBlock &Launch,
                            const ProgramMemory &Memory) {
  ErrorOr<std::string> Tree = checkBuiltBvh(Launch, Memory, Request.BvhOutput);
  if (!Tree)
    return createStringError(Request.Program + ": " + Tree.message());
  errs() << *Tree << '\n';
  return llvm::Error::success();
}

/// Prints and writes the deletion that the user asked for.
static llvm::Error writeCacheTrace(const RayProfiler &Rays,
                                   const Options &Request,
                                   const LaunchBlock &Launch,
                                   const ProgramMemory &Memory) {
  ErrorOr<const DeletionRecord *> Record = Rays.recordedDeletion();
  if (!Record)
    return createStringError("--trace-cache: " + Record.message());
  Expected<CacheTrace> Trace =
      traceDeletion(Request.TracedDeletion, **Record, Launch, Memory);
  if (!Trace)
    return Trace.takeError();
  writeTable(*Trace, errs());
  return writeTo(Request.CacheTraceOutput,
                 [&](raw_ostream &OS) { writeJson(*Trace, OS); });
}

static llvm::Error writeOutputs(const RunSummary &Run, const Options &Request,
                                const LaunchBlock &Launch,
                                const ProgramMemory &Memory,
                                JsonFunction &WriteJson) {
  llvm::Error Failures = llvm::Error::success();
  auto Note = [&Failures](llvm::Error E) {
    Failures = joinErrors(std::move(Failures), std::move(E));
  };
  if (!Request.ImageOutput.empty())
    if (Status S =
            writePng(Request.ImageOutput, readFramebuffer(Launch, Memory));
        !S)
      Note(createStringError(S.message()));
  if (!Request.StatisticsOutput.empty())
    Note(writeTo(Request.StatisticsOutput,
                 [&](raw_ostream &OS) { WriteJson(Run, OS); }));
  return Failures;
}

llvm::Error writeResults(RunSummary &Run, const Options &Request,
                         const RunSetup &Loaded, JsonFunction &WriteJson) {
  llvm::Error Failures =
      Loaded.Rays ? addRayProfiles(*Loaded.Rays, Run) : llvm::Error::success();
  auto Note = [&Failures](llvm::Error E) {
    Failures = joinErrors(std::move(Failures), std::move(E));
  };
  Note(writeOutputs(Run, Request, Loaded.Block, Loaded.Launch, WriteJson));
  Note(flushOutput());
  if (!Request.CacheTraceOutput.empty())
    Note(writeCacheTrace(*Loaded.Rays, Request, Loaded.Block, Loaded.Launch));
  for (const MemoryDump &Dump : Loaded.Dumps)
    Note(write(Dump, Loaded.Global));
  if (Request.Rendering.Bvh == BvhOrigin::Kernel && Run.ExitStatus == 0)
    Note(checkBvh(Request, Loaded.Block, Loaded.Launch));
  return Failures;
}

void explainEnd(const RunResult &Result, const Options &Request,
                const ChipConfig &Chip, const ElfProgram &Elf, TrapClock Clock,
                const RegisterFunction &Registers) {
  if (const std::optional<Trap> &Cause = Result.TrapInfo) {
    Symbolizer Symbols(Elf);
    WithColor::error(errs(), "tpsim")
        << trapMessage(*Cause, Clock, Chip, Elf, Symbols, Registers) << '\n';
  } else if (Result.End == RunResult::CycleLimit) {
    WithColor::error(errs(), "tpsim")
        << "stopped after " << Request.MaxCycles << " cycles (--max-cycles)\n";
  } else if (Result.End == RunResult::Stopped) {
    WithColor::error(errs(), "tpsim") << "interrupted\n";
  }
}

} // namespace tp
