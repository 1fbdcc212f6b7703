//===- Instructions.h - The instruction set as data -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Everything here is generated from llvm-backend/TP*.td by generate_tables.py:
//
//   enum class Opcode : uint8_t       one enumerator per instruction
//   enum class Unit : uint8_t         functional units (FPADD, FPMIN, ...)
//   enum class LatencyClass : uint8_t (IntAdd, IntMul, ...)
//   enum class SpecialRegister : uint8_t  read by mfsr (thread, tp, ...)
//   NumOpcodes, NumUnits, NumLatencyClasses, NumSpecialRegisters
//   struct Body<Opcode>               operands and semantics (see Bodies.h)
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_ISA_INSTRUCTIONS_H
#define TP_SIMULATOR_ISA_INSTRUCTIONS_H

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

namespace tp {

#include "simulator/isa/InstructionEnums.inc"

/// The integer register that the calling convention makes the stack pointer.
inline constexpr uint8_t StackPointerRegister = 29;
/// The integer register that calls leave the address to come back to in.
inline constexpr uint8_t LinkRegister = 31;
/// Number of integer registers, and of float registers.
inline constexpr unsigned NumIntegerRegisters = 32;
/// A register number counts the integer registers from 0 and the float
/// registers from 32. Results for nobody (and for r0) go to this one.
inline constexpr unsigned NoRegister = 64;
/// Registers of a TP including NoRegister.
inline constexpr unsigned NumRegisters = 65;

/// What decode() makes of a word that is no instruction.
inline constexpr Opcode IllegalOpcode = Opcode(NumOpcodes);

/// A decoded instruction.
struct Instruction {
  /// The immediate that is not a bit position: sign-extended and scaled, a
  /// target in bytes from the instruction's own address.
  int32_t Immediate = 0;
  Opcode Op = IllegalOpcode;
  /// NoRegister if there is none or if it is r0.
  uint8_t Destination = NoRegister;
  /// Registers in the order of the operands in the .td; 0 where unused.
  uint8_t Source[3] = {0, 0, 0};
  /// The second immediate of the instructions that have two.
  uint8_t SecondImmediate = 0;
};

/// What an operand in an instruction word is.
enum class OperandKind : uint8_t { IntegerRegister, FloatRegister, Immediate };

/// An operand as the assembler sees it.
struct OperandInfo {
  /// Its name in the .td.
  std::string_view Name;
  OperandKind Kind;
  /// Written by the instruction. An operand can be both read and written.
  bool IsDestination;
  /// Place of the field in the word: lowest bit and number of bits.
  uint8_t Shift;
  uint8_t Width;
  /// Of immediates: whether the field is sign-extended, and what one step of
  /// the field stands for.
  bool IsSigned;
  uint8_t Scale;
};

/// The assembler's name, such as "add_s".
std::string_view mnemonic(Opcode Op);
/// The opcode of a mnemonic, if there is one.
std::optional<Opcode> findOpcode(std::string_view Mnemonic);
/// The .td's name of a unit, such as "FPADD".
std::string_view unitName(Unit Type);
/// The .td's name of a latency class, such as "FpAdd".
std::string_view latencyClassName(LatencyClass Class);
/// Cycles from issue to result that the .td states.
uint32_t defaultLatency(LatencyClass Class);
/// The assembler's name of a special register, such as "thread".
std::string_view specialRegisterName(SpecialRegister Register);
/// The operands of the assembly, the written one first.
std::span<const OperandInfo> operandsOf(Opcode Op);

/// Whether the instruction is one for the machine. If not, it takes no cycle,
/// fetch or unit and is not counted: it is a message to who watches the run.
constexpr bool takesTime(Opcode Op);
/// The functional unit that starts an instruction that takes time.
constexpr Unit unitOf(Opcode Op);
/// The latency class of an instruction that takes time.
constexpr LatencyClass latencyClassOf(Opcode Op);
constexpr Unit unitOf(LatencyClass Class);

/// Decodes an instruction word. A word that no instruction has gives
/// IllegalOpcode.
Instruction decode(uint32_t Word);

/// Encodes an instruction from its operands in the order of operandsOf():
/// register numbers 0 to 31, immediates as values (targets in bytes). Nothing
/// if their number or a value does not fit.
std::optional<uint32_t> encode(Opcode Op, std::span<const int64_t> Operands);

inline std::optional<uint32_t> encode(Opcode Op,
                                      std::initializer_list<int64_t> Operands) {
  return encode(Op, std::span(Operands.begin(), Operands.size()));
}

#include "simulator/isa/InstructionTraits.inc"

} // namespace tp

#endif // TP_SIMULATOR_ISA_INSTRUCTIONS_H
