//===- ProgramStack.h - How much stack a program's threads get --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_PROGRAMSTACK_H
#define TP_LLVM_BACKEND_CLANG_LINK_PROGRAMSTACK_H

#include "llvm-backend/clang/link/ElfLinker.h"
#include "llvm-backend/clang/link/StackBound.h"

namespace tp {

/// The symbols that tell a program of its stack. It need not be bounded if
/// nothing refers to them.
inline constexpr const char StackBytesSymbol[] = "__tp_stack_bytes";
inline constexpr const char StackLimitSymbol[] = "__tp_stack_limit";

struct ProgramStack {
  /// Whether Bound has been looked for.
  bool IsAnalyzed = false;
  StackBound Bound;
  /// What the symbols say: bytes, a multiple of memorymap::StackAlignment;
  /// nothing if they are not defined.
  std::optional<uint32_t> Bytes;
};

/// Finds out what the stack of the program that begins at \p Entry takes, if
/// the program or \p Options ask for it. Reports a stack without bound that
/// needs one. The live sections must be marked.
ProgramStack determineStack(llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
                            const SymbolTable &Globals, const Symbol &Entry,
                            const ElfLinkOptions &Options,
                            LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_PROGRAMSTACK_H
