//===- FunctionalSimulation.h - A test program without timing ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_FUNCTIONAL_FUNCTIONALSIMULATION_H
#define TP_TEST_UNIT_FUNCTIONAL_FUNCTIONALSIMULATION_H

#include "simulator/functional/FunctionalMachine.h"
#include "test/unit/core/Simulation.h"

#include <string>

namespace tp::test {

/// A program in the functional mode.
struct FunctionalSimulation {
  ChipConfig Chip;
  Memory Global;
  Program Text;
  FunctionalMachine Machine;
  std::string Output;

  FunctionalSimulation(const ChipConfig &Chip, const Assembly &Source)
      : Chip(Chip), Global(Chip.MemoryBytes),
        Text(TextBegin, Source.words(), TextBegin),
        Machine(this->Chip, Text, Global) {
    Machine.setOutput([this](int, std::string_view Bytes) { Output += Bytes; });
  }

  uint32_t word(uint32_t Address) const {
    uint32_t Value = 0;
    Global.read(Address, &Value, sizeof(Value));
    return Value;
  }
};

} // namespace tp::test

#endif // TP_TEST_UNIT_FUNCTIONAL_FUNCTIONALSIMULATION_H
