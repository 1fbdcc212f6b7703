//===- TPRegisterInfo.cpp - Registers for code generation -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPRegisterInfo.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPFrameLowering.h"
#include "llvm-backend/TPInstrInfo.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/CodeGen/MachineFrameInfo.h"
#include "llvm/CodeGen/MachineInstrBuilder.h"
#include "llvm/CodeGen/MachineRegisterInfo.h"

#define GET_REGINFO_TARGET_DESC
#include "TPGenRegisterInfo.inc"

using namespace llvm;

TPRegisterInfo::TPRegisterInfo() : TPGenRegisterInfo(TP::R31) {}

const MCPhysReg *
TPRegisterInfo::getCalleeSavedRegs(const MachineFunction *) const {
  return CSR_TP_SaveList;
}

const uint32_t *TPRegisterInfo::getCallPreservedMask(const MachineFunction &,
                                                     CallingConv::ID) const {
  return CSR_TP_RegMask;
}

BitVector TPRegisterInfo::getReservedRegs(const MachineFunction &MF) const {
  BitVector Reserved(getNumRegs());
  Reserved.set(TP::R0);
  Reserved.set(TP::R1);
  Reserved.set(TP::R29);
  if (MF.getSubtarget().getFrameLowering()->hasFP(MF))
    Reserved.set(TP::R30);
  if (hasBasePointer(MF))
    Reserved.set(getBaseRegister());
  return Reserved;
}

Register TPRegisterInfo::getFrameRegister(const MachineFunction &MF) const {
  return MF.getSubtarget().getFrameLowering()->hasFP(MF) ? TP::R30 : TP::R29;
}

float TPRegisterInfo::getSpillWeightScaleFactor(
    const TargetRegisterClass *RC) const {
  // Spilling and reloading such a value costs some hundred cycles, any other
  // two. Measured on the path tracer: 2 to 100 make no difference, 1 a quarter.
  return RC == &TP::GPRLoadedRegClass || RC == &TP::FPRLoadedRegClass ? 16 : 1;
}

Register TPRegisterInfo::getBaseRegister() const { return TP::R23; }

bool TPRegisterInfo::hasBasePointer(const MachineFunction &MF) const {
  return MF.getFrameInfo().hasVarSizedObjects() && hasStackRealignment(MF);
}

bool TPRegisterInfo::canRealignStack(const MachineFunction &MF) const {
  if (!TargetRegisterInfo::canRealignStack(MF))
    return false;
  const MachineRegisterInfo &MRI = MF.getRegInfo();
  if (!MRI.canReserveReg(TP::R30))
    return false;
  return !MF.getFrameInfo().hasVarSizedObjects() ||
         MRI.canReserveReg(getBaseRegister());
}

bool TPRegisterInfo::eliminateFrameIndex(MachineBasicBlock::iterator I,
                                         int SPAdj, unsigned FIOperandNum,
                                         RegScavenger *) const {
  MachineInstr &MI = *I;
  MachineFunction &MF = *MI.getMF();
  const TPSubtarget &STI = MF.getSubtarget<TPSubtarget>();
  MachineOperand &Base = MI.getOperand(FIOperandNum);
  MachineOperand &Displacement = MI.getOperand(FIOperandNum + 1);

  Register FrameReg;
  int64_t Offset = STI.getFrameLowering()
                       ->getFrameIndexReference(MF, Base.getIndex(), FrameReg)
                       .getFixed();
  Offset += Displacement.getImm();
  if (FrameReg == TP::R29)
    Offset += SPAdj;

  if (isInt<16>(Offset)) {
    Base.ChangeToRegister(FrameReg, false);
    Displacement.ChangeToImmediate(Offset);
    return false;
  }

  int64_t Low = SignExtend64<16>(Offset);
  MachineBasicBlock &MBB = *MI.getParent();
  const DebugLoc &DL = MI.getDebugLoc();
  const TPInstrInfo &TII = *STI.getInstrInfo();
  auto Flags = static_cast<MachineInstr::MIFlag>(
      MI.getFlags() & (MachineInstr::FrameSetup | MachineInstr::FrameDestroy));
  BuildMI(MBB, I, DL, TII.get(TP::LUI), TP::R1)
      .addImm(((Offset - Low) >> 16) & 0xffff)
      .setMIFlag(Flags);
  BuildMI(MBB, I, DL, TII.get(TP::ADD), TP::R1)
      .addReg(TP::R1, RegState::Kill)
      .addReg(FrameReg)
      .setMIFlag(Flags);
  Base.ChangeToRegister(TP::R1, false, false, true);
  Displacement.ChangeToImmediate(Low);
  return false;
}
