//===- MemoryNames.h - What lies where in global memory ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_MEMORYNAMES_H
#define TP_SIMULATOR_CHECK_MEMORYNAMES_H

#include "runtime/include/tp/check.h"
#include "simulator/loader/ElfProgram.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What -ftp-check-objects says of the globals of \p Program.
std::vector<CheckedGlobal> readCheckedGlobals(const ElfProgram &Program);

/// Bytes behind each part of the launch that nobody may access, when accesses
/// are checked: the largest record of a scene.
inline constexpr uint32_t LaunchPaddingBytes = 128;

/// What the program finds at its start beside its globals: the framebuffer, an
/// array of the scene.
struct LaunchPart {
  uint32_t Address;
  uint64_t Bytes;
  /// As in "8 bytes behind the framebuffer".
  std::string Name;
};

/// The program's globals and the parts of its launch by address.
class MemoryNames {
public:
  /// The variables of \p Program, of its symbol table and its checked globals.
  explicit MemoryNames(const ElfProgram &Program);

  void add(const LaunchPart &Part);

  /// Where \p Address lies in, or right behind, a known object; nothing if
  /// there is none.
  std::optional<std::string> describe(uint32_t Address) const;

private:
  struct Object {
    uint64_t Bytes;
    std::string Name;
  };
  std::map<uint32_t, Object> Objects;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_MEMORYNAMES_H
