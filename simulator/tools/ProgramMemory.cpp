//===- ProgramMemory.cpp - What a program finds at its start --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/ProgramMemory.h"

#include "kernels/common/LaunchArguments.h"

#include "llvm/ADT/Twine.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp {

ProgramMemory::ProgramMemory(const ElfProgram &Program, Memory &Global)
    : Global(Global), Cursor(Program.imageEnd()) {
  for (const Segment &S : Program.segments())
    Global.write(S.Address, S.Contents.data(), S.Contents.size());
}

DeviceAddress ProgramMemory::allocate(size_t Bytes, uint32_t Alignment) {
  uint64_t Begin = alignTo(Cursor, Alignment);
  if (Bytes > Global.size() || Begin > Global.size() - Bytes)
    return 0;
  Cursor = Begin + Bytes;
  return DeviceAddress(Begin);
}

void ProgramMemory::write(DeviceAddress Address, const void *Source,
                          size_t Bytes) {
  Global.write(Address, Source, Bytes);
}

void ProgramMemory::read(DeviceAddress Address, void *Target,
                         size_t Bytes) const {
  Global.read(Address, Target, Bytes);
}

Expected<LaunchBlock> setUpProgram(const ElfProgram &Program,
                                   const LaunchRequest &Request, Memory &Global,
                                   ProgramMemory &Launch) {
  std::optional<uint32_t> BlockAddress = Program.symbol(LaunchBlockSymbol);
  LaunchBlock Block{};
  if (!BlockAddress && !Request.SceneToRender)
    return Block;
  if (!BlockAddress)
    return createStringError(Program.path() +
                             ": the program cannot render a scene: it has no "
                             "launch block (symbol '" +
                             LaunchBlockSymbol + "')");

  Block.Version = kLaunchBlockVersion;
  if (Request.SceneToRender) {
    ErrorOr<LaunchBlock> WithScene = setUpLaunch(
        *Request.SceneToRender, Request.Rendering, Request.ThreadCount, Launch);
    if (!WithScene)
      return createStringError(WithScene.message());
    Block = *WithScene;
  }
  if (Status Placed = placeArguments(Request.Arguments, Launch, Block); !Placed)
    return createStringError(Placed.message());
  // More than the alignment of any type.
  constexpr uint64_t HeapAlignment = 64;
  Block.HeapEnd = DeviceAddress(Global.size());
  Block.HeapBegin = DeviceAddress(
      std::min(alignTo(Launch.end(), HeapAlignment), Global.size()));
  if (!Global.write(*BlockAddress, &Block, sizeof(Block)))
    return createStringError(Program.path() + ": the symbol '" +
                             LaunchBlockSymbol +
                             "' does not lie in the program's memory");
  return Block;
}

} // namespace tp
