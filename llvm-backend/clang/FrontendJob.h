//===- FrontendJob.h - One clang front end run ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_FRONTENDJOB_H
#define TP_LLVM_BACKEND_CLANG_FRONTENDJOB_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Module.h"

#include <memory>

namespace clang {
class CompilerInstance;
} // namespace clang

namespace tp {

/// Runs the front end for the TP in this process.
/// \param Arguments what follows `-cc1` on the command line.
/// \param ToolPath the path of tpcc.
/// \returns false after an error, which has been reported.
bool runFrontend(llvm::ArrayRef<const char *> Arguments, const char *ToolPath);

/// As runFrontend, but compiles to a module in \p Context and writes no object
/// file, whatever output \p Arguments ask for.
/// \returns null after an error, which has been reported.
std::unique_ptr<llvm::Module>
compileToModule(llvm::ArrayRef<const char *> Arguments, const char *ToolPath,
                llvm::LLVMContext &Context);

/// Makes the front end that \p Arguments describe, up to its target, runs
/// nothing and prints nothing.
/// \returns null if the arguments are wrong.
std::unique_ptr<clang::CompilerInstance>
interpretArguments(llvm::ArrayRef<const char *> Arguments,
                   const char *ToolPath);

/// Hands \p Options (the values of `-mllvm`) to LLVM's command line, as if no
/// other job had set any before.
void setBackendOptions(llvm::ArrayRef<std::string> Options);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_FRONTENDJOB_H
