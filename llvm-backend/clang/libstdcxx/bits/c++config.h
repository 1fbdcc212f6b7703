//===- c++config.h - Configures libstdc++ for the TP ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// libstdc++ was configured for the host's C library and threads, and for a
// compiled part. The TP has the runtime's C library, and templates only.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_CXXCONFIG_H
#define TP_LIBSTDCXX_CXXCONFIG_H

#include_next <bits/c++config.h>

#undef _GLIBCXX_EXTERN_TEMPLATE
#define _GLIBCXX_EXTERN_TEMPLATE 0

#undef _GLIBCXX_HAS_GTHREADS
#undef _GLIBCXX_USE_WCHAR_T
#undef _GLIBCXX_USE_LONG_DOUBLE_COMPAT
#undef _GLIBCXX_USE_FLOAT128
#undef _GLIBCXX_HAVE_FLOAT128_MATH
#undef _GLIBCXX_USE_C99_COMPLEX
#undef _GLIBCXX_USE_C99_COMPLEX_TR1
#undef _GLIBCXX_USE_INT128
#undef _GLIBCXX_HAVE_LINUX_FUTEX

#endif // TP_LIBSTDCXX_CXXCONFIG_H
