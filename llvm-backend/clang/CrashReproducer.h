//===- CrashReproducer.h - What a bug report of tpcc needs ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_CRASHREPRODUCER_H
#define TP_LLVM_BACKEND_CLANG_CRASHREPRODUCER_H

#include "llvm-backend/clang/CommandLineOption.h"
#include "clang/Driver/Compilation.h"
#include "llvm/Option/ArgList.h"

namespace tp {

/// When a reproducer is written, as -gen-reproducer= and -fcrash-diagnostics=
/// say: each case includes those before it.
enum class ReproducerLevel { Off, Crash, Error, Always };

/// Reads the level from the options.
ReproducerLevel reproducerLevel(const llvm::opt::ArgList &Arguments);

/// Writes the preprocessed sources of \p Jobs and a script that compiles them
/// as \p UserOptions say, into the folder of -fcrash-diagnostics-dir= or of
/// temporary files, and prints where they are.
void writeReproducer(const clang::driver::Compilation &Jobs,
                     llvm::ArrayRef<CommandLineOption> UserOptions,
                     const std::string &ToolPath);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_CRASHREPRODUCER_H
