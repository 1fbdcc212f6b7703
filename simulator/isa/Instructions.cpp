//===- Instructions.cpp - Decoding and encoding ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/isa/Instructions.h"

namespace tp {

namespace {

/// The bits that say which instruction a word is.
struct Encoding {
  uint32_t Mask;
  uint32_t Value;
};

} // namespace

static uint32_t field(uint32_t Word, unsigned Shift, unsigned Width) {
  return Word >> Shift & ((1u << Width) - 1);
}

static int32_t signedField(uint32_t Word, unsigned Shift, unsigned Width) {
  return int32_t(Word << (32 - Width - Shift)) >> (32 - Width);
}

static uint8_t destination(uint32_t Register) {
  return Register == 0 ? NoRegister : Register;
}

#include "simulator/isa/InstructionTables.inc"

std::string_view mnemonic(Opcode Op) {
  return Op == IllegalOpcode ? "illegal" : Mnemonics[unsigned(Op)];
}

std::optional<Opcode> findOpcode(std::string_view Mnemonic) {
  for (unsigned I = 0; I != NumOpcodes; ++I)
    if (Mnemonics[I] == Mnemonic)
      return Opcode(I);
  return std::nullopt;
}

std::string_view unitName(Unit Type) { return UnitNames[unsigned(Type)]; }

std::string_view latencyClassName(LatencyClass Class) {
  return LatencyClassNames[unsigned(Class)];
}

uint32_t defaultLatency(LatencyClass Class) {
  return DefaultLatencies[unsigned(Class)];
}

std::string_view specialRegisterName(SpecialRegister Register) {
  return SpecialRegisterNames[unsigned(Register)];
}

std::span<const OperandInfo> operandsOf(Opcode Op) {
  return Operands[unsigned(Op)];
}

Instruction decode(uint32_t Word) {
  Instruction Result;
  for (unsigned I = 0; I != NumOpcodes; ++I) {
    if ((Word & Encodings[I].Mask) != Encodings[I].Value)
      continue;
    Result.Op = Opcode(I);
    extractOperands(Word, Result);
    break;
  }
  return Result;
}

std::optional<uint32_t> encode(Opcode Op, std::span<const int64_t> Values) {
  std::span<const OperandInfo> Infos = operandsOf(Op);
  if (Values.size() != Infos.size())
    return std::nullopt;
  uint32_t Word = Encodings[unsigned(Op)].Value;
  for (size_t I = 0; I != Infos.size(); ++I) {
    const OperandInfo &Info = Infos[I];
    int64_t Span = int64_t(1) << Info.Width;
    int64_t Low = Info.IsSigned ? -Span / 2 : 0;
    int64_t Field = Values[I] / Info.Scale;
    if (Field * Info.Scale != Values[I] || Field < Low || Field >= Low + Span)
      return std::nullopt;
    Word |= (uint32_t(Field) & uint32_t(Span - 1)) << Info.Shift;
  }
  return Word;
}

} // namespace tp
