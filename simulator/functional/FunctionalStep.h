//===- FunctionalStep.h - One instruction as a function ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// As jit/Step.h, for the functional mode.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALSTEP_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALSTEP_H

#include <cstdint>

namespace tp {

/// What a step did. Kind has the numbers of FunctionalContext's Outcome; after
/// anything but FunctionalStepNext and FunctionalStepBranch nothing has been
/// done.
struct FunctionalStepResult {
  uint32_t Value;
  /// Number of the next instruction in the text after FunctionalStepBranch.
  uint32_t TargetWord;
  uint8_t Kind;
};

inline constexpr uint8_t FunctionalStepNext = 0;
inline constexpr uint8_t FunctionalStepBranch = 1;

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALSTEP_H
