//===- ChipFile.h - Reading and writing chip files --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A chip file is YAML; docs/chip-files.md describes its keys.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPFILE_H
#define TP_SIMULATOR_CHIP_CHIPFILE_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/chip/YamlSection.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <string>
#include <vector>

namespace tp {

/// Limits that parseChip() enforces.
inline constexpr uint32_t MaxThreads = 1u << 20;
inline constexpr uint32_t MaxTpsPerTm = 1024;
inline constexpr uint32_t MaxUnitCount = 1024;
inline constexpr uint32_t MaxUnitInterval = 1024;
inline constexpr uint32_t MaxLatency = 4096;
inline constexpr uint32_t MaxIcacheBanks = 64;
inline constexpr uint32_t MaxIcachePorts = 1024;
/// The topmost MiB of the address space belongs to the local stores. Below them
/// at least another MiB traps, so that a stack that overflows does not run into
/// global memory.
inline constexpr uint32_t MaxLocalStoreBytes = 1u << 20;
inline constexpr uint64_t MaxMemoryBytes =
    (1ull << 32) - 2 * uint64_t(MaxLocalStoreBytes);
/// The first 64 KiB trap; a program needs some memory behind them.
inline constexpr uint64_t MinMemoryBytes = 128 << 10;

/// Builds the chip that \p Text describes. The chip is called \p Name. The
/// error lists everything that is wrong with the file, a line each, in the form
/// `<FileName>:<line>: <what and what would be right>`.
llvm::Expected<ChipConfig>
parseChip(llvm::StringRef Text, llvm::StringRef FileName, llvm::StringRef Name);

/// The same from a tree; \p Errors holds no error yet.
llvm::Expected<ChipConfig> buildChip(const YamlValue &Tree, YamlErrors &Errors,
                                     llvm::StringRef Name);

/// Loads a chip by the path of its file (anything with a `/` or ending in
/// `.yaml`), or by name from `<ChipFolder>/<name>.yaml`.
llvm::Expected<ChipConfig> loadChip(llvm::StringRef NameOrPath,
                                    llvm::StringRef ChipFolder);

/// Names of the chips in \p ChipFolder, sorted.
std::vector<std::string> chipNames(llvm::StringRef ChipFolder);

/// Writes the chip with every value resolved, as a chip file that parseChip()
/// reads back to the same chip.
void writeChip(const ChipConfig &Chip, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPFILE_H
