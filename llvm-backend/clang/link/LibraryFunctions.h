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

/// The functions of \p Program whose definitions have to stay until its code is
/// generated, because the optimizer or the code generator may make calls of
/// them that are not there yet: arithmetic like `__adddf3`, `memcpy`, and what
/// a call of the library may turn into (`printf` into `puts`, `pow` into
/// `exp2`). They stay only if what can be reached from \p Roots has the types
/// or calls that lead to them.
llvm::StringSet<> libraryFunctionsToKeep(const llvm::Module &Program,
                                         const llvm::StringSet<> &Roots);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_LIBRARYFUNCTIONS_H
