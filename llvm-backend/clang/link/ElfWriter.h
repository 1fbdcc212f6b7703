//===- ElfWriter.h - Writes the executable ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_ELFWRITER_H
#define TP_LLVM_BACKEND_CLANG_LINK_ELFWRITER_H

#include "llvm-backend/clang/link/Layout.h"
#include "llvm/ADT/SmallVector.h"

namespace tp {

/// Makes the bytes of the ELF executable: sections with their relocations
/// applied, program headers, symbol table.
llvm::SmallVector<uint8_t, 0> writeElf(
    const Layout &Program, llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
    const SymbolTable &Globals, uint32_t EntryAddress, LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_ELFWRITER_H
