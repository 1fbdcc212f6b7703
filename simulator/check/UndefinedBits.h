//===- UndefinedBits.h - What results of undefined bits are -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A bit is undefined if it may be another one when undefined bits of the
// instruction's operands are others; here it may also be called so where that
// would be hard to find out, but never where compiled code relies on it: in
// logic, moves, shifts and comparisons of integers. Of a sum all bits from the
// lowest undefined one on are called so.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_UNDEFINEDBITS_H
#define TP_SIMULATOR_CHECK_UNDEFINEDBITS_H

#include "simulator/isa/Bodies.h"

#include <cstdint>
#include <optional>

namespace tp {

/// The bits of a value that are undefined.
using UndefinedBits = uint32_t;

inline constexpr UndefinedBits AllUndefined = ~0u;

/// Undefined bits make all higher ones undefined, as by carries.
constexpr UndefinedBits spreadUpwards(UndefinedBits Bits) {
  return Bits | (0 - Bits);
}

/// Whether a == b may have both answers.
constexpr bool isEqualityUndefined(uint32_t A, UndefinedBits OfA, uint32_t B,
                                   UndefinedBits OfB) {
  UndefinedBits Either = OfA | OfB;
  return Either != 0 && ((A ^ B) & ~Either) == 0;
}

/// Whether a < b, without signs, may have both answers.
constexpr bool isOrderUndefined(uint32_t A, UndefinedBits OfA, uint32_t B,
                                UndefinedBits OfB) {
  uint32_t MinA = A & ~OfA, MaxA = A | OfA;
  uint32_t MinB = B & ~OfB, MaxB = B | OfB;
  return MinA < MaxB && MaxA >= MinB;
}

/// The same with signs.
constexpr bool isSignedOrderUndefined(uint32_t A, UndefinedBits OfA, uint32_t B,
                                      UndefinedBits OfB) {
  constexpr uint32_t Sign = 0x80000000;
  return isOrderUndefined(A ^ Sign, OfA, B ^ Sign, OfB);
}

constexpr UndefinedBits undefinedAnd(uint32_t A, UndefinedBits OfA, uint32_t B,
                                     UndefinedBits OfB) {
  return (OfA | OfB) & (OfA | A) & (OfB | B);
}

constexpr UndefinedBits undefinedOr(uint32_t A, UndefinedBits OfA, uint32_t B,
                                    UndefinedBits OfB) {
  return (OfA | OfB) & (OfA | ~A) & (OfB | ~B);
}

/// Of one of two values, when nobody knows of which one.
constexpr UndefinedBits undefinedChoice(uint32_t A, UndefinedBits OfA,
                                        uint32_t B, UndefinedBits OfB) {
  return OfA | OfB | (A ^ B);
}

/// True for instructions that only move bits and copies of bits.
constexpr bool movesBits(Opcode Op) {
  switch (Op) {
  case Opcode::SLL:
  case Opcode::SRL:
  case Opcode::SRA:
  case Opcode::ROTR:
  case Opcode::EXT:
  case Opcode::INS:
  case Opcode::SEB:
  case Opcode::SEH:
  case Opcode::MOV_S:
  case Opcode::MFC1:
  case Opcode::MTC1:
    return true;
  default:
    return false;
  }
}

/// What the bodies of instructions that move bits need of a context.
struct NoContext {
  void trap(TrapKind) {}
};

/// The undefined bits of the result of an instruction without access to memory
/// whose operands are \p Run; \p Sources are those of its source registers, not
/// all 0.
template <Opcode Op>
UndefinedBits undefinedResult(const Instruction &Decoded, const Body<Op> &Run,
                              const UndefinedBits (&Sources)[3]) {
  [[maybe_unused]] NoContext Context;
  const auto [First, Second, Third] = Sources;
  if constexpr (movesBits(Op)) {
    Instruction Operands = Decoded;
    for (uint8_t I = 0; I != 3; ++I)
      Operands.Source[I] = I;
    Body<Op> OfBits(Operands, Sources);
    OfBits.run(Context);
    return OfBits.result();
  } else if constexpr (Op == Opcode::SLLV || Op == Opcode::SRLV ||
                       Op == Opcode::SRAV || Op == Opcode::ROTRV) {
    if ((Second & 31) != 0)
      return AllUndefined;
    Body<Op> OfBits = Run;
    OfBits.rs = First;
    OfBits.run(Context);
    return OfBits.result();
  } else if constexpr (Op == Opcode::ADD || Op == Opcode::SUB ||
                       Op == Opcode::MUL) {
    return spreadUpwards(First | Second);
  } else if constexpr (Op == Opcode::ADDI) {
    return spreadUpwards(First);
  } else if constexpr (Op == Opcode::AND) {
    return undefinedAnd(Run.rs, First, Run.rt, Second);
  } else if constexpr (Op == Opcode::OR || Op == Opcode::NOR) {
    return undefinedOr(Run.rs, First, Run.rt, Second);
  } else if constexpr (Op == Opcode::XOR) {
    return First | Second;
  } else if constexpr (Op == Opcode::ANDI) {
    return First & uint32_t(Run.imm);
  } else if constexpr (Op == Opcode::ORI) {
    return First & ~uint32_t(Run.imm);
  } else if constexpr (Op == Opcode::XORI) {
    return First;
  } else if constexpr (Op == Opcode::SLT) {
    return isSignedOrderUndefined(Run.rs, First, Run.rt, Second);
  } else if constexpr (Op == Opcode::SLTU || Op == Opcode::SUBC) {
    return isOrderUndefined(Run.rs, First, Run.rt, Second);
  } else if constexpr (Op == Opcode::SLTI) {
    return isSignedOrderUndefined(Run.rs, First, uint32_t(Run.imm), 0);
  } else if constexpr (Op == Opcode::SLTIU) {
    return isOrderUndefined(Run.rs, First, uint32_t(Run.imm), 0);
  } else if constexpr (Op == Opcode::ABS_S || Op == Opcode::NEG_S) {
    return Op == Opcode::ABS_S ? First & ~FloatSignBit : First;
  } else if constexpr (Op == Opcode::MOVN || Op == Opcode::MOVZ ||
                       Op == Opcode::MOVN_S || Op == Opcode::MOVZ_S) {
    constexpr bool WhenZero = Op == Opcode::MOVZ || Op == Opcode::MOVZ_S;
    if (isEqualityUndefined(Run.rt, Third, 0, 0))
      return undefinedChoice(toBits(Run.rdold), First, toBits(Run.rs), Second);
    return (Run.rt == 0) == WhenZero ? Second : First;
  } else if constexpr (Op == Opcode::ADDC) {
    const auto Least = uint64_t(Run.rs & ~First) + (Run.rt & ~Second);
    const auto Most = uint64_t(Run.rs | First) + (Run.rt | Second);
    return Least >> 32 != Most >> 32;
  } else if constexpr (Op >= Opcode::C_UN_S && Op <= Opcode::C_ULE_S) {
    return 1;
  } else {
    return AllUndefined;
  }
}

/// The undefined bits of the word that an atomic operation leaves behind:
/// \p Old and \p OfOld are those that it found, \p OfOperand those of its
/// operand, \p OfExpected those of what a compare-and-swap expects.
template <Opcode Op>
UndefinedBits undefinedWord(const Body<Op> &Run, uint32_t Old,
                            UndefinedBits OfOld, UndefinedBits OfOperand,
                            UndefinedBits OfExpected) {
  if constexpr (Op == Opcode::ATOM_CAS) {
    if (isEqualityUndefined(Old, OfOld, Run.rdold, OfExpected))
      return undefinedChoice(Old, OfOld, Run.rt, OfOperand);
    return Old == Run.rdold ? OfOperand : OfOld;
  } else if constexpr (Op == Opcode::ATOM_SWAP) {
    return OfOperand;
  } else if constexpr (Op == Opcode::ATOM_ADD) {
    return spreadUpwards(OfOld | OfOperand);
  } else if constexpr (Op == Opcode::ATOM_AND) {
    return undefinedAnd(Old, OfOld, Run.rt, OfOperand);
  } else if constexpr (Op == Opcode::ATOM_OR) {
    return undefinedOr(Old, OfOld, Run.rt, OfOperand);
  } else if constexpr (Op == Opcode::ATOM_XOR) {
    return OfOld | OfOperand;
  } else {
    return undefinedChoice(Old, OfOld, Run.rt, OfOperand);
  }
}

/// Whether the condition of a branch or conditional trap may have both answers.
template <Opcode Op>
bool isConditionUndefined(const Body<Op> &Run, UndefinedBits First,
                          UndefinedBits Second) {
  if constexpr (Op == Opcode::BEQ || Op == Opcode::BNE || Op == Opcode::TEQ ||
                Op == Opcode::TNE)
    return isEqualityUndefined(Run.rs, First, Run.rt, Second);
  else if constexpr (Op == Opcode::BLT || Op == Opcode::BGE ||
                     Op == Opcode::TLT || Op == Opcode::TGE)
    return isSignedOrderUndefined(Run.rs, First, Run.rt, Second);
  else if constexpr (Op == Opcode::BLTU || Op == Opcode::BGEU ||
                     Op == Opcode::TLTU || Op == Opcode::TGEU)
    return isOrderUndefined(Run.rs, First, Run.rt, Second);
  else if constexpr (Op == Opcode::BLTZAL || Op == Opcode::BGEZAL)
    return isSignedOrderUndefined(Run.rs, First, 0, 0);
  else
    return false;
}

} // namespace tp

#endif // TP_SIMULATOR_CHECK_UNDEFINEDBITS_H
