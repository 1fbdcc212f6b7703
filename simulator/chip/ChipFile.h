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

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <string>
#include <vector>

namespace tp {

/// Builds the chip that \p Text describes. The chip is called \p Name. Files
/// that it names are looked for below \p Folders. The error lists everything
/// that is wrong with the file, a line each, in the form
/// `<FileName>:<line>: <what and what would be right>`.
llvm::Expected<ChipConfig> parseChip(llvm::StringRef Text,
                                     llvm::StringRef FileName,
                                     llvm::StringRef Name,
                                     llvm::ArrayRef<std::string> Folders = {});

/// Where loadChip() looks for the files that a chip names: next to the chip's
/// own file, then in \p ChipFolder.
std::vector<std::string> foldersOfChip(llvm::StringRef NameOrPath,
                                       llvm::StringRef ChipFolder);

/// Loads a chip by the path of its file (anything with a `/` or ending in
/// `.yaml`), or by name from `<ChipFolder>/<name>.yaml`.
llvm::Expected<ChipConfig> loadChip(llvm::StringRef NameOrPath,
                                    llvm::StringRef ChipFolder);

/// Names of the `.yaml` files in \p ChipFolder, sorted.
std::vector<std::string> chipNames(llvm::StringRef ChipFolder);

/// Writes the chip with every value resolved, as a chip file that parseChip()
/// reads back to the same chip without any other file.
void writeChip(const ChipConfig &Chip, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPFILE_H
