//===- TPSubtarget.h - One kind of TP ---------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPSUBTARGET_H
#define TP_LLVM_BACKEND_TPSUBTARGET_H

#include "llvm-backend/TPFrameLowering.h"
#include "llvm-backend/TPISelLowering.h"
#include "llvm-backend/TPInstrInfo.h"
#include "llvm-backend/TPSelectionDAGInfo.h"
#include "llvm/CodeGen/TargetSubtargetInfo.h"

#define GET_SUBTARGETINFO_HEADER
#include "TPGenSubtargetInfo.inc"

namespace llvm {

/// The features of the processor that a function is compiled for, and the parts
/// of the code generator that depend on them.
class TPSubtarget : public TPGenSubtargetInfo {
  bool HasTrigonometry = false;
  bool HasFMA = false;

  TPInstrInfo InstrInfo;
  TPFrameLowering FrameLowering;
  TPTargetLowering Lowering;
  TPSelectionDAGInfo DAGInfo;

public:
  TPSubtarget(const Triple &TT, StringRef CPU, StringRef FS,
              const TargetMachine &TM);

  /// Whether the chip has sin_s and cos_s.
  bool hasTrigonometry() const { return HasTrigonometry; }

  /// Whether the chip has madd_s.
  bool hasFMA() const { return HasFMA; }

  const TPInstrInfo *getInstrInfo() const override { return &InstrInfo; }
  const TPRegisterInfo *getRegisterInfo() const override {
    return &InstrInfo.getRegisterInfo();
  }
  const TPFrameLowering *getFrameLowering() const override {
    return &FrameLowering;
  }
  const TPTargetLowering *getTargetLowering() const override {
    return &Lowering;
  }
  const SelectionDAGTargetInfo *getSelectionDAGInfo() const override {
    return &DAGInfo;
  }

  void initLibcallLoweringInfo(LibcallLoweringInfo &Info) const override;

  bool enableMachineScheduler() const override { return true; }
  void overrideSchedPolicy(MachineSchedPolicy &Policy,
                           const SchedRegion &Region) const override;
  bool useAA() const override { return true; }
  void adjustSchedDependency(SUnit *Def, int DefOpIdx, SUnit *Use, int UseOpIdx,
                             SDep &Dep,
                             const TargetSchedModel *SchedModel) const override;

  /// Whether \p MI loads from what is not surely in the local store.
  static bool isGlobalLoad(const MachineInstr &MI);

  // Made by TableGen.
  void ParseSubtargetFeatures(StringRef CPU, StringRef TuneCPU, StringRef FS);

private:
  TPSubtarget &initialize(StringRef CPU, StringRef FS);
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPSUBTARGET_H
