//===- c++config.h - What libstdc++ finds on the TP -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_CXXCONFIG_H
#define TP_LIBSTDCXX_CXXCONFIG_H

#include_next <bits/c++config.h>

// Of the host's answers, those that do not hold here.
#undef _GLIBCXX_HAS_GTHREADS
#undef _GLIBCXX_HAVE_LINUX_FUTEX
#undef _GLIBCXX_HAVE_POSIX_SEMAPHORE
#undef _GLIBCXX_HAVE_MBSTATE_T
#undef _GLIBCXX_HAVE_WCHAR_H
#undef _GLIBCXX_USE_WCHAR_T
#undef _GLIBCXX_USE_FLOAT128
#undef _GLIBCXX_VERBOSE

#endif // TP_LIBSTDCXX_CXXCONFIG_H
