//===- os_defines.h - What libstdc++ may expect of the system ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_OS_DEFINES_H
#define TP_LIBSTDCXX_OS_DEFINES_H

// The host's version asks for glibc; the TP has no operating system.

#endif // TP_LIBSTDCXX_OS_DEFINES_H
