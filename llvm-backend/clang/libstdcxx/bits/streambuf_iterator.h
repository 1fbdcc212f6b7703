//===- streambuf_iterator.h - No streams, no locales ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Takes the place of libstdc++'s header: the TP has no streams and no locales,
// but other headers name some of their types.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_BITS_STREAMBUF_ITERATOR_H
#define TP_LIBSTDCXX_BITS_STREAMBUF_ITERATOR_H

#include <bit>
#include <initializer_list>
#include <iosfwd>
#include <string_view>

#endif // TP_LIBSTDCXX_BITS_STREAMBUF_ITERATOR_H
