//===- DecoderAgreementTest.cpp - Disassembler against simulator ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The disassembler and the simulator's decoder come from the same .td files
// through different generators. They have to see the same instruction with the
// same operands in every word.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MachineCode/MachineCode.h"
#include "simulator/isa/Instructions.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/MC/MCInst.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/raw_ostream.h"
#include "gtest/gtest.h"
#include <random>

using namespace llvm;

namespace {

class DecoderAgreementTest : public testing::Test {
protected:
  DecoderAgreementTest()
      : Disassembler(Code.createDisassembler()), Encoder(Code.createEncoder()),
        Printer(Code.createPrinter()) {}

  /// The instruction that the disassembler sees, if it sees one.
  std::optional<MCInst> disassemble(uint32_t Word) const {
    uint8_t Bytes[4];
    support::endian::write32le(Bytes, Word);
    MCInst Instruction;
    uint64_t Size;
    if (Disassembler->getInstruction(Instruction, Size, Bytes, 0, nulls()) !=
        MCDisassembler::Success)
      return std::nullopt;
    return Instruction;
  }

  uint32_t encode(const MCInst &Instruction) const {
    SmallString<4> Bytes;
    SmallVector<MCFixup, 1> Fixups;
    Encoder->encodeInstruction(Instruction, Bytes, Fixups, *Code.Subtarget);
    return support::endian::read32le(Bytes.data());
  }

  void check(uint32_t Word) const {
    std::optional<MCInst> Instruction = disassemble(Word);
    tp::Instruction Decoded = tp::decode(Word);
    if (!Instruction) {
      // The simulator traps when it executes these.
      std::string_view Name = tp::mnemonic(Decoded.Op);
      EXPECT_TRUE(Decoded.Op == tp::IllegalOpcode || Name == "ext" ||
                  Name == "ins" || Name == "mfsr")
          << std::hex << Word << ' ' << Name;
      return;
    }
    ASSERT_NE(Decoded.Op, tp::IllegalOpcode) << std::hex << Word;
    StringRef Mnemonic = Printer->getMnemonic(*Instruction).first;
    EXPECT_EQ(Mnemonic.rtrim(), StringRef(tp::mnemonic(Decoded.Op)))
        << std::hex << Word;
    EXPECT_EQ(encode(*Instruction), Word);
    checkImmediates(*Instruction, Decoded, Word);
    checkRegisters(*Instruction, Decoded, Word);
  }

  /// Immediates are in the same order on both sides.
  static void checkImmediates(const MCInst &Instruction,
                              const tp::Instruction &Decoded, uint32_t Word) {
    SmallVector<int64_t, 2> Expected;
    for (const MCOperand &Operand : Instruction)
      if (Operand.isImm())
        Expected.push_back(Operand.getImm());
    if (Expected.size() > 0)
      EXPECT_EQ(int64_t(int32_t(Decoded.Immediate)), Expected[0])
          << std::hex << Word;
    if (Expected.size() > 1)
      EXPECT_EQ(int64_t(Decoded.SecondImmediate), Expected[1])
          << std::hex << Word;
  }

  /// Debuggers number the registers as the simulator does: 0 to 63.
  void checkRegisters(const MCInst &Instruction, const tp::Instruction &Decoded,
                      uint32_t Word) const {
    unsigned NumDestinations =
        Code.Instructions->get(Instruction.getOpcode()).getNumDefs();
    unsigned Source = 0;
    for (unsigned I = 0; I != Instruction.getNumOperands(); ++I) {
      const MCOperand &Operand = Instruction.getOperand(I);
      if (!Operand.isReg())
        continue;
      int Number = Code.Registers->getDwarfRegNum(Operand.getReg(), false);
      if (I >= NumDestinations)
        EXPECT_EQ(Decoded.Source[Source++], Number) << std::hex << Word;
      else
        EXPECT_EQ(Decoded.Destination, Number ? Number : tp::NoRegister)
            << std::hex << Word;
    }
  }

  tp::MachineCode Code;
  std::unique_ptr<MCDisassembler> Disassembler;
  std::unique_ptr<MCCodeEmitter> Encoder;
  std::unique_ptr<MCInstPrinter> Printer;
};

TEST_F(DecoderAgreementTest, EveryOpcodeAndFunction) {
  std::mt19937 Generator(1);
  for (uint32_t Opcode = 0; Opcode != 64; ++Opcode)
    for (uint32_t Function = 0; Function != 64; ++Function)
      for (unsigned Fields = 0; Fields != 16; ++Fields) {
        // Which of the four fields between opcode and function are not 0.
        uint32_t Mask = 0;
        for (unsigned Field = 0; Field != 4; ++Field)
          if (Fields >> Field & 1)
            Mask |= 31u << (6 + 5 * Field);
        for (unsigned Try = 0; Try != 4; ++Try)
          check(Opcode << 26 | Function | (uint32_t(Generator()) & Mask));
      }
}

TEST_F(DecoderAgreementTest, RandomWords) {
  std::mt19937 Generator(2);
  for (unsigned Try = 0; Try != 200000; ++Try)
    check(Generator());
}

} // namespace
