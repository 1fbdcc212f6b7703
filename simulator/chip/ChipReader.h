//===- ChipReader.h - A chip from the tree of its file ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPREADER_H
#define TP_SIMULATOR_CHIP_CHIPREADER_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/chip/YamlSection.h"

#include "llvm/ADT/ArrayRef.h"

#include <string>

namespace tp {

/// Puts the contents of the files in place that \p Tree names instead of
/// sections (SectionInfo::Folder). A name is looked for in each of \p Folders,
/// a relative path starts at the first of them.
void insertNamedFiles(YamlValue &Tree, llvm::ArrayRef<std::string> Folders,
                      YamlPlaces &Places, YamlErrors &Errors);

/// Reads and checks a chip and the files that it names.
llvm::Expected<ChipConfig> buildChip(YamlValue Tree, llvm::StringRef Name,
                                     llvm::ArrayRef<std::string> Folders,
                                     YamlPlaces &Places, YamlErrors &Errors);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPREADER_H
