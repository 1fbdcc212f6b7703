//===- ControlFlow.cpp - Where a thread goes after an instruction ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/ControlFlow.h"

namespace tp {

Flow flowOf(Opcode Op) {
  switch (Op) {
  case IllegalOpcode:
  case Opcode::BLTZAL:
  case Opcode::BGEZAL:
  case Opcode::BARRIER:
  case Opcode::SYNC:
  case Opcode::SLEEP:
  case Opcode::HALT:
  case Opcode::HOSTCALL:
    return Flow::Special;
  case Opcode::J:
  case Opcode::JAL:
    return Flow::Jump;
  case Opcode::JR:
  case Opcode::JALR:
    return Flow::IndirectJump;
  default:
    break;
  }
  if (!takesTime(Op))
    return Flow::Next;
  switch (latencyClassOf(Op)) {
  case LatencyClass::Branch:
    return Flow::Branch;
  case LatencyClass::Atomic:
    return Flow::Special;
  default:
    return Flow::Next;
  }
}

bool isCall(Opcode Op) { return Op == Opcode::JAL || Op == Opcode::JALR; }

std::optional<uint32_t> targetOf(const Instruction &Decoded, uint32_t Word,
                                 uint32_t NumWords) {
  int64_t Target = int64_t(Word) + Decoded.Immediate / 4;
  if (Decoded.Immediate % 4 != 0 || Target < 0 || Target >= NumWords)
    return std::nullopt;
  return uint32_t(Target);
}

} // namespace tp
