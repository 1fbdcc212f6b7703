//===- ValuePrinter.h - Values as text --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_VALUEPRINTER_H
#define TP_DEBUGGER_SOURCE_VALUEPRINTER_H

#include "debugger/source/Value.h"

#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <string>

namespace tp {

class SourceMap;

/// How to print.
struct PrintOptions {
  /// gdb's letter: x d u o t a c f s z, or 0 for what the type says.
  char Format = 0;
  /// Structures and arrays further in are printed as `{...}`.
  unsigned MaxDepth = 20;
  /// Elements of an array and characters of a string, of which more are
  /// printed as `...`.
  unsigned MaxElements = 200;
  /// From how many equal elements on these are printed as
  /// `0 <repeats 15 times>`.
  unsigned RepeatThreshold = 10;
  /// A member per line.
  bool Pretty = false;
};

/// Prints values: `{X = 1, Y = 2}`, `(int *) 0x00010000`, `"text"`.
class ValuePrinter {
public:
  /// \p Map names functions and symbols; it must outlive the printer.
  explicit ValuePrinter(const SourceMap &Map) : Map(Map) {}

  /// `<optimized out>` where there is no value, `<error: ...>` where it cannot
  /// be read.
  std::string print(const Value &Of, const FrameContext &Frame,
                    const PrintOptions &Options = {}) const;
  /// The same in a few dozen characters, for a list.
  std::string summary(const Value &Of, const FrameContext &Frame) const;

private:
  const SourceMap &Map;

  class Writer;
};

/// A floating-point number with as many digits as tell it from its neighbours:
/// of type float for up to 4 \p Bytes, else double.
std::string formatReal(double Number, unsigned Bytes);

/// A character as `97 'a'` prints it, with the quotes.
std::string quotedCharacter(uint32_t Character);

/// One number of 1, 2, 4 or 8 bytes by one of gdb's letters (x d u o t a c f
/// z), as the commands x and `info registers` print it.
std::string formatNumber(llvm::ArrayRef<uint8_t> Bytes, char Format,
                         const SourceMap &Map);

/// \p Text as a literal of C: quotes, escapes.
std::string quoted(llvm::StringRef Text);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_VALUEPRINTER_H
