//===- ControlFlow.h - Where a thread goes after an instruction -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_CONTROLFLOW_H
#define TP_SIMULATOR_JIT_CONTROLFLOW_H

#include "simulator/isa/Instructions.h"

#include <cstdint>
#include <optional>

namespace tp {

/// What a former of blocks must know of an instruction.
enum class Flow : uint8_t {
  /// It is followed by the next one.
  Next,
  /// It is followed by the next one or by the one at its immediate.
  Branch,
  /// It is followed by the one at its immediate.
  Jump,
  /// It is followed by the one that a register says.
  IndirectJump,
  /// The thread may stop there, or its result is not the instruction's own
  /// business: barriers, halts, atomics, host calls, links that depend on a
  /// condition, and what is no instruction.
  Special,
};

Flow flowOf(Opcode Op);

/// Whether the instruction calls a function: it will likely come back to the
/// next instruction.
bool isCall(Opcode Op);

inline bool isLoad(Opcode Op) {
  return takesTime(Op) && latencyClassOf(Op) == LatencyClass::Load;
}

/// The word of the text where a branch or direct jump in word \p Word goes, if
/// it is one of the \p NumWords words.
std::optional<uint32_t> targetOf(const Instruction &Decoded, uint32_t Word,
                                 uint32_t NumWords);

} // namespace tp

#endif // TP_SIMULATOR_JIT_CONTROLFLOW_H
