//===- CodeSession.h - LLVM as a compiler in memory -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_CODESESSION_H
#define TP_SIMULATOR_JIT_CODESESSION_H

#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/ExecutionEngine/Orc/LLJIT.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/Error.h"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// Makes the generated function one of the session's: nothing unwinds through
/// it, and it is compiled for the host's processor.
void prepareFunction(llvm::Function &F);

/// Inlines the step functions and simplifies what they do with constant
/// operands. \p Specialize is called for each function with external linkage
/// when its memory accesses have become direct ones, to replace what it knows
/// to be constant.
void optimize(llvm::Module &M,
              llvm::function_ref<void(llvm::Function &)> Specialize);

/// Compiles modules for this process. What it has compiled lives as long as it
/// does. For one host thread at a time.
class CodeSession {
public:
  static llvm::Expected<std::unique_ptr<CodeSession>> create();

  /// Compiles a module and gives the addresses of its functions \p Names, whose
  /// names no earlier module may have had. Symbols that the module does not
  /// define are the process's.
  llvm::Expected<std::vector<const void *>>
  compile(std::unique_ptr<llvm::Module> M,
          std::unique_ptr<llvm::LLVMContext> Context,
          const std::vector<std::string> &Names);

private:
  explicit CodeSession(std::unique_ptr<llvm::orc::LLJIT> Jit)
      : Jit(std::move(Jit)) {}

  std::unique_ptr<llvm::orc::LLJIT> Jit;
};

} // namespace tp

#endif // TP_SIMULATOR_JIT_CODESESSION_H
