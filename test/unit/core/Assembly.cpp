//===- Assembly.cpp - Programs for the engine's tests ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Assembly.h"

#include <cstdio>
#include <cstdlib>

namespace tp::test {

Assembly &Assembly::add(std::string_view Mnemonic,
                        std::vector<Operand> Operands) {
  Lines.push_back({std::string(Mnemonic), std::move(Operands)});
  return *this;
}

Assembly &Assembly::label(const std::string &Name) {
  Labels[Name] = nextAddress();
  return *this;
}

Assembly &Assembly::word(uint32_t Word) {
  Lines.push_back({"", {}, Word});
  return *this;
}

Assembly &Assembly::constant(unsigned Register, uint32_t Value) {
  return (*this)("lui", Register, Value >> 16)("ori", Register, Register,
                                               Value & 0xFFFF);
}

std::vector<uint32_t> Assembly::words() const {
  std::vector<uint32_t> Words;
  for (const Line &L : Lines) {
    if (L.Mnemonic.empty()) {
      Words.push_back(L.Word);
      continue;
    }
    uint32_t Address = TextBegin + uint32_t(Words.size()) * 4;
    std::vector<int64_t> Values;
    Values.reserve(L.Operands.size());
    for (const Operand &O : L.Operands)
      Values.push_back(O.Label.empty()
                           ? O.Value
                           : int64_t(Labels.at(O.Label)) - int64_t(Address));
    std::optional<Opcode> Op = findOpcode(L.Mnemonic);
    std::optional<uint32_t> Word;
    if (Op)
      Word = encode(*Op, Values);
    if (!Word) {
      std::fprintf(stderr, "cannot encode '%s'\n", L.Mnemonic.c_str());
      std::abort();
    }
    Words.push_back(*Word);
  }
  return Words;
}

} // namespace tp::test
