//===- TPDisassembler.cpp - Words as instructions -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TargetInfo/TPTargetInfo.h"
#include "llvm/MC/MCDecoder.h"
#include "llvm/MC/MCDecoderOps.h"
#include "llvm/MC/MCDisassembler/MCDisassembler.h"
#include "llvm/MC/MCInst.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Support/Compiler.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;
using namespace llvm::MCD;

#define DEBUG_TYPE "tp-disassembler"

using DecodeStatus = MCDisassembler::DecodeStatus;

static_assert(TP::R31 == TP::R0 + 31 && TP::F31 == TP::F0 + 31,
              "registers are enumerated in the order of their numbers");

static DecodeStatus DecodeGPRRegisterClass(MCInst &Inst, uint64_t Number,
                                           uint64_t Address,
                                           const MCDisassembler *Decoder) {
  Inst.addOperand(MCOperand::createReg(TP::R0 + Number));
  return MCDisassembler::Success;
}

static DecodeStatus DecodeFPRRegisterClass(MCInst &Inst, uint64_t Number,
                                           uint64_t Address,
                                           const MCDisassembler *Decoder) {
  Inst.addOperand(MCOperand::createReg(TP::F0 + Number));
  return MCDisassembler::Success;
}

template <unsigned Width>
static DecodeStatus decodeSImm(MCInst &Inst, uint64_t Field, uint64_t Address,
                               const MCDisassembler *Decoder) {
  Inst.addOperand(MCOperand::createImm(SignExtend64<Width>(Field)));
  return MCDisassembler::Success;
}

template <unsigned Width>
static DecodeStatus decodeUImm(MCInst &Inst, uint64_t Field, uint64_t Address,
                               const MCDisassembler *Decoder) {
  Inst.addOperand(MCOperand::createImm(Field));
  return MCDisassembler::Success;
}

template <unsigned Width>
static DecodeStatus decodeTarget(MCInst &Inst, uint64_t Field, uint64_t Address,
                                 const MCDisassembler *Decoder) {
  Inst.addOperand(MCOperand::createImm(SignExtend64<Width>(Field) * 4));
  return MCDisassembler::Success;
}

static DecodeStatus decodeSpecialRegister(MCInst &Inst, uint64_t Field,
                                          uint64_t Address,
                                          const MCDisassembler *Decoder) {
  if (!TPSpecialRegister::lookupByEncoding(Field))
    return MCDisassembler::Fail;
  Inst.addOperand(MCOperand::createImm(Field));
  return MCDisassembler::Success;
}

#include "TPGenDisassemblerTables.inc"

namespace {
template <> [[maybe_unused]] constexpr uint32_t InsnBitWidth<uint32_t> = 32;

class TPDisassembler : public MCDisassembler {
public:
  using MCDisassembler::MCDisassembler;

  DecodeStatus getInstruction(MCInst &Instr, uint64_t &Size,
                              ArrayRef<uint8_t> Bytes, uint64_t Address,
                              raw_ostream &CStream) const override;
};
} // namespace

/// `ext` and `ins` name a bit field by its lowest and highest bit, which are
/// their last operands; the reverse order is no instruction.
static bool hasReversedBitField(const MCInst &Instr) {
  if (Instr.getOpcode() != TP::EXT && Instr.getOpcode() != TP::INS)
    return false;
  unsigned NumOperands = Instr.getNumOperands();
  return Instr.getOperand(NumOperands - 2).getImm() >
         Instr.getOperand(NumOperands - 1).getImm();
}

DecodeStatus TPDisassembler::getInstruction(MCInst &Instr, uint64_t &Size,
                                            ArrayRef<uint8_t> Bytes,
                                            uint64_t Address,
                                            raw_ostream &CStream) const {
  Size = 4;
  if (Bytes.size() < Size) {
    Size = Bytes.size();
    return Fail;
  }
  uint32_t Word = support::endian::read32le(Bytes.data());
  DecodeStatus Status =
      decodeInstruction(DecoderTableTP32, Instr, Word, Address, this, STI);
  return Status == Success && hasReversedBitField(Instr) ? Fail : Status;
}

static MCDisassembler *createTPDisassembler(const Target &T,
                                            const MCSubtargetInfo &STI,
                                            MCContext &Ctx) {
  return new TPDisassembler(STI, Ctx);
}

extern "C" LLVM_EXTERNAL_VISIBILITY void LLVMInitializeTPDisassembler() {
  TargetRegistry::RegisterMCDisassembler(getTheTPTarget(),
                                         createTPDisassembler);
}
