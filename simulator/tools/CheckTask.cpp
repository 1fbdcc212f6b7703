//===- CheckTask.cpp - The checkers of a run ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/CheckTask.h"

#include "runtime/include/tp/check.h"
#include "simulator/check/CombinedChecks.h"
#include "simulator/check/MemoryChecks.h"
#include "simulator/check/race/RaceChecks.h"
#include "simulator/tools/LaunchParts.h"
#include "simulator/tools/OutputFile.h"

#include "llvm/Support/WithColor.h"

#include <algorithm>

using namespace llvm;

namespace tp {

using MemoryAndRaceChecks = CombinedChecks<MemoryChecks, RaceChecks>;

struct CheckTask::Implementation {
  Implementation(const Options &Request, const ChipConfig &Chip,
                 RunSetup &Loaded, Suppressions Suppressed)
      : Request(Request), Loaded(Loaded), Suppressed(std::move(Suppressed)),
        Names(Loaded.Elf), Found(Loaded.Elf, Chip, this->Suppressed, errs()),
        Program{Loaded.Elf,
                Names,
                Found,
                0,
                0,
                readCheckedGlobals(Loaded.Elf),
                launchParts(Loaded),
                {}} {
    for (const LaunchPart &Part : Program.Launch)
      Names.add(Part);
  }

  const Options &Request;
  RunSetup &Loaded;
  const Suppressions Suppressed;
  MemoryNames Names;
  Reports Found;
  CheckedProgram Program;
  std::unique_ptr<MemoryChecks> OfMemory;
  std::unique_ptr<RaceChecks> OfRaces;
  std::unique_ptr<MemoryAndRaceChecks> OfBoth;

  void prepareHeap();
};

/// Asks the program's heap, if it has one, for room behind blocks, and to keep
/// what is given back for a while.
void CheckTask::Implementation::prepareHeap() {
  std::optional<uint32_t> Symbol = Loaded.Elf.symbol(HeapCheckSettingsSymbol);
  if (!Symbol)
    return;
  Program.HeapBegin = Loaded.Block.HeapBegin;
  Program.HeapEnd = Loaded.Block.HeapEnd;
  if (!OfMemory)
    return;
  constexpr uint32_t MaxRetiredBytes = 64 << 20;
  HeapCheckSettings Settings{
      HeapPaddingBytes,
      std::min(MaxRetiredBytes, (Program.HeapEnd - Program.HeapBegin) / 4)};
  Loaded.Global.write(*Symbol, &Settings, sizeof(Settings));
}

CheckTask::CheckTask() = default;
CheckTask::~CheckTask() = default;

Expected<std::unique_ptr<CheckTask>>
CheckTask::start(const Options &Request, const ChipConfig &Chip,
                 RunSetup &Loaded, FunctionalMachine &Machine) {
  Suppressions Suppressed;
  if (!Request.CheckSuppressions.empty())
    if (llvm::Error Failure =
            Suppressions::read(Request.CheckSuppressions).moveInto(Suppressed))
      return Failure;
  std::unique_ptr<CheckTask> Task(new CheckTask());
  Task->Checks = std::make_unique<Implementation>(Request, Chip, Loaded,
                                                  std::move(Suppressed));
  Implementation &Checks = *Task->Checks;
  auto IsWanted = [&](StringRef Name) {
    return is_contained(Request.Checkers, Name);
  };
  MemoryCheckOptions Wanted{IsWanted("memory"), IsWanted("init"),
                            IsWanted("stack")};
  if (Wanted.Memory || Wanted.Init || Wanted.Stack)
    Checks.OfMemory = std::make_unique<MemoryChecks>(Wanted, Checks.Program);
  if (IsWanted("race"))
    Checks.OfRaces = std::make_unique<RaceChecks>(Checks.Program, Chip);
  Checks.prepareHeap();
  ExecutionChecks *All = Checks.OfMemory.get();
  if (Checks.OfMemory && Checks.OfRaces) {
    Checks.OfBoth = std::make_unique<MemoryAndRaceChecks>(*Checks.OfMemory,
                                                          *Checks.OfRaces);
    All = Checks.OfBoth.get();
  } else if (Checks.OfRaces) {
    All = Checks.OfRaces.get();
  }
  Machine.setChecks(*All);
  std::string Problem;
  if (Checks.OfMemory)
    Problem = Checks.OfMemory->error();
  if (Problem.empty() && Checks.OfRaces)
    Problem = Checks.OfRaces->error();
  if (!Problem.empty())
    return createStringError(Problem);
  return Task;
}

llvm::Error CheckTask::finish(const RunResult &Result) {
  if (Checks->OfMemory) {
    if (Result.TrapInfo)
      Checks->OfMemory->trapped(*Result.TrapInfo);
    const LaunchBlock &Block = Checks->Loaded.Block;
    if (Block.Framebuffer && Result.End == RunResult::Halted)
      Checks->OfMemory->checkResult(Block.Framebuffer,
                                    uint64_t(Block.Width) * Block.Height * 4,
                                    "the framebuffer");
  }
  if (Checks->OfRaces && Checks->OfRaces->interruptions() != 0)
    WithColor::warning(errs(), "tpsim")
        << "the memory for the order of threads was full "
        << Checks->OfRaces->interruptions()
        << " times: races between accesses before and after such a moment are "
           "not found\n";
  Checks->Found.writeSummary();
  const std::string &Path = Checks->Request.CheckOutput;
  if (Path.empty())
    return llvm::Error::success();
  return writeTo(Path, [&](raw_ostream &OS) {
    OS << formatv("{0:2}", Checks->Found.json()) << '\n';
  });
}

bool CheckTask::hasFaults() const { return Checks->Found.written() != 0; }

} // namespace tp
