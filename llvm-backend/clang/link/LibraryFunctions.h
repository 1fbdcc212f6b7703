//===- LibraryFunctions.h - Functions that the compiler calls ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_LIBRARYFUNCTIONS_H
#define TP_LLVM_BACKEND_CLANG_LINK_LIBRARYFUNCTIONS_H

#include "llvm/ADT/StringSet.h"
#include "llvm/IR/Module.h"

namespace tp {

/// The functions of \p Program and \p Runtime (may be null) whose definitions
/// have to stay until the program's code is generated, because the optimizer or
/// the code generator may make calls of them that are not there yet: arithmetic
/// like `__adddf3`, `memcpy`, and what a call of the library may turn into
/// (`printf` into `puts`, `pow` into `exp2`). They stay only if what can be
/// reached from \p Roots has the types or calls that lead to them. Of a runtime
/// that is loaded lazily this materializes what the program takes.
llvm::StringSet<> libraryFunctionsToKeep(llvm::Module &Program,
                                         llvm::Module *Runtime,
                                         const llvm::StringSet<> &Roots);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_LIBRARYFUNCTIONS_H
