//===- MapFile.h - Describes a program's layout -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_MAPFILE_H
#define TP_LLVM_BACKEND_CLANG_LINK_MAPFILE_H

#include "llvm-backend/clang/link/Layout.h"
#include "llvm-backend/clang/link/StackBound.h"

namespace tp {

/// Writes to \p Path, line by line, the address, size and name of each section,
/// of each input section in it, and of each symbol in that; then the deepest
/// calls.
void writeMapFile(llvm::StringRef Path, const Layout &Program,
                  const StackBound &Stack,
                  llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
                  const SymbolTable &Globals, LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_MAPFILE_H
