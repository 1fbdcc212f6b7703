//===- FloatingPointFlags.h - Clang's floating-point options ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_FLOATINGPOINTFLAGS_H
#define TP_LLVM_BACKEND_CLANG_FLOATINGPOINTFLAGS_H

namespace tp {

/// Whether clang's driver option \p ID (`clang::options::OPT_...`) says how
/// floating-point arithmetic is compiled.
bool isFloatingPointFlag(unsigned ID);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_FLOATINGPOINTFLAGS_H
