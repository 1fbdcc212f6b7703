//===- Step.h - One instruction as a function -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Steps.cpp makes a function of each instruction and float mode. They are
// compiled to LLVM bitcode, which is part of the simulator; generated code
// calls them with the decoded operands as constants, and the optimizer puts
// them in place.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_STEP_H
#define TP_SIMULATOR_JIT_STEP_H

#include "simulator/core/Thread.h"

#include <cstdint>

namespace tp {

/// What a step did. Kind has the numbers of ExecutionContext's Outcome; after
/// anything but StepNext and StepBranch nothing has been done.
struct StepResult {
  uint32_t Value;
  /// When Value is ready.
  ReadyWord Ready;
  /// Number of the next instruction in the text after StepBranch.
  uint32_t TargetWord;
  uint8_t Kind;
};

inline constexpr uint8_t StepNext = 0;
inline constexpr uint8_t StepBranch = 1;

} // namespace tp

#endif // TP_SIMULATOR_JIT_STEP_H
