//===- TPBuiltins.h - The TP's compiler builtins ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPBUILTINS_H
#define TP_LLVM_BACKEND_TPBUILTINS_H

namespace llvm {

class Function;

namespace TPBuiltin {

/// The builtins of TPBuiltins.def; None is any other function.
enum class ID {
  None,
#define TP_BUILTIN(Name, ClangType, ClangAttributes, Effect) Name,
#include "llvm-backend/TPBuiltins.def"
};

/// What a builtin may do to memory; see TPBuiltins.def.
enum class Effect { Const, Inaccessible, Memory };

/// The builtin that a declaration `tp_<name>` stands for. A function with a
/// body is never one.
ID getID(const Function &F);

/// The Effect column of \p Builtin, which is not None.
Effect getEffect(ID Builtin);

/// Whether the builtin ends the thread.
bool isNoReturn(ID Builtin);

} // namespace TPBuiltin
} // namespace llvm

#endif // TP_LLVM_BACKEND_TPBUILTINS_H
