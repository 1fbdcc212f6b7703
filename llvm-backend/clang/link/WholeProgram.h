//===- WholeProgram.h - Bitcode to one optimized object ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_WHOLEPROGRAM_H
#define TP_LLVM_BACKEND_CLANG_LINK_WHOLEPROGRAM_H

#include "llvm-backend/clang/link/LinkDiagnostics.h"
#include "llvm-backend/clang/link/ProgramReports.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/IR/Module.h"
#include "llvm/Passes/OptimizationLevel.h"

#include <memory>
#include <string>

namespace llvm {
class TargetMachine;
} // namespace llvm

namespace tp {

/// All bitcode of a program as one module.
class WholeProgram {
public:
  WholeProgram(llvm::LLVMContext &Context, const ProgramReports &Reports,
               LinkDiagnostics &Diags);

  /// Adds a translation unit; \p Name is the user's name for it. Reports
  /// symbols that two units define.
  void add(std::unique_ptr<llvm::Module> Unit, llvm::StringRef Name);

  /// Says that something outside may refer to the symbols. Not after
  /// addRuntime().
  void exportSymbols(const llvm::StringSet<> &Symbols);

  /// Adds what the program needs of the runtime, a module that may be loaded
  /// lazily. Definitions of the program, or in \p DefinedElsewhere, take the
  /// place of the runtime's.
  void addRuntime(std::unique_ptr<llvm::Module> Runtime, llvm::StringRef Name,
                  bool FullDebugInfo,
                  const llvm::StringMap<std::string> &DefinedElsewhere);

  bool isEmpty() const { return Units == 0; }
  /// Where the source refers to \p Symbol, or else, if the compiler made the
  /// reference, where it has \p Function: `file:function`, or empty.
  std::string referenceTo(llvm::StringRef Symbol,
                          llvm::StringRef Function) const;
  /// The name of the unit that defines \p Symbol, or empty.
  llvm::StringRef definitionOf(llvm::StringRef Symbol) const;

  /// Optimizes the program as a whole and compiles it.
  /// \returns the object file; empty after an error.
  llvm::SmallVector<char, 0> compile(llvm::OptimizationLevel Level);

private:
  void recordSymbols(const llvm::Module &Unit, llvm::StringRef Name);
  void link(std::unique_ptr<llvm::Module> Unit, llvm::StringRef Name,
            unsigned Flags);
  void internalize();
  void optimize(llvm::OptimizationLevel Level, llvm::TargetMachine &Machine);
  void optimizeAndEmit(llvm::OptimizationLevel Level,
                       llvm::raw_pwrite_stream &Object);
  void saveOptimized(llvm::OptimizationLevel Level);

  const ProgramReports &Reports;
  LinkDiagnostics &Diags;
  std::unique_ptr<llvm::Module> Program;
  unsigned Units = 0;
  llvm::StringMap<std::string> Definitions;
  llvm::StringMap<std::string> References;
  /// What others refer to: objects, module-level assembly, the code generator.
  llvm::StringSet<> Exported;
  bool HasRuntime = false;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_WHOLEPROGRAM_H
