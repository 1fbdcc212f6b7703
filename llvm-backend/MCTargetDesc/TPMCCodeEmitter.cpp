//===- TPMCCodeEmitter.cpp - Instructions as words ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPFixupKinds.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm/MC/MCCodeEmitter.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/MC/MCInst.h"
#include "llvm/MC/MCInstrInfo.h"
#include "llvm/MC/MCRegisterInfo.h"
#include "llvm/MC/MCSubtargetInfo.h"
#include "llvm/Support/Casting.h"
#include "llvm/Support/EndianStream.h"

using namespace llvm;

namespace {

class TPMCCodeEmitter : public MCCodeEmitter {
public:
  explicit TPMCCodeEmitter(MCContext &Ctx) : Ctx(Ctx) {}

  void encodeInstruction(const MCInst &MI, SmallVectorImpl<char> &CB,
                         SmallVectorImpl<MCFixup> &Fixups,
                         const MCSubtargetInfo &STI) const override {
    support::endian::write<uint32_t>(CB, getBinaryCodeForInstr(MI, Fixups, STI),
                                     endianness::little);
  }

private:
  // Made by TableGen; calls the encoders below for the operands.
  uint64_t getBinaryCodeForInstr(const MCInst &MI,
                                 SmallVectorImpl<MCFixup> &Fixups,
                                 const MCSubtargetInfo &STI) const;

  unsigned getMachineOpValue(const MCInst &MI, const MCOperand &Op,
                             SmallVectorImpl<MCFixup> &Fixups,
                             const MCSubtargetInfo &STI) const {
    return Ctx.getRegisterInfo()->getEncodingValue(Op.getReg());
  }
  /// The 16-bit immediate `OpNo`; `ConstantFixup` is its fixup where it is an
  /// expression without %hi or %lo.
  unsigned getImmediateValue(const MCInst &MI, unsigned OpNo,
                             SmallVectorImpl<MCFixup> &Fixups,
                             TP::Fixups ConstantFixup) const;
  unsigned getSImmValue(const MCInst &MI, unsigned OpNo,
                        SmallVectorImpl<MCFixup> &Fixups,
                        const MCSubtargetInfo &STI) const {
    return getImmediateValue(MI, OpNo, Fixups, TP::fixup_tp_simm16);
  }
  unsigned getUImmValue(const MCInst &MI, unsigned OpNo,
                        SmallVectorImpl<MCFixup> &Fixups,
                        const MCSubtargetInfo &STI) const {
    return getImmediateValue(MI, OpNo, Fixups, TP::fixup_tp_uimm16);
  }
  template <unsigned Width>
  unsigned getTargetValue(const MCInst &MI, unsigned OpNo,
                          SmallVectorImpl<MCFixup> &Fixups,
                          const MCSubtargetInfo &STI) const;

  MCContext &Ctx;
};

} // namespace

unsigned TPMCCodeEmitter::getImmediateValue(const MCInst &MI, unsigned OpNo,
                                            SmallVectorImpl<MCFixup> &Fixups,
                                            TP::Fixups ConstantFixup) const {
  const MCOperand &Op = MI.getOperand(OpNo);
  if (Op.isImm())
    return static_cast<unsigned>(Op.getImm());
  const MCExpr *Expr = Op.getExpr();
  MCFixupKind Kind = ConstantFixup;
  if (const auto *Half = dyn_cast<MCSpecifierExpr>(Expr))
    Kind = Half->getSpecifier() == TPII::MO_HI ? TP::fixup_tp_hi16
                                               : TP::fixup_tp_lo16;
  Fixups.push_back(MCFixup::create(0, Expr, Kind));
  return 0;
}

template <unsigned Width>
unsigned TPMCCodeEmitter::getTargetValue(const MCInst &MI, unsigned OpNo,
                                         SmallVectorImpl<MCFixup> &Fixups,
                                         const MCSubtargetInfo &STI) const {
  static_assert(Width == 16 || Width == 26);
  const MCOperand &Op = MI.getOperand(OpNo);
  if (Op.isImm())
    return static_cast<unsigned>(Op.getImm() >> 2);
  MCFixupKind Kind = Width == 16 ? TP::fixup_tp_pc16 : TP::fixup_tp_pc26;
  Fixups.push_back(MCFixup::create(0, Op.getExpr(), Kind, /*PCRel=*/true));
  return 0;
}

MCCodeEmitter *llvm::createTPMCCodeEmitter(const MCInstrInfo &MCII,
                                           MCContext &Ctx) {
  return new TPMCCodeEmitter(Ctx);
}

#include "TPGenMCCodeEmitter.inc"
