//===- Relocations.h - Puts addresses into a program's bytes ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_RELOCATIONS_H
#define TP_LLVM_BACKEND_CLANG_LINK_RELOCATIONS_H

#include "llvm-backend/clang/link/Layout.h"

#include <functional>

namespace tp {

/// Says where the source refers to \p Symbol in \p Function, for an object that
/// was made from several source files; empty if it is not known.
using ReferenceHint = std::function<std::string(llvm::StringRef Symbol,
                                                llvm::StringRef Function)>;

/// Reports the symbols that live sections refer to and nothing defines.
void reportUndefinedSymbols(llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
                            const ReferenceHint &Hint, LinkDiagnostics &Diags);

/// Applies the relocations of \p Section (TPRelocations.def) to its bytes
/// \p Bytes. Reports values that do not fit, with their place.
void relocate(const InputSection &Section, llvm::MutableArrayRef<uint8_t> Bytes,
              LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_RELOCATIONS_H
