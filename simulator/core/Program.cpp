//===- Program.cpp - A program's text, decoded ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/Program.h"

#include <algorithm>

namespace tp {

Program::Program(uint32_t TextBegin, std::span<const uint32_t> Words,
                 uint32_t Entry, uint32_t ReadOnlyEnd)
    : TextBegin(TextBegin), Entry(Entry) {
  Decoded.reserve(Words.size());
  for (uint32_t Word : Words)
    Decoded.push_back(decode(Word));
  this->ReadOnlyEnd = std::max(ReadOnlyEnd, textEnd());
}

void Program::addFloatChecked(uint32_t Begin, uint32_t End) {
  FloatChecked.resize(Decoded.size());
  for (uint32_t Address = Begin; Address < End; Address += 4)
    FloatChecked.at((Address - TextBegin) / 4) = true;
}

bool Program::isFloatChecked(uint32_t Address) const {
  return !FloatChecked.empty() && FloatChecked[(Address - TextBegin) / 4];
}

} // namespace tp
