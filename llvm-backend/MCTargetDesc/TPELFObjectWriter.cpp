//===- TPELFObjectWriter.cpp - ELF relocations ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm-backend/MCTargetDesc/TPFixupKinds.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm/ADT/Twine.h"
#include "llvm/MC/MCELFObjectWriter.h"
#include "llvm/MC/MCFixup.h"
#include "llvm/MC/MCObjectWriter.h"

using namespace llvm;

namespace {

class TPELFObjectWriter : public MCELFObjectTargetWriter {
public:
  TPELFObjectWriter()
      : MCELFObjectTargetWriter(/*Is64Bit=*/false, ELF::ELFOSABI_NONE,
                                TPELF::EM_TP, /*HasRelocationAddend=*/true) {}

private:
  unsigned getRelocType(const MCFixup &Fixup, const MCValue &Target,
                        bool IsPCRel) const override;
};

} // namespace

unsigned TPELFObjectWriter::getRelocType(const MCFixup &Fixup,
                                         const MCValue &Target,
                                         bool IsPCRel) const {
  switch (unsigned(Fixup.getKind())) {
  case FK_Data_1:
    if (!IsPCRel)
      return TPELF::R_TP_8;
    break;
  case FK_Data_2:
    if (!IsPCRel)
      return TPELF::R_TP_16;
    break;
  case FK_Data_4:
    return IsPCRel ? TPELF::R_TP_PC32 : TPELF::R_TP_32;
  case TP::fixup_tp_hi16:
    if (!IsPCRel)
      return TPELF::R_TP_HI16;
    break;
  case TP::fixup_tp_lo16:
    if (!IsPCRel)
      return TPELF::R_TP_LO16;
    break;
  case TP::fixup_tp_simm16:
  case TP::fixup_tp_uimm16:
    reportError(Fixup.getLoc(), "the immediate is not a constant; write "
                                "%hi(...) or %lo(...) for half an address");
    return TPELF::R_TP_NONE;
  case TP::fixup_tp_pc16:
    return TPELF::R_TP_PC16;
  case TP::fixup_tp_pc26:
    return TPELF::R_TP_PC26;
  }
  reportError(Fixup.getLoc(), "the TP has no relocation for this expression");
  return TPELF::R_TP_NONE;
}

std::unique_ptr<MCObjectTargetWriter> llvm::createTPELFObjectWriter() {
  return std::make_unique<TPELFObjectWriter>();
}
