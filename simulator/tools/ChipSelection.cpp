//===- ChipSelection.cpp - The chip of a command line ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/ChipSelection.h"

#include "simulator/chip/ChipFile.h"
#include "simulator/chip/ChipSettings.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace tp {

std::string chipFolder(const char *Argv0) {
  std::string Binary =
      sys::fs::getMainExecutable(Argv0, reinterpret_cast<void *>(&chipFolder));
  SmallString<256> Folder =
      sys::path::parent_path(sys::path::parent_path(Binary));
  sys::path::append(Folder, "share", "tp", "chips");
  return std::string(Folder);
}

Expected<ChipConfig> selectChip(const Options &Request, StringRef ChipFolder) {
  Expected<ChipConfig> Chip = loadChip(Request.Chip, ChipFolder);
  if (!Chip || Request.ChipSettings.empty())
    return Chip;
  return withSettings(*Chip, Request.ChipSettings,
                      foldersOfChip(Request.Chip, ChipFolder));
}

} // namespace tp
