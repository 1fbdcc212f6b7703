//===- Libcalls.h - Functions that the compiler calls by itself -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_LIBCALLS_H
#define TP_LLVM_BACKEND_CLANG_LINK_LIBCALLS_H

#include "llvm/ADT/StringRef.h"

namespace tp {

/// Whether the optimizer or the code generator may make calls of the function
/// \p Name in a program that does not mention it (`__adddf3`, `memcpy`,
/// `puts`): its definition has to stay until the code is generated.
bool isLibraryFunction(llvm::StringRef Name);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_LIBCALLS_H
