//===- Trap.h - Why a simulated program was stopped -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_TRAP_H
#define TP_SIMULATOR_CORE_TRAP_H

#include "simulator/isa/TrapKind.h"

#include <cstdint>
#include <string>

namespace tp {

/// A trap: it ends the run.
struct Trap {
  TrapKind Kind = TrapKind::IllegalInstruction;
  /// Thread number in the chip: TM * TPs per TM + TP.
  uint32_t Thread = 0;
  /// Address of the instruction that trapped.
  uint32_t Pc = 0;
  /// The offending data address; the address of the missing instruction; the
  /// code of a `break`; the service of a bad host call; the bits of a
  /// subnormal; the stack pointer that has fallen too low.
  uint32_t Address = 0;
  /// Cycle in which the instruction would have issued.
  uint64_t Cycle = 0;

  /// What happened, without thread and place: "store to read-only memory at
  /// 0x00010004".
  std::string what() const;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_TRAP_H
