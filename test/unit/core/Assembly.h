//===- Assembly.h - Programs for the engine's tests -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Encodes through the generated operand tables, independent of LLVM's MC layer.
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_CORE_ASSEMBLY_H
#define TP_TEST_UNIT_CORE_ASSEMBLY_H

#include "simulator/isa/Instructions.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tp::test {

/// Where the programs of the tests start.
inline constexpr uint32_t TextBegin = 0x10000;

/// Collects instructions: `A("addi", 4, 0, -1)("bne", 4, 0, "loop")`. Registers
/// are their numbers, integer or float as the instruction has it; a target is
/// a label or a distance in bytes.
class Assembly {
public:
  class Operand {
  public:
    template <class Integer>
      requires std::is_integral_v<Integer>
    Operand(Integer Value) : Value(int64_t(Value)) {}
    Operand(const char *Label) : Label(Label) {}

    int64_t Value = 0;
    std::string Label;
  };

  template <class... Operands>
  Assembly &operator()(std::string_view Mnemonic, Operands... Values) {
    return add(Mnemonic, {Operand(Values)...});
  }

  /// Any number of times the same instruction.
  template <class... Operands>
  Assembly &repeat(unsigned Times, std::string_view Mnemonic,
                   Operands... Values) {
    for (unsigned I = 0; I != Times; ++I)
      add(Mnemonic, {Operand(Values)...});
    return *this;
  }

  /// The same with the operands as a list.
  Assembly &add(std::string_view Mnemonic, std::vector<Operand> Operands);
  Assembly &label(const std::string &Name);
  /// A word as it is.
  Assembly &word(uint32_t Word);
  /// Loads a 32-bit constant: always lui, ori.
  Assembly &constant(unsigned Register, uint32_t Value);

  uint32_t nextAddress() const {
    return TextBegin + uint32_t(Lines.size()) * 4;
  }
  /// Ends the test program if an instruction cannot be encoded.
  std::vector<uint32_t> words() const;

private:
  struct Line {
    std::string Mnemonic;
    std::vector<Operand> Operands;
    uint32_t Word = 0;
  };

  std::vector<Line> Lines;
  std::map<std::string, uint32_t> Labels;
};

} // namespace tp::test

#endif // TP_TEST_UNIT_CORE_ASSEMBLY_H
