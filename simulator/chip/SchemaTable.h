//===- SchemaTable.h - The keys of a chip file as a table -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_SCHEMATABLE_H
#define TP_SIMULATOR_CHIP_SCHEMATABLE_H

#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Writes the Markdown table of docs/chip-files.md: every key with its meaning,
/// what it allows and its value if it is left out.
void writeSchemaTable(llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_SCHEMATABLE_H
