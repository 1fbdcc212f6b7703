//===- Access.h - What memory an instruction accesses -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_ISA_ACCESS_H
#define TP_SIMULATOR_ISA_ACCESS_H

#include "simulator/isa/Instructions.h"

#include <array>
#include <cstdint>
#include <optional>

namespace tp {

/// An access to memory.
struct MemoryAccess {
  uint32_t Address = 0;
  uint32_t Bytes = 0;
  bool Reads = false;
  bool Writes = false;
  /// Of a stream operation, which accesses other words too.
  bool IsStream = false;
};

/// What \p Decoded accesses if a thread with these registers executes it, also
/// if that would trap. Of a stream operation it is the descriptor's first word;
/// of a host call nothing.
std::optional<MemoryAccess>
accessOf(const Instruction &Decoded,
         const std::array<uint32_t, NumRegisters> &Registers);

/// Whether instructions of this kind access memory.
bool accessesMemory(Opcode Op);

} // namespace tp

#endif // TP_SIMULATOR_ISA_ACCESS_H
