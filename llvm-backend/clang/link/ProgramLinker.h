//===- ProgramLinker.h - Everything to one program --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_PROGRAMLINKER_H
#define TP_LLVM_BACKEND_CLANG_LINK_PROGRAMLINKER_H

#include "llvm-backend/clang/link/LinkDiagnostics.h"
#include "llvm-backend/clang/link/ProgramReports.h"
#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "llvm/IR/Module.h"
#include "llvm/Passes/OptimizationLevel.h"
#include "llvm/Support/MemoryBuffer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// An input of the link: a compiled unit in memory, or else a file (object,
/// bitcode or archive of these).
struct LinkInput {
  /// What messages call it.
  std::string Name;
  std::unique_ptr<llvm::Module> Unit;
  /// Read if there is no Unit.
  std::string Path;
  /// All members of an archive are taken, not only those that are needed.
  bool WholeArchive = false;
};

struct LinkOptions {
  std::string OutputPath = "a.out";
  /// Bitcode of the runtime; empty to link without one.
  std::string RuntimePath;
  std::string EntrySymbol = "_start";
  /// Symbols that are kept though nothing refers to them.
  std::vector<std::string> KeptSymbols;
  std::string MapPath;
  /// Bytes that the stack of a thread may take; the linker finds out if not
  /// given.
  std::optional<uint32_t> StackBytes;
  bool CollectGarbage = true;
  /// Whether debug data describes the runtime's variables and types, and not
  /// only its lines.
  bool FullRuntimeDebugInfo = false;
  llvm::OptimizationLevel Level = llvm::OptimizationLevel::O0;
  WarningOptions Warnings;
  ProgramReports Reports;
};

/// Links \p Inputs and the runtime: bitcode is optimized as one program, then
/// laid out with the objects. Writes an executable file.
/// \returns false after errors, which are in \p Diags; then no file is written.
bool linkProgram(llvm::LLVMContext &Context, std::vector<LinkInput> Inputs,
                 const LinkOptions &Options, LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_PROGRAMLINKER_H
