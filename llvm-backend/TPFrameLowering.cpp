//===- TPFrameLowering.cpp - Stack frames ---------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPFrameLowering.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPInstrInfo.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/CodeGen/CFIInstBuilder.h"
#include "llvm/CodeGen/MachineFrameInfo.h"
#include "llvm/CodeGen/MachineInstrBuilder.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

TPFrameLowering::TPFrameLowering(const TPSubtarget &STI)
    : TargetFrameLowering(StackGrowsDown, Align(8), 0, Align(8)), STI(STI) {}

bool TPFrameLowering::hasFPImpl(const MachineFunction &MF) const {
  const MachineFrameInfo &MFI = MF.getFrameInfo();
  return MF.getTarget().Options.DisableFramePointerElim(MF) ||
         MFI.hasVarSizedObjects() || MFI.isFrameAddressTaken() ||
         STI.getRegisterInfo()->hasStackRealignment(MF);
}

bool TPFrameLowering::hasReservedCallFrame(const MachineFunction &MF) const {
  return !MF.getFrameInfo().hasVarSizedObjects();
}

Register TPFrameLowering::getInitialCFARegister(const MachineFunction &) const {
  return TP::R29;
}

void TPFrameLowering::determineCalleeSaves(MachineFunction &MF,
                                           BitVector &SavedRegs,
                                           RegScavenger *RS) const {
  TargetFrameLowering::determineCalleeSaves(MF, SavedRegs, RS);
  // Both belong to the frame record, whose place __builtin_frame_address and
  // __builtin_return_address rely on.
  if (hasFP(MF)) {
    SavedRegs.set(TP::R30);
    SavedRegs.set(TP::R31);
  }
  const TPRegisterInfo &RI = *STI.getRegisterInfo();
  if (RI.hasBasePointer(MF))
    SavedRegs.set(RI.getBaseRegister());
}

void TPFrameLowering::emitPrologue(MachineFunction &MF,
                                   MachineBasicBlock &MBB) const {
  const MachineFrameInfo &MFI = MF.getFrameInfo();
  const TPInstrInfo &TII = *STI.getInstrInfo();
  const TPRegisterInfo &RI = *STI.getRegisterInfo();
  const int64_t StackSize = MFI.getStackSize();
  if (StackSize == 0)
    return;

  // The directives are there with and without debug information, so that the
  // code is the same.
  constexpr auto Flag = MachineInstr::FrameSetup;
  const DebugLoc DL;
  const ArrayRef<CalleeSavedInfo> Saved = MFI.getCalleeSavedInfo();
  MachineBasicBlock::iterator I = MBB.begin();
  CFIInstBuilder CFI(MBB, I, Flag);

  TII.addConstant(MBB, I, DL, TP::R29, TP::R29, -StackSize, Flag);
  CFI.buildDefCFAOffset(StackSize);

  std::advance(I, Saved.size());
  CFI.setInsertPoint(I);
  for (const CalleeSavedInfo &Info : Saved)
    CFI.buildOffset(Info.getReg(), MFI.getObjectOffset(Info.getFrameIdx()));

  if (!hasFP(MF))
    return;
  TII.addConstant(MBB, I, DL, TP::R30, TP::R29, StackSize, Flag);
  CFI.buildDefCFA(TP::R30, 0);

  if (!RI.hasStackRealignment(MF))
    return;
  TII.loadConstant(MBB, I, DL, TP::R1,
                   -static_cast<int64_t>(MFI.getMaxAlign().value()), Flag);
  BuildMI(MBB, I, DL, TII.get(TP::AND), TP::R29)
      .addReg(TP::R29)
      .addReg(TP::R1, RegState::Kill)
      .setMIFlag(Flag);
  if (RI.hasBasePointer(MF))
    TII.addConstant(MBB, I, DL, RI.getBaseRegister(), TP::R29, 0, Flag);
}

void TPFrameLowering::emitEpilogue(MachineFunction &MF,
                                   MachineBasicBlock &MBB) const {
  const MachineFrameInfo &MFI = MF.getFrameInfo();
  const TPInstrInfo &TII = *STI.getInstrInfo();
  const int64_t StackSize = MFI.getStackSize();
  if (StackSize == 0)
    return;

  constexpr auto Flag = MachineInstr::FrameDestroy;
  const ArrayRef<CalleeSavedInfo> Saved = MFI.getCalleeSavedInfo();
  MachineBasicBlock::iterator End = MBB.getFirstTerminator();
  const DebugLoc DL = End != MBB.end() ? End->getDebugLoc() : DebugLoc();
  MachineBasicBlock::iterator Restores = std::prev(End, Saved.size());
  CFIInstBuilder CFI(MBB, Restores, Flag);

  if (hasFP(MF)) {
    if (MFI.hasVarSizedObjects() ||
        STI.getRegisterInfo()->hasStackRealignment(MF))
      TII.addConstant(MBB, Restores, DL, TP::R29, TP::R30, -StackSize, Flag);
    CFI.buildDefCFA(TP::R29, StackSize);
  }

  CFI.setInsertPoint(End);
  for (const CalleeSavedInfo &Info : Saved)
    CFI.buildRestore(Info.getReg());
  TII.addConstant(MBB, End, DL, TP::R29, TP::R29, StackSize, Flag);
  CFI.buildDefCFAOffset(0);
}

// Before a block without the frame that lies behind one with it.
void TPFrameLowering::resetCFIToInitialState(MachineBasicBlock &MBB) const {
  CFIInstBuilder CFI(MBB, MBB.begin(), MachineInstr::NoFlags);
  CFI.buildDefCFA(TP::R29, 0);
  for (const CalleeSavedInfo &Info :
       MBB.getParent()->getFrameInfo().getCalleeSavedInfo())
    CFI.buildRestore(Info.getReg());
}

bool TPFrameLowering::spillCalleeSavedRegisters(
    MachineBasicBlock &MBB, MachineBasicBlock::iterator I,
    ArrayRef<CalleeSavedInfo> Saved, const TargetRegisterInfo *TRI) const {
  for (const CalleeSavedInfo &Info : Saved)
    STI.getInstrInfo()->storeRegToStackSlot(
        MBB, I, Info.getReg(), /*IsKill=*/true, Info.getFrameIdx(),
        TRI->getMinimalPhysRegClass(Info.getReg()), Register(),
        MachineInstr::FrameSetup);
  return true;
}

bool TPFrameLowering::restoreCalleeSavedRegisters(
    MachineBasicBlock &MBB, MachineBasicBlock::iterator I,
    MutableArrayRef<CalleeSavedInfo> Saved,
    const TargetRegisterInfo *TRI) const {
  for (const CalleeSavedInfo &Info : reverse(Saved))
    STI.getInstrInfo()->loadRegFromStackSlot(
        MBB, I, Info.getReg(), Info.getFrameIdx(),
        TRI->getMinimalPhysRegClass(Info.getReg()), Register(), /*SubReg=*/0,
        MachineInstr::FrameDestroy);
  return true;
}

StackOffset TPFrameLowering::getFrameIndexReference(const MachineFunction &MF,
                                                    int FI,
                                                    Register &FrameReg) const {
  const MachineFrameInfo &MFI = MF.getFrameInfo();
  const TPRegisterInfo &RI = *STI.getRegisterInfo();
  const bool Realigned = RI.hasStackRealignment(MF);
  // The distance from the CFA.
  const int64_t Offset = MFI.getObjectOffset(FI);
  const int64_t FromSP = Offset + static_cast<int64_t>(MFI.getStackSize());

  // Saved registers are stored before, and restored after, fp and the
  // realigned sp hold.
  for (const CalleeSavedInfo &Info : MFI.getCalleeSavedInfo())
    if (Info.getFrameIdx() == FI) {
      FrameReg = TP::R29;
      return StackOffset::getFixed(FromSP);
    }

  if (!hasFP(MF)) {
    FrameReg = TP::R29;
    return StackOffset::getFixed(FromSP);
  }
  if (Realigned && !MFI.isFixedObjectIndex(FI)) {
    FrameReg = RI.hasBasePointer(MF) ? RI.getBaseRegister() : TP::R29;
    return StackOffset::getFixed(FromSP);
  }
  FrameReg = TP::R30;
  return StackOffset::getFixed(Offset);
}

MachineBasicBlock::iterator TPFrameLowering::eliminateCallFramePseudoInstr(
    MachineFunction &MF, MachineBasicBlock &MBB,
    MachineBasicBlock::iterator I) const {
  if (!hasReservedCallFrame(MF)) {
    int64_t Amount = alignTo(I->getOperand(0).getImm(), getStackAlign());
    if (Amount != 0) {
      if (I->getOpcode() == TP::ADJCALLSTACKDOWN)
        Amount = -Amount;
      STI.getInstrInfo()->addConstant(MBB, I, I->getDebugLoc(), TP::R29,
                                      TP::R29, Amount, MachineInstr::NoFlags);
    }
  }
  return MBB.erase(I);
}
