//===- SourcePlaces.cpp - The places of a profile -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/SourcePlaces.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/MemoryBuffer.h"

#include <cassert>

using namespace llvm;

namespace tp {

SourcePlaces::SourcePlaces(const ElfProgram &Program, Profile &Result)
    : Result(Result), Symbols(Program, SourcePaths::Relative),
      AbsolutePaths(Program, SourcePaths::Absolute) {}

std::optional<uint32_t> SourcePlaces::fileOf(const std::string &Path,
                                             Mention Where) {
  if (Path.empty())
    return std::nullopt;
  auto [Known, IsNew] = Files.try_emplace(Path, uint32_t(Files.size()));
  if (IsNew) {
    Result.Files.push_back({Path, std::nullopt});
    Mentions.push_back(Where);
  }
  return Known->second;
}

uint32_t SourcePlaces::functionOf(const SourceFrame &Frame) {
  auto [Known, IsNew] = Functions.try_emplace(
      {Frame.Function, Frame.FunctionFile, Frame.FunctionLine},
      uint32_t(Functions.size()));
  if (IsNew)
    Result.Functions.push_back(
        {Frame.Function, std::nullopt, Frame.FunctionLine});
  return Known->second;
}

uint32_t SourcePlaces::frameOf(uint32_t Pc) {
  std::vector<SourceFrame> Chain = Symbols.frames(Pc);
  if (Chain.empty())
    Chain.emplace_back();
  std::optional<uint32_t> Outer;
  for (size_t I = Chain.size(); I-- != 0;) {
    const SourceFrame &Frame = Chain[I];
    std::optional<uint32_t> File = fileOf(Frame.File, {Pc, I});
    uint32_t Function = functionOf(Frame);
    // Both names come from the same table of the debug information.
    if (!Result.Functions[Function].File && File &&
        Frame.FunctionFile == Frame.File)
      Result.Functions[Function].File = File;
    auto NumberOf = [](std::optional<uint32_t> Index) {
      return Index ? *Index + 1 : 0;
    };
    auto [Known, IsNew] = Frames.try_emplace(
        {Function, NumberOf(File), Frame.Line, Frame.Column, NumberOf(Outer)},
        uint32_t(Frames.size()));
    if (IsNew)
      Result.Frames.push_back(
          {Function, File, Frame.Line, Frame.Column, Outer});
    Outer = Known->second;
  }
  assert(Outer && "a chain has a frame");
  return *Outer;
}

uint32_t SourcePlaces::functionAt(uint32_t Pc) {
  std::vector<SourceFrame> Chain = Symbols.frames(Pc);
  return functionOf(Chain.empty() ? SourceFrame() : Chain.back());
}

void SourcePlaces::readSources() {
  for (auto [File, Where] : zip(Result.Files, Mentions)) {
    std::vector<SourceFrame> Chain = AbsolutePaths.frames(Where.Pc);
    if (Where.Frame >= Chain.size())
      continue;
    if (auto Buffer = MemoryBuffer::getFile(Chain[Where.Frame].File))
      File.Text = (*Buffer)->getBuffer().str();
  }
}

} // namespace tp
