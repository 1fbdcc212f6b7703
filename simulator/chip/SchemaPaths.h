//===- SchemaPaths.h - All keys that a chip file can have -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_SCHEMAPATHS_H
#define TP_SIMULATOR_CHIP_SCHEMAPATHS_H

#include "simulator/chip/ChipSchema.h"

#include <string>
#include <vector>

namespace tp {

/// A key or section of a chip file.
struct SchemaPath {
  /// The keys from the outermost on with dots between them.
  std::string Text;
  bool IsSection = false;
  Presence P = Presence::Required;
  /// SectionInfo::Folder.
  std::string Folder;
};

/// All keys and sections in the order of visitChip(); a section stands before
/// its keys.
std::vector<SchemaPath> schemaPaths();

} // namespace tp

#endif // TP_SIMULATOR_CHIP_SCHEMAPATHS_H
