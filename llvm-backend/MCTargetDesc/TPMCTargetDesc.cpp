//===- TPMCTargetDesc.cpp - The TP's machine code layer -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/MCTargetDesc/TPInstPrinter.h"
#include "llvm-backend/MCTargetDesc/TPMCAsmInfo.h"
#include "llvm-backend/TargetInfo/TPTargetInfo.h"
#include "llvm/MC/MCDwarf.h"
#include "llvm/MC/MCInst.h"
#include "llvm/MC/MCInstrAnalysis.h"
#include "llvm/MC/MCInstrInfo.h"
#include "llvm/MC/MCSubtargetInfo.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Support/Compiler.h"

using namespace llvm;

#define GET_INSTRINFO_MC_DESC
#define ENABLE_INSTR_PREDICATE_VERIFIER
#include "TPGenInstrInfo.inc"

#define GET_SUBTARGETINFO_MC_DESC
#include "TPGenSubtargetInfo.inc"

#define GET_REGINFO_MC_DESC
#include "TPGenRegisterInfo.inc"

namespace {

class TPMCInstrAnalysis : public MCInstrAnalysis {
public:
  using MCInstrAnalysis::MCInstrAnalysis;

  bool evaluateBranch(const MCInst &Inst, uint64_t Addr, uint64_t Size,
                      uint64_t &Target) const override {
    const MCInstrDesc &Desc = Info->get(Inst.getOpcode());
    for (auto [Op, OpInfo] : zip(Inst, Desc.operands())) {
      if (OpInfo.OperandType != MCOI::OPERAND_PCREL || !Op.isImm())
        continue;
      Target = static_cast<uint32_t>(Addr + Op.getImm());
      return true;
    }
    return false;
  }
};

} // namespace

static MCAsmInfo *createTPMCAsmInfo(const MCRegisterInfo &MRI, const Triple &TT,
                                    const MCTargetOptions &Options) {
  MCAsmInfo *MAI = new TPMCAsmInfo();
  unsigned StackPointer = MRI.getDwarfRegNum(TP::R29, /*isEH=*/true);
  MAI->addInitialFrameState(
      MCCFIInstruction::cfiDefCfa(nullptr, StackPointer, 0));
  return MAI;
}

static MCInstrInfo *createTPMCInstrInfo() {
  auto *MII = new MCInstrInfo();
  InitTPMCInstrInfo(MII);
  return MII;
}

static MCRegisterInfo *createTPMCRegisterInfo(const Triple &TT) {
  auto *MRI = new MCRegisterInfo();
  InitTPMCRegisterInfo(MRI, /*RA=*/TP::R31);
  return MRI;
}

static MCSubtargetInfo *createTPMCSubtargetInfo(const Triple &TT, StringRef CPU,
                                                StringRef FS) {
  if (CPU.empty())
    CPU = "generic";
  return createTPMCSubtargetInfoImpl(TT, CPU, /*TuneCPU=*/CPU, FS);
}

static MCInstPrinter *createTPMCInstPrinter(const Triple &TT,
                                            unsigned SyntaxVariant,
                                            const MCAsmInfo &MAI,
                                            const MCInstrInfo &MII,
                                            const MCRegisterInfo &MRI) {
  return new TPInstPrinter(MAI, MII, MRI);
}

static MCInstrAnalysis *createTPMCInstrAnalysis(const MCInstrInfo *Info) {
  return new TPMCInstrAnalysis(Info);
}

extern "C" LLVM_EXTERNAL_VISIBILITY void LLVMInitializeTPTargetMC() {
  Target &T = getTheTPTarget();
  TargetRegistry::RegisterMCAsmInfo(T, createTPMCAsmInfo);
  TargetRegistry::RegisterMCInstrInfo(T, createTPMCInstrInfo);
  TargetRegistry::RegisterMCRegInfo(T, createTPMCRegisterInfo);
  TargetRegistry::RegisterMCSubtargetInfo(T, createTPMCSubtargetInfo);
  TargetRegistry::RegisterMCInstPrinter(T, createTPMCInstPrinter);
  TargetRegistry::RegisterMCInstrAnalysis(T, createTPMCInstrAnalysis);
  TargetRegistry::RegisterMCCodeEmitter(T, createTPMCCodeEmitter);
  TargetRegistry::RegisterMCAsmBackend(T, createTPAsmBackend);
}
