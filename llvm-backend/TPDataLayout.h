//===- TPDataLayout.h - The TP's data layout --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPDATALAYOUT_H
#define TP_LLVM_BACKEND_TPDATALAYOUT_H

namespace llvm {

/// The data layout string that the code generator and clang's TargetInfo must
/// share byte for byte.
inline constexpr const char TPDataLayout[] = "e-m:e-p:32:32-i64:64-n32-S64";

/// The triple of every TP module.
inline constexpr const char TPTriple[] = "tp-unknown-elf";

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPDATALAYOUT_H
