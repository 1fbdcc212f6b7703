//===- InstructionCases.h - What each instruction should do -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Every instruction has one case: either an independent computation of its
// result, which is compared over edge values, or a test of its own.
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_ISA_INSTRUCTIONCASES_H
#define TP_TEST_UNIT_ISA_INSTRUCTIONCASES_H

#include "simulator/isa/Instructions.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace tp::test {

/// Operands of one execution; registers as their bits.
struct Inputs {
  uint32_t Rs = 0;
  uint32_t Rt = 0;
  /// The destination's value before.
  uint32_t Old = 0;
  int64_t First = 0;
  /// The second immediate.
  int64_t Second = 0;
};

/// An instruction that computes its destination from registers and immediates.
struct ValueCase {
  /// The result, or nothing if the instruction traps.
  std::function<std::optional<uint32_t>(const Inputs &)> Expected;
  /// Arithmetic: chips that flush to zero flush its operands and result.
  bool Flushes = false;
  /// The destination is an operand of the arithmetic too.
  bool Accumulates = false;
  /// Distance that a float result may have from the expected one.
  uint32_t Ulps = 0;
};

using InstructionCase = std::variant<ValueCase, std::function<void()>>;
/// By mnemonic.
using InstructionCases = std::map<std::string, InstructionCase>;

void addIntegerCases(InstructionCases &Cases);
void addFloatCases(InstructionCases &Cases);
void addMemoryCases(InstructionCases &Cases);
void addControlCases(InstructionCases &Cases);

} // namespace tp::test

#endif // TP_TEST_UNIT_ISA_INSTRUCTIONCASES_H
