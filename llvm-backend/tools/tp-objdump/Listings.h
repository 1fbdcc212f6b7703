//===- Listings.h - Tables of sections and symbols --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_LISTINGS_H
#define TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_LISTINGS_H

#include "llvm-backend/tools/tp-objdump/ObjectInput.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Prints one line per section: number, name, size, address and kind.
void printSections(const ObjectInput &Input, llvm::raw_ostream &OS);

/// Prints one line per symbol: value, binding, type, section, size and name.
void printSymbols(const ObjectInput &Input, llvm::raw_ostream &OS);

/// Prints the relocations of each section: offset, type and target.
void printRelocations(const ObjectInput &Input, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_LISTINGS_H
