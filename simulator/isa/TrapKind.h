//===- TrapKind.h - Reasons for which an instruction traps ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_ISA_TRAPKIND_H
#define TP_SIMULATOR_ISA_TRAPKIND_H

#include <cstdint>

namespace tp {

/// Why an instruction could not be executed.
enum class TrapKind : uint8_t {
  /// The word is no instruction, or its operands make none.
  IllegalInstruction,
  /// The next instruction is outside the program's text or misaligned.
  FetchOutsideText,
  /// The address is no multiple of the access's size.
  MisalignedAccess,
  /// The address is in the first 64 KiB.
  NullAccess,
  /// The address is neither in global memory nor in the local store, or in the
  /// reserved last 16 bytes of the local store.
  AddressOutOfRange,
  /// A store into the program's text or constants.
  StoreToReadOnly,
  DivisionByZero,
  /// A conditional trap instruction (teq, tlt, ...) whose condition held.
  Condition,
  /// A `break` instruction.
  Break,
  /// A host call with an unknown service or a bad argument.
  BadHostCall,
  /// A chip that flushes subnormals would lose an operand, or a result, of a
  /// function compiled with floating-point checks.
  SubnormalOperand,
  SubnormalResult,
  /// The stack pointer has fallen below the limit that the linker set it.
  StackOverflow,
  /// A stream operation on something that is not a stream.
  BadStream,
};

} // namespace tp

#endif // TP_SIMULATOR_ISA_TRAPKIND_H
