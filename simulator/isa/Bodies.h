//===- Bodies.h - What each instruction computes ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// For each opcode there is a struct Body<Opcode> with the operands of the .td
// as members: sources (and the old value of a register that is read and
// written) and immediates are set, the destination is written by run(), whose
// few lines stand in semantics/*.inc. An instruction without such lines does
// not link.
//
// A body sees the machine only through its context:
//
//   operand(float), result(float)  the rules of FloatRules.h
//   load<T>(address), store<T>(address, value)
//   atomic(address, operand, expected, function)
//       replaces the word at the address by function(old, operand, expected);
//       gives the old word
//   stream(descriptor, value, function)
//       gives function(memory, descriptor, value), done as one access
//   branch(offset in bytes), jump(address), link() (the next instruction's
//   address), keepDestination() (the destination is not written after all)
//   special(number), marker(number), profileValue(marker, value), barrier(),
//   sync(), sleep(cycles), halt(status), hostCall(service, a, b, c)
//   trap(kind, address)
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_ISA_BODIES_H
#define TP_SIMULATOR_ISA_BODIES_H

#include "simulator/isa/FloatRules.h"
#include "simulator/isa/Instructions.h"
#include "simulator/isa/StreamAccess.h"
#include "simulator/isa/TrapKind.h"
#include "simulator/isa/Trigonometry.h"

#include <bit>
#include <cmath>

namespace tp {

template <Opcode Op> struct Body;

#include "simulator/isa/InstructionBodies.inc"

#define TP_BODY(NAME)                                                          \
  template <class Context>                                                     \
  inline void Body<Opcode::NAME>::run([[maybe_unused]] Context &context)

#include "simulator/isa/semantics/Arithmetic.inc"
#include "simulator/isa/semantics/Bitwise.inc"
#include "simulator/isa/semantics/Control.inc"
#include "simulator/isa/semantics/Float.inc"
#include "simulator/isa/semantics/Memory.inc"

#undef TP_BODY

} // namespace tp

#endif // TP_SIMULATOR_ISA_BODIES_H
