//===- localefwd.h - No streams, no locales ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Takes the place of libstdc++'s header: the TP has no streams and no locales,
// but other headers name some of their types.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_BITS_LOCALEFWD_H
#define TP_LIBSTDCXX_BITS_LOCALEFWD_H

#include <iosfwd>

#endif // TP_LIBSTDCXX_BITS_LOCALEFWD_H
