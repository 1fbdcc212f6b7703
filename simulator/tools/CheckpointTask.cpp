//===- CheckpointTask.cpp - Saves a run now and then ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/CheckpointTask.h"

#include "simulator/chip/ChipFile.h"
#include "simulator/core/BufferArchive.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/xxhash.h"

#include <algorithm>

using namespace llvm;

namespace tp {
namespace {

/// Hashes what it is given to save.
class HashingArchive final : public Archive {
public:
  bool isRestoring() const override { return false; }
  void bytes(void *Data, size_t Bytes) override {
    uint64_t Both[] = {
        Hash, xxh3_64bits(ArrayRef(static_cast<const uint8_t *>(Data), Bytes))};
    Hash = xxh3_64bits(
        ArrayRef(reinterpret_cast<const uint8_t *>(Both), sizeof(Both)));
  }
  uint64_t remaining() const override { return ~uint64_t(0); }

  std::string hash() const { return utohexstr(Hash, /*LowerCase=*/true); }

private:
  uint64_t Hash = 0;
};

} // namespace

/// Which run it is, while its memory is still as at the start.
static RunIdentity identityOf(const Options &Request, const ChipConfig &Chip,
                              RunSetup &Loaded) {
  std::string ChipText;
  raw_string_ostream OS(ChipText);
  writeChip(Chip, OS);
  HashingArchive ChipHash, MemoryHash;
  ChipHash(ChipText);
  MemoryHash(Loaded.Global);
  auto Marker = [](std::optional<uint32_t> Number) {
    return Number ? std::to_string(*Number) : "none";
  };
  std::string Regions = "none";
  if (Request.Regions)
    Regions = formatv("{0}:{1}", Request.Regions->Begin, Request.Regions->End);
  std::string Trace = "none";
  if (!Request.CacheTraceOutput.empty())
    Trace = formatv("thread {0}, deletion {1}", Request.TracedDeletion.Thread,
                    Request.TracedDeletion.Deletion);
  const RenderOptions &Image = Request.Rendering;
  return {
      {"program's path", Request.Program},
      {"program's arguments", join(Request.ProgramArguments, " ")},
      {"chip", Chip.Name + " " + ChipHash.hash()},
      {"image", formatv("{0}x{1}, {2} samples, depth {3}, seed {4}",
                        Image.Width, Image.Height, Image.SamplesPerPixel,
                        Image.MaxDepth, Image.Seed)},
      {"program and scene", MemoryHash.hash()},
      {"--fast-forward", Marker(Request.FastForward)},
      {"--regions", Regions},
      {"--profile", Request.Profile ? "yes" : "no"},
      {"--trace-cache", Trace},
  };
}

CheckpointTask::CheckpointTask(const Options &Request, const ChipConfig &Chip,
                               RunSetup &Loaded, RunConsole &Console,
                               std::vector<RunTask *> Others)
    : Request(Request), Loaded(Loaded), Console(Console),
      Others(std::move(Others)), Identity(identityOf(Request, Chip, Loaded)),
      LastBeforeLimit(Request.MaxCycles -
                      Request.MaxCycles % Chip.ArbitrationWindow) {}

void CheckpointTask::serializeRun(Archive &A, Engine &Machine) {
  A(Loaded.Global);
  Machine.serialize(A);
  A(Console);
  A(Loaded.RaysBefore);
  A(*Loaded.Rays);
  for (RunTask *Task : Others)
    Task->serialize(A);
}

llvm::Error CheckpointTask::restore(Engine &Machine) {
  Expected<std::vector<uint8_t>> State =
      readCheckpoint(Request.RestoreInput, Identity);
  if (!State)
    return State.takeError();
  RestoringArchive A(*State);
  serializeRun(A, Machine);
  if (!A.isComplete())
    return createStringError(Request.RestoreInput +
                             ": made by another version of tpsim");
  Now = Machine.cycles();
  Console.resumeAt(Machine.progress());
  return llvm::Error::success();
}

uint64_t CheckpointTask::nextPause() const {
  if (Request.CheckpointOutput.empty())
    return 0;
  uint64_t Next = 0;
  if (Request.CheckpointEvery != 0)
    Next = (Now / Request.CheckpointEvery + 1) * Request.CheckpointEvery;
  if (LastBeforeLimit > Now)
    Next = Next == 0 ? LastBeforeLimit : std::min(Next, LastBeforeLimit);
  return Next;
}

llvm::Error CheckpointTask::pause(Engine &Machine, RunResult::EndKind End) {
  uint64_t Due = nextPause();
  // A limit between two windows has not cut anything.
  bool CanGoOn =
      End == RunResult::Paused ||
      (End == RunResult::CycleLimit && Machine.cycles() == LastBeforeLimit);
  bool IsDue = CanGoOn && Due != 0 && Machine.cycles() >= Due;
  bool IsStopped =
      End == RunResult::Stopped && !Request.CheckpointOutput.empty();
  if (!IsDue && !IsStopped)
    return llvm::Error::success();
  Now = Machine.cycles();
  SavingArchive A;
  serializeRun(A, Machine);
  return writeCheckpoint(Request.CheckpointOutput, Identity, A.collected());
}

} // namespace tp
