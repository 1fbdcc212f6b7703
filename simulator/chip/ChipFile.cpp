//===- ChipFile.cpp - Reading chip files ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipFile.h"

#include "simulator/chip/ChipReader.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"

#include <algorithm>

using namespace llvm;

namespace tp {

Expected<ChipConfig> parseChip(StringRef Text, StringRef FileName,
                               StringRef Name, ArrayRef<std::string> Folders) {
  Expected<YamlValue> Tree = parseYaml(Text, FileName);
  if (!Tree)
    return Tree.takeError();
  YamlErrors Errors;
  YamlPlaces Places;
  shiftLines(*Tree, Places.addFile(FileName));
  return buildChip(*Tree, Name, Folders, Places, Errors);
}

std::vector<std::string> chipNames(StringRef ChipFolder) {
  std::vector<std::string> Names;
  std::error_code EC;
  for (sys::fs::directory_iterator I(ChipFolder, EC), End; I != End && !EC;
       I.increment(EC))
    if (sys::path::extension(I->path()) == ".yaml")
      Names.push_back(sys::path::stem(I->path()).str());
  llvm::sort(Names);
  return Names;
}

static bool isPath(StringRef NameOrPath) {
  return NameOrPath.contains('/') || NameOrPath.ends_with(".yaml");
}

std::vector<std::string> foldersOfChip(StringRef NameOrPath,
                                       StringRef ChipFolder) {
  std::vector<std::string> Folders;
  if (isPath(NameOrPath))
    Folders.push_back(sys::path::parent_path(NameOrPath).str());
  Folders.push_back(ChipFolder.str());
  return Folders;
}

Expected<ChipConfig> loadChip(StringRef NameOrPath, StringRef ChipFolder) {
  SmallString<256> Path = NameOrPath;
  if (!isPath(NameOrPath)) {
    Path = ChipFolder;
    sys::path::append(Path, NameOrPath + ".yaml");
  }
  ErrorOr<std::unique_ptr<MemoryBuffer>> Buffer =
      MemoryBuffer::getFile(Path, /*IsText=*/true);
  if (!Buffer && !isPath(NameOrPath) && !sys::fs::exists(Path))
    return createStringError(
        "there is no chip '" + NameOrPath + "' in " + ChipFolder +
        "; choose one of: " + join(chipNames(ChipFolder), ", ") +
        ", or give the path of a .yaml file");
  if (!Buffer)
    return createStringError("cannot read the chip file " + Path + ": " +
                             Buffer.getError().message());
  return parseChip((*Buffer)->getBuffer(), Path, sys::path::stem(Path),
                   foldersOfChip(NameOrPath, ChipFolder));
}

} // namespace tp
