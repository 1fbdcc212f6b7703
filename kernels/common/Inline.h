//===- Inline.h - Functions that must be inlined ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_INLINE_H
#define TP_KERNELS_COMMON_INLINE_H

/// For functions in a kernel's inner loops: inlined whatever the compiler
/// thinks of their size, because a call would move their operands through
/// memory.
#define TP_KERNEL_INLINE [[gnu::always_inline]] inline

/// The same for a lambda: between its parameters and its body.
#define TP_LAMBDA_INLINE __attribute__((always_inline))

#endif // TP_KERNELS_COMMON_INLINE_H
