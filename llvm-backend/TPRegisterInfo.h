//===- TPRegisterInfo.h - Registers for code generation ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPREGISTERINFO_H
#define TP_LLVM_BACKEND_TPREGISTERINFO_H

#include "llvm/CodeGen/TargetRegisterInfo.h"

#define GET_REGINFO_HEADER
#include "TPGenRegisterInfo.inc"

namespace llvm {

/// Which registers are reserved and saved, and how a frame index becomes an
/// address.
class TPRegisterInfo : public TPGenRegisterInfo {
public:
  TPRegisterInfo();

  const MCPhysReg *getCalleeSavedRegs(const MachineFunction *MF) const override;
  const uint32_t *getCallPreservedMask(const MachineFunction &MF,
                                       CallingConv::ID) const override;
  BitVector getReservedRegs(const MachineFunction &MF) const override;
  Register getFrameRegister(const MachineFunction &MF) const override;
  bool canRealignStack(const MachineFunction &MF) const override;
  /// Values of one block get registers from its end to its begin: the kernels
  /// then spill less.
  bool reverseLocalAssignment() const override { return true; }
  float getSpillWeightScaleFactor(const TargetRegisterClass *RC) const override;

  /// The register that addresses the locals of a function whose stack is both
  /// realigned and of variable size.
  Register getBaseRegister() const;
  bool hasBasePointer(const MachineFunction &MF) const;

  bool eliminateFrameIndex(MachineBasicBlock::iterator I, int SPAdj,
                           unsigned FIOperandNum,
                           RegScavenger *RS) const override;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPREGISTERINFO_H
