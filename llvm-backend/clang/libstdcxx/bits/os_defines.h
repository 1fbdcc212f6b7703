//===- os_defines.h - libstdc++ without an operating system -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Takes the place of the host's file, which asks for glibc.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_OS_DEFINES_H
#define TP_LIBSTDCXX_OS_DEFINES_H

// The functions of <ctype.h> and <math.h> are no macros.
#define __NO_CTYPE 1
#define _GLIBCXX_NO_OBSOLETE_ISINF_ISNAN_DYNAMIC 1

#endif // TP_LIBSTDCXX_OS_DEFINES_H
