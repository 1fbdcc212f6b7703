//===- Format.h - The engine of printf --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_LIBC_FORMAT_H
#define TP_RUNTIME_LIB_LIBC_FORMAT_H

#include <stdarg.h>

namespace tp {

/// Where formatted text goes, piece by piece.
struct TextSink {
  void (*Write)(TextSink &Sink, const char *Text, unsigned Bytes);
};

/// Writes what C's printf makes of \p Format and \p Arguments to \p Sink and
/// returns the number of characters. All of C17's conversions but those of wide
/// characters; doubles are exactly rounded. An unknown conversion is written as
/// it stands.
int formatText(TextSink &Sink, const char *Format, va_list Arguments);

} // namespace tp

#endif // TP_RUNTIME_LIB_LIBC_FORMAT_H
