//===- LiveSections.h - What of the inputs a program needs ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_LIVESECTIONS_H
#define TP_LLVM_BACKEND_CLANG_LINK_LIVESECTIONS_H

#include "llvm-backend/clang/link/ElfInput.h"

namespace tp {

/// Marks the sections that the program needs: what can be reached from the
/// symbols \p Roots, from constructors and from sections that ask to be kept
/// (`retain`); and all sections that are not loaded.
/// \param KeepAll marks all others, too.
void markLiveSections(llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
                      const SymbolTable &Globals,
                      llvm::ArrayRef<std::string> Roots, bool KeepAll);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_LIVESECTIONS_H
