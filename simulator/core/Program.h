//===- Program.h - A program's text, decoded --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_PROGRAM_H
#define TP_SIMULATOR_CORE_PROGRAM_H

#include "simulator/isa/Instructions.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// True for an instruction that computes the stack pointer from itself, as
/// those of a function's frame do.
inline bool movesStackPointer(const Instruction &Decoded) {
  return Decoded.Destination == StackPointerRegister &&
         std::ranges::find(Decoded.Source, StackPointerRegister) !=
             std::end(Decoded.Source);
}

/// The text of a program, decoded once. Text is read-only for the program.
class Program {
public:
  /// \p Words is the text; its first word is at address \p TextBegin (a
  /// multiple of 4). Threads start at \p Entry. Stores to
  /// [TextBegin, ReadOnlyEnd) trap; the text is always part of it.
  Program(uint32_t TextBegin, std::span<const uint32_t> Words, uint32_t Entry,
          uint32_t ReadOnlyEnd = 0);

  uint32_t textBegin() const { return TextBegin; }
  uint32_t textEnd() const { return TextBegin + uint32_t(Decoded.size()) * 4; }
  uint32_t entry() const { return Entry; }
  uint32_t readOnlyEnd() const { return ReadOnlyEnd; }
  /// One per word of the text.
  std::span<const Instruction> instructions() const { return Decoded; }

  /// The functions of [\p Begin, \p End) in the text are compiled with
  /// floating-point checks: where the chip would flush a subnormal there, it
  /// traps.
  void addFloatChecked(uint32_t Begin, uint32_t End);
  bool isFloatChecked(uint32_t Address) const;

  /// The stack pointer may not fall below \p Limit. 0 at first: no limit.
  void setStackLimit(uint32_t Limit) { StackLimit = Limit; }
  uint32_t stackLimit() const { return StackLimit; }

private:
  uint32_t TextBegin;
  uint32_t Entry;
  uint32_t StackLimit = 0;
  uint32_t ReadOnlyEnd;
  std::vector<Instruction> Decoded;
  /// Empty, or one per word of the text.
  std::vector<bool> FloatChecked;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_PROGRAM_H
