//===- Simulation.cpp - One run of tpsim ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/Simulation.h"

#include "kernels/common/BuiltBvh.h"
#include "kernels/profile/RayProfiler.h"
#include "scenes/image/PngWriter.h"
#include "scenes/loader/SceneLoader.h"
#include "simulator/core/Engine.h"
#include "simulator/loader/Symbolizer.h"
#include "simulator/stats/JsonReport.h"
#include "simulator/stats/TableReport.h"
#include "simulator/tools/CacheTrace.h"
#include "simulator/tools/Interrupt.h"
#include "simulator/tools/ProgramMemory.h"
#include "simulator/tools/ProgressLine.h"
#include "simulator/tools/TrapMessage.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Process.h"
#include "llvm/Support/WithColor.h"

#include <algorithm>

using namespace llvm;

namespace tp {

void reportError(llvm::Error E) {
  std::string Lines = toString(std::move(E));
  for (StringRef Line : split(Lines, '\n'))
    WithColor::error(errs(), "tpsim") << Line << '\n';
}

/// Decodes the executable segment.
static Program decodeText(const ElfProgram &Elf) {
  const Segment &Text = Elf.text();
  std::vector<uint32_t> Words(Text.Contents.size() / sizeof(uint32_t));
  std::memcpy(Words.data(), Text.Contents.data(),
              Words.size() * sizeof(uint32_t));
  Program Decoded(Text.Address, Words, Elf.entry(), uint32_t(Text.end()));
  for (const AddressRange &Function : Elf.floatChecked())
    Decoded.addFloatChecked(Function.Begin, Function.End);
  Decoded.setStackLimit(Elf.stackLimit().value_or(0));
  return Decoded;
}

/// Fails now and not after hours if \p Path cannot be written.
static llvm::Error checkWritable(StringRef Path) {
  int File;
  std::error_code EC = sys::fs::openFileForWrite(
      Path, File, sys::fs::CD_OpenAlways, sys::fs::OF_Append);
  if (!EC)
    EC = sys::Process::SafelyCloseFileDescriptor(File);
  if (EC)
    return createStringError("cannot write " + Path + ": " + EC.message());
  return llvm::Error::success();
}

static llvm::Error checkOutputs(const Options &Request) {
  SmallVector<StringRef> Paths = {Request.ImageOutput, Request.BvhOutput,
                                  Request.StatisticsOutput,
                                  Request.CacheTraceOutput};
  for (const MemoryDumpRequest &Dump : Request.MemoryDumps)
    Paths.push_back(Dump.Path);
  for (StringRef Path : Paths)
    if (!Path.empty() && Path != "-")
      if (llvm::Error E = checkWritable(Path))
        return E;
  return llvm::Error::success();
}

static Expected<std::vector<MemoryDump>> locateDumps(const Options &Request,
                                                     const ElfProgram &Elf,
                                                     const Memory &Global) {
  std::vector<MemoryDump> Dumps;
  for (const MemoryDumpRequest &Wanted : Request.MemoryDumps) {
    Expected<MemoryDump> Dump = locate(Wanted, Elf, Global);
    if (!Dump)
      return Dump.takeError();
    Dumps.push_back(std::move(*Dump));
  }
  return Dumps;
}

static Expected<std::optional<Scene>>
loadRequestedScene(const Options &Request) {
  if (Request.Scene.empty())
    return std::nullopt;
  ErrorOr<Scene> Loaded = loadScene(Request.Scene);
  if (!Loaded)
    return createStringError(Loaded.message());
  for (const std::string &Warning : Loaded->Warnings)
    WithColor::warning(errs(), "tpsim") << Warning << '\n';
  return std::move(*Loaded);
}

/// Writes what \p Write writes to the file at \p Path, or to standard output if
/// that is `-`.
static llvm::Error writeTo(const std::string &Path,
                           function_ref<void(raw_ostream &)> Write) {
  if (Path == "-") {
    Write(outs());
    return llvm::Error::success();
  }
  std::error_code EC;
  raw_fd_ostream File(Path, EC);
  if (!EC) {
    Write(File);
    File.close();
    EC = File.error();
    File.clear_error();
  }
  if (EC)
    return createStringError("cannot write " + Path + ": " + EC.message());
  return llvm::Error::success();
}

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

static int exitStatus(const RunResult &Result) {
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

/// Why the run did not end as the program wanted, to standard error.
static void explainEnd(const RunResult &Result, const Options &Request,
                       const ChipConfig &Chip, const ElfProgram &Elf,
                       const Engine &Machine) {
  if (const std::optional<Trap> &Cause = Result.TrapInfo) {
    Symbolizer Symbols(Elf);
    WithColor::error(errs(), "tpsim")
        << trapMessage(*Cause, Chip, Elf, Symbols,
                       [&](unsigned Register) {
                         return Machine.registerOf(Cause->Thread, Register);
                       })
        << '\n';
  } else if (Result.End == RunResult::CycleLimit) {
    WithColor::error(errs(), "tpsim")
        << "stopped after " << Request.MaxCycles << " cycles (--max-cycles)\n";
  } else if (Result.End == RunResult::Stopped) {
    WithColor::error(errs(), "tpsim") << "interrupted\n";
  }
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

static llvm::Error writeResults(const RunSummary &Run, const Options &Request,
                                const LaunchBlock &Launch,
                                const ProgramMemory &Memory) {
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
                 [&](raw_ostream &OS) { writeJson(Run, OS); }));
  Note(checkSums(Run.Chip, Run.Stats));
  outs().flush();
  if (outs().has_error()) {
    Note(createStringError("cannot write standard output: " +
                           outs().error().message()));
    outs().clear_error();
  }
  return Failures;
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

/// Everything that a run needs, in the order in which it is set up.
struct Setup {
  ElfProgram Elf;
  std::optional<Scene> Source;
  Memory Global;
  ProgramMemory Launch;
  LaunchBlock Block = {};

  Setup(ElfProgram Loaded, std::optional<Scene> Source, uint64_t MemoryBytes)
      : Elf(std::move(Loaded)), Source(std::move(Source)), Global(MemoryBytes),
        Launch(Elf, Global) {}
};

static Expected<std::unique_ptr<Setup>> setUp(const Options &Request,
                                              const ChipConfig &Chip) {
  Expected<ElfProgram> Elf = ElfProgram::load(Request.Program);
  if (!Elf)
    return Elf.takeError();
  if (llvm::Error E = Elf->checkFits(Chip.MemoryBytes, Chip.LocalStoreBytes))
    return E;
  Expected<std::optional<Scene>> Source = loadRequestedScene(Request);
  if (!Source)
    return Source.takeError();

  auto Result = std::make_unique<Setup>(std::move(*Elf), std::move(*Source),
                                        Chip.MemoryBytes);
  if (!Result->Global.isMapped())
    return createStringError("the host has no room for the chip's memory of " +
                             Twine(Chip.MemoryBytes) + " bytes");
  LaunchRequest ToLaunch;
  ToLaunch.Arguments.push_back(Request.Program);
  append_range(ToLaunch.Arguments, Request.ProgramArguments);
  ToLaunch.SceneToRender = Result->Source ? &*Result->Source : nullptr;
  ToLaunch.Rendering = Request.Rendering;
  ToLaunch.ThreadCount = Chip.threadCount();
  Expected<LaunchBlock> Block =
      setUpProgram(Result->Elf, ToLaunch, Result->Global, Result->Launch);
  if (!Block)
    return Block.takeError();
  Result->Block = *Block;
  return Result;
}

/// Runs the machine with a progress line.
static RunResult runWithProgress(Engine &Machine, const Options &Request,
                                 const Setup &Loaded, uint32_t Threads,
                                 ProgressLine &Line) {
  double Pixels = double(Loaded.Block.Width) * Loaded.Block.Height;
  Machine.setHostThreads(Request.HostThreads);
  Machine.setOutput(passOn(Line));
  RunLimits Limits;
  Limits.MaxCycles = Request.MaxCycles;
  Limits.Stop = &stopOnInterrupt();
  Limits.Report = [&](const Progress &Now) {
    std::optional<double> Share;
    if (Loaded.Source)
      Share = readPixelsTaken(Loaded.Block, Threads, Loaded.Launch) / Pixels;
    Line.update(Now, Share);
    outs().flush();
  };
  return Machine.run(Limits);
}

/// Who interprets the run's ray events; null if the user will not see what they
/// say.
static Expected<std::unique_ptr<RayProfiler>>
makeRayProfiler(const Options &Request, const ChipConfig &Chip) {
  if (Request.CacheTraceOutput.empty() && Request.Quiet &&
      Request.StatisticsOutput.empty())
    return nullptr;
  auto Rays = std::make_unique<RayProfiler>(Chip.threadCount());
  if (!Request.CacheTraceOutput.empty()) {
    if (Request.Scene.empty())
      return createStringError(
          "--trace-cache has no meaning without --scene; give the scene to "
          "render");
    if (Request.TracedDeletion.Thread >= Chip.threadCount())
      return createStringError("--trace-cache-thread: the chip has threads 0 "
                               "to " +
                               Twine(Chip.threadCount() - 1));
    Rays->recordDeletion(Request.TracedDeletion);
  }
  return Rays;
}

Expected<int> simulate(const Options &Request, const ChipConfig &Chip) {
  Expected<std::unique_ptr<Setup>> Loaded = setUp(Request, Chip);
  if (!Loaded)
    return Loaded.takeError();
  const Setup &Ready = **Loaded;
  Program Text = decodeText(Ready.Elf);
  Engine Machine(Chip, Text, (*Loaded)->Global);
  if (!Machine.error().empty())
    return createStringError(Machine.error());
  Expected<std::vector<MemoryDump>> Dumps =
      locateDumps(Request, Ready.Elf, Ready.Global);
  if (!Dumps)
    return Dumps.takeError();
  if (llvm::Error E = checkOutputs(Request))
    return E;
  Expected<std::unique_ptr<RayProfiler>> Rays = makeRayProfiler(Request, Chip);
  if (!Rays)
    return Rays.takeError();
  Machine.setObserver(Rays->get());

  ProgressLine Line(!Request.Quiet);
  RunResult Result =
      runWithProgress(Machine, Request, Ready, Chip.threadCount(), Line);
  HostSpeed Speed{Line.seconds(), Request.HostThreads};
  Line.clear();

  RunSummary Run{
      Chip, Machine.statistics(), outcomeName(Result.End), exitStatus(Result),
      {},   std::nullopt};
  if (Ready.Source) {
    const RenderOptions &Image = Request.Rendering;
    Run.Rays = readRayCounts(Ready.Block, Chip.threadCount(), Ready.Launch);
    Run.Image = ImageSettings{Image.Width, Image.Height, Image.SamplesPerPixel,
                              Image.MaxDepth, Image.Seed};
  }
  llvm::Error Failures =
      *Rays ? addRayProfiles(**Rays, Run) : llvm::Error::success();
  Failures = joinErrors(std::move(Failures),
                        writeResults(Run, Request, Ready.Block, Ready.Launch));
  if (!Request.CacheTraceOutput.empty())
    Failures =
        joinErrors(std::move(Failures),
                   writeCacheTrace(**Rays, Request, Ready.Block, Ready.Launch));
  for (const MemoryDump &Dump : *Dumps)
    Failures = joinErrors(std::move(Failures), write(Dump, Ready.Global));
  if (Request.Rendering.Bvh == BvhOrigin::Kernel && Run.ExitStatus == 0)
    Failures = joinErrors(std::move(Failures),
                          checkBvh(Request, Ready.Block, Ready.Launch));
  if (!Request.Quiet)
    writeTable(Run, Speed, errs());
  explainEnd(Result, Request, Chip, Ready.Elf, Machine);
  if (Failures)
    return Failures;
  return Run.ExitStatus;
}

} // namespace tp
