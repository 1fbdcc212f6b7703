//===- stdlib.h - The C library's functions with overloads ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_STDLIB_H
#define TP_LIBSTDCXX_STDLIB_H

// libstdc++'s own header of this name then passes on to the C library's.
#define _GLIBCXX_INCLUDE_NEXT_C_HEADERS
#include_next <stdlib.h>
#undef _GLIBCXX_INCLUDE_NEXT_C_HEADERS

#include <bits/std_abs.h>

using std::abs;

extern "C++" {
inline ldiv_t div(long A, long B) { return ldiv(A, B); }
inline lldiv_t div(long long A, long long B) { return lldiv(A, B); }
} // extern "C++"

#endif // TP_LIBSTDCXX_STDLIB_H
