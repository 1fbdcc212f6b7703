//===- LinkerSymbols.h - Symbols that the linker defines --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_LINKERSYMBOLS_H
#define TP_LLVM_BACKEND_CLANG_LINK_LINKERSYMBOLS_H

#include "llvm-backend/clang/link/Layout.h"

#include <optional>

namespace tp {

/// Defines the linker's symbols (listed in docs/tpcc.md) that no object
/// defines: those of the TP always, those of the stack's bound if there are
/// \p StackBytes, others where an object refers to them.
void defineLinkerSymbols(const Layout &Program,
                         std::optional<uint32_t> StackBytes,
                         SymbolTable &Globals);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_LINKERSYMBOLS_H
