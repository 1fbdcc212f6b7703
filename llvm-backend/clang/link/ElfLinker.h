//===- ElfLinker.h - Objects to an executable -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_ELFLINKER_H
#define TP_LLVM_BACKEND_CLANG_LINK_ELFLINKER_H

#include "llvm-backend/clang/link/LinkDiagnostics.h"
#include "llvm-backend/clang/link/Relocations.h"
#include "llvm/Support/MemoryBufferRef.h"

#include <optional>
#include <string>
#include <vector>

namespace tp {

struct ElfLinkOptions {
  std::string EntrySymbol = "_start";
  /// Symbols that are kept, if defined, though nothing refers to them.
  std::vector<std::string> Roots;
  bool CollectGarbage = true;
  /// Bytes that the stack of a thread may take, whatever the calls say.
  std::optional<uint32_t> StackBytes;
  /// Where to describe the layout; empty for nowhere.
  std::string MapPath;
  ReferenceHint Hint;
};

/// Links the objects \p Inputs to an ELF executable with the TP's memory map.
/// The identifiers of the buffers name them in messages.
/// \returns the file's bytes; empty after errors, which are in \p Diags.
llvm::SmallVector<uint8_t, 0>
linkElf(llvm::ArrayRef<llvm::MemoryBufferRef> Inputs,
        const ElfLinkOptions &Options, LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_ELFLINKER_H
