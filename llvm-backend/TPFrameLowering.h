//===- TPFrameLowering.h - Stack frames -------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A frame from high to low addresses, with the stack pointer 8-byte aligned:
//
//                    stack arguments
//   CFA, fp (r30) -> return address, frame pointer, other saved registers
//                    locals and spills
//                    variable-sized objects
//   sp (r29)      -> arguments of calls
//
// A function without frame pointer addresses everything from sp. With one, it
// addresses its arguments and locals from fp; if the frame is realigned, the
// locals from sp, or from the base pointer where sp varies.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPFRAMELOWERING_H
#define TP_LLVM_BACKEND_TPFRAMELOWERING_H

#include "llvm/CodeGen/TargetFrameLowering.h"

namespace llvm {

class TPSubtarget;

class TPFrameLowering : public TargetFrameLowering {
  const TPSubtarget &STI;

public:
  explicit TPFrameLowering(const TPSubtarget &STI);

  void emitPrologue(MachineFunction &MF, MachineBasicBlock &MBB) const override;
  void emitEpilogue(MachineFunction &MF, MachineBasicBlock &MBB) const override;
  bool spillCalleeSavedRegisters(MachineBasicBlock &MBB,
                                 MachineBasicBlock::iterator I,
                                 ArrayRef<CalleeSavedInfo> Saved,
                                 const TargetRegisterInfo *TRI) const override;
  bool
  restoreCalleeSavedRegisters(MachineBasicBlock &MBB,
                              MachineBasicBlock::iterator I,
                              MutableArrayRef<CalleeSavedInfo> Saved,
                              const TargetRegisterInfo *TRI) const override;
  StackOffset getFrameIndexReference(const MachineFunction &MF, int FI,
                                     Register &FrameReg) const override;
  void determineCalleeSaves(MachineFunction &MF, BitVector &SavedRegs,
                            RegScavenger *RS) const override;
  bool hasReservedCallFrame(const MachineFunction &MF) const override;
  MachineBasicBlock::iterator
  eliminateCallFramePseudoInstr(MachineFunction &MF, MachineBasicBlock &MBB,
                                MachineBasicBlock::iterator I) const override;
  bool enableShrinkWrapping(const MachineFunction &) const override {
    return true;
  }
  bool enableCFIFixup(const MachineFunction &) const override { return true; }
  void resetCFIToInitialState(MachineBasicBlock &MBB) const override;
  int getInitialCFAOffset(const MachineFunction &) const override { return 0; }
  Register getInitialCFARegister(const MachineFunction &MF) const override;

protected:
  bool hasFPImpl(const MachineFunction &MF) const override;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPFRAMELOWERING_H
