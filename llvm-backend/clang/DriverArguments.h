//===- DriverArguments.h - tpcc's defaults among clang's --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_DRIVERARGUMENTS_H
#define TP_LLVM_BACKEND_CLANG_DRIVERARGUMENTS_H

#include "llvm-backend/clang/Sysroot.h"
#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/Option/ArgList.h"
#include "llvm/Option/Option.h"

namespace tp {

/// The options that tpcc puts in front of the user's, so that the user's win.
llvm::ArrayRef<const char *> defaultDriverArguments();

/// Turns a `-cc1` job that compiles to an object for the link into one that
/// compiles to bitcode, so that the link sees the whole program.
void compileForWholeProgram(llvm::opt::ArgStringList &JobArguments);

/// Completes the arguments that clang's driver made for a `-cc1` or `-cc1as`
/// job: the TP's triple as its code generator spells it, C++20 as default
/// language, the user's \p WarningWords, and the header folders of \p Folders
/// unless an option of \p UserArguments excludes them.
void completeJobArguments(const llvm::opt::ArgList &UserArguments,
                          llvm::ArrayRef<const char *> WarningWords,
                          const Sysroot &Folders,
                          const llvm::opt::ArgList &StringOwner,
                          llvm::opt::ArgStringList &JobArguments);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_DRIVERARGUMENTS_H
