//===- ProgramMemory.h - What a program finds at its start ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_PROGRAMMEMORY_H
#define TP_SIMULATOR_TOOLS_PROGRAMMEMORY_H

#include "kernels/common/LaunchSetup.h"
#include "simulator/core/Memory.h"
#include "simulator/loader/ElfProgram.h"

#include "llvm/Support/Error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// The symbol of the launch block in a program.
inline constexpr const char *LaunchBlockSymbol = "__tp_launch";

/// Hands out the chip's global memory from the end of the program's image
/// upwards.
class ProgramMemory : public LaunchMemory {
public:
  /// Copies the program's segments into \p Global, which must hold zeros and
  /// have room for them.
  ProgramMemory(const ElfProgram &Program, Memory &Global);

  DeviceAddress allocate(size_t Bytes, uint32_t Alignment) override;
  void write(DeviceAddress Address, const void *Source, size_t Bytes) override;
  void read(DeviceAddress Address, void *Target, size_t Bytes) const override;

  /// First address that nobody has.
  uint64_t end() const { return Cursor; }

private:
  Memory &Global;
  uint64_t Cursor;
};

/// What to lay out for a program.
struct LaunchRequest {
  /// argv, with the program's name first.
  std::vector<std::string> Arguments;
  /// What to render; null: nothing.
  const Scene *SceneToRender = nullptr;
  RenderOptions Rendering;
  uint32_t ThreadCount = 1;
};

/// Lays out the request, leaves what remains of the memory as heap and fills
/// the program's launch block, which comes back. A program without launch
/// block gets nothing, which is an error only if there is a scene.
llvm::Expected<LaunchBlock> setUpProgram(const ElfProgram &Program,
                                         const LaunchRequest &Request,
                                         Memory &Global, ProgramMemory &Launch);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_PROGRAMMEMORY_H
