//===- RunSetup.cpp - What a run of tpsim starts from ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/RunSetup.h"

#include "simulator/check/MemoryNames.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Process.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

namespace tp {

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
  SmallVector<StringRef> Paths = {
      Request.ImageOutput, Request.BvhOutput, Request.StatisticsOutput,
      Request.IntervalOutput, Request.CacheTraceOutput};
  for (const MemoryDumpRequest &Dump : Request.MemoryDumps)
    Paths.push_back(Dump.Path);
  for (StringRef Path : Paths)
    if (!Path.empty() && Path != "-")
      if (llvm::Error E = checkWritable(Path))
        return E;
  StringRef Checkpoint = Request.CheckpointOutput;
  if (Checkpoint.empty() || sys::fs::exists(Checkpoint))
    return llvm::Error::success();
  // It must not be there before there is something in it.
  if (llvm::Error E = checkWritable(Checkpoint))
    return E;
  return errorCodeToError(sys::fs::remove(Checkpoint));
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

static Expected<std::unique_ptr<RayProfiler>>
makeRayProfiler(const Options &Request, const ChipConfig &Chip) {
  bool IsSaved =
      !Request.CheckpointOutput.empty() || !Request.RestoreInput.empty();
  if (Request.CacheTraceOutput.empty() && Request.Quiet &&
      Request.StatisticsOutput.empty() && !Request.Profile && !IsSaved)
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

RunSetup::RunSetup(ElfProgram Loaded, std::optional<Scene> Source,
                   uint64_t MemoryBytes)
    : Elf(std::move(Loaded)), Source(std::move(Source)), Text(decodeText(Elf)),
      Global(MemoryBytes), Launch(Elf, Global) {}

std::vector<Opcode> RunSetup::opcodes() const {
  std::vector<Opcode> Opcodes;
  for (const Instruction &Decoded : Text.instructions())
    Opcodes.push_back(Decoded.Op);
  return Opcodes;
}

Expected<std::unique_ptr<RunSetup>> setUp(const Options &Request,
                                          const ChipConfig &Chip) {
  Expected<ElfProgram> Elf = ElfProgram::load(Request.Program);
  if (!Elf)
    return Elf.takeError();
  if (llvm::Error E = Elf->checkFits(Chip.MemoryBytes, Chip.LocalStoreBytes))
    return E;
  Expected<std::optional<Scene>> Source = loadRequestedScene(Request);
  if (!Source)
    return Source.takeError();

  auto Result = std::make_unique<RunSetup>(std::move(*Elf), std::move(*Source),
                                           Chip.MemoryBytes);
  if (!Result->Global.isMapped())
    return createStringError("the host has no room for the chip's memory of " +
                             Twine(Chip.MemoryBytes) + " bytes");
  LaunchRequest ToLaunch;
  ToLaunch.Arguments.push_back(Request.Program);
  append_range(ToLaunch.Arguments, Request.ProgramArguments);
  ToLaunch.SceneToRender = Result->Source ? &*Result->Source : nullptr;
  ToLaunch.Rendering = Request.Rendering;
  if (is_contained(Request.Checkers, "memory"))
    ToLaunch.Rendering.PaddingBytes = LaunchPaddingBytes;
  ToLaunch.ThreadCount = Result->ThreadCount = Chip.threadCount();
  Expected<LaunchBlock> Block =
      setUpProgram(Result->Elf, ToLaunch, Result->Global, Result->Launch);
  if (!Block)
    return Block.takeError();
  Result->Block = *Block;

  Expected<std::vector<MemoryDump>> Dumps =
      locateDumps(Request, Result->Elf, Result->Global);
  if (!Dumps)
    return Dumps.takeError();
  Result->Dumps = std::move(*Dumps);
  if (llvm::Error E = checkOutputs(Request))
    return E;
  Expected<std::unique_ptr<RayProfiler>> Rays = makeRayProfiler(Request, Chip);
  if (!Rays)
    return Rays.takeError();
  Result->Rays = std::move(*Rays);
  return Result;
}

} // namespace tp
