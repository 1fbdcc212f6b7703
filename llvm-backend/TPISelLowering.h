//===- TPISelLowering.h - How the TP sees the selection DAG -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPISELLOWERING_H
#define TP_LLVM_BACKEND_TPISELLOWERING_H

#include "llvm-backend/TPProfilePort.h"
#include "llvm-backend/TPSelectionDAGInfo.h"
#include "llvm/CodeGen/TargetLowering.h"

namespace llvm {

class TPSubtarget;

/// Which operations the TP has, and what becomes of the others.
class TPTargetLowering : public TargetLowering {
  const TPSubtarget &STI;
  TPProfilePort ProfilePort;

public:
  TPTargetLowering(const TargetMachine &TM, const TPSubtarget &STI);

  /// What the memory operands of profile instructions name.
  const TPProfilePort *getProfilePort() const { return &ProfilePort; }

  SDValue LowerOperation(SDValue Op, SelectionDAG &DAG) const override;

  // Calls: TPCallLowering.cpp.
  SDValue LowerFormalArguments(SDValue Chain, CallingConv::ID CallConv,
                               bool IsVarArg,
                               const SmallVectorImpl<ISD::InputArg> &Ins,
                               const SDLoc &DL, SelectionDAG &DAG,
                               SmallVectorImpl<SDValue> &InVals) const override;
  SDValue LowerCall(CallLoweringInfo &CLI,
                    SmallVectorImpl<SDValue> &InVals) const override;
  bool CanLowerReturn(CallingConv::ID CallConv, MachineFunction &MF,
                      bool IsVarArg,
                      const SmallVectorImpl<ISD::OutputArg> &Outs,
                      LLVMContext &Context, const Type *RetTy) const override;
  SDValue LowerReturn(SDValue Chain, CallingConv::ID CallConv, bool IsVarArg,
                      const SmallVectorImpl<ISD::OutputArg> &Outs,
                      const SmallVectorImpl<SDValue> &OutVals, const SDLoc &DL,
                      SelectionDAG &DAG) const override;
  bool mayBeEmittedAsTailCall(const CallInst *CI) const override;
  MVT getRegisterTypeForCallingConv(LLVMContext &Context,
                                    CallingConv::ID CallConv,
                                    EVT VT) const override;
  unsigned getNumRegistersForCallingConv(LLVMContext &Context,
                                         CallingConv::ID CallConv,
                                         EVT VT) const override;

  // Inline assembly: TPInlineAsm.cpp.
  ConstraintType getConstraintType(StringRef Constraint) const override;
  std::pair<unsigned, const TargetRegisterClass *>
  getRegForInlineAsmConstraint(const TargetRegisterInfo *TRI,
                               StringRef Constraint, MVT VT) const override;
  void LowerAsmOperandForConstraint(SDValue Op, StringRef Constraint,
                                    std::vector<SDValue> &Ops,
                                    SelectionDAG &DAG) const override;
  Register getRegisterByName(const char *RegName, LLT Ty,
                             const MachineFunction &MF) const override;

  EVT getSetCCResultType(const DataLayout &, LLVMContext &,
                         EVT VT) const override;
  bool isFPImmLegal(const APFloat &Imm, EVT VT,
                    bool ForCodeSize) const override;
  bool isOffsetFoldingLegal(const GlobalAddressSDNode *) const override {
    return true;
  }
  bool isLegalAddressingMode(const DataLayout &DL, const AddrMode &AM, Type *Ty,
                             unsigned AddrSpace,
                             Instruction *I = nullptr) const override;
  bool isLegalICmpImmediate(int64_t Imm) const override {
    return isInt<16>(Imm);
  }
  bool isLegalAddImmediate(int64_t Imm) const override {
    return isInt<16>(Imm);
  }
  bool isTruncateFree(Type *From, Type *To) const override;
  bool isTruncateFree(EVT From, EVT To) const override;
  bool isZExtFree(SDValue Val, EVT To) const override;
  bool convertSelectOfConstantsToMath(EVT VT) const override {
    return VT == MVT::i32;
  }
  bool convertSetCCLogicToBitwiseLogic(EVT VT) const override {
    return VT.isScalarInteger();
  }
  bool isSuitableForJumpTable(const SwitchInst *Switch, uint64_t NumCases,
                              uint64_t Range, ProfileSummaryInfo *PSI,
                              BlockFrequencyInfo *BFI) const override;
  bool isCheapToSpeculateCtlz(Type *) const override { return true; }
  bool isCheapToSpeculateCttz(Type *) const override { return true; }
  bool isCtlzFast() const override { return true; }
  bool isFMAFasterThanFMulAndFAdd(const MachineFunction &,
                                  EVT VT) const override;
  bool shouldConvertConstantLoadToIntImm(const APInt &Imm,
                                         Type *Ty) const override {
    return Ty->isIntegerTy() && Imm.getBitWidth() <= 32;
  }
  MVT getScalarShiftAmountTy(const DataLayout &, EVT) const override {
    return MVT::i32;
  }

  Register getExceptionPointerRegister(const Constant *) const override;
  Register getExceptionSelectorRegister(const Constant *) const override;

  bool shouldInsertFencesForAtomic(const Instruction *I) const override;
  Instruction *emitTrailingFence(IRBuilderBase &Builder, Instruction *Inst,
                                 AtomicOrdering Ord) const override;
  AtomicExpansionKind
  shouldExpandAtomicRMWInIR(AtomicRMWInst *RMW) const override;
  using TargetLowering::getTargetMMOFlags;
  MachineMemOperand::Flags
  getTargetMMOFlags(const Instruction &I) const override;

private:
  SDValue lowerAddress(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerIntrinsic(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerAtomicFence(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerVAStart(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerFrameAddress(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerReturnAddress(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerCopySign(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerRoundToBFloat(SDValue Op, SelectionDAG &DAG) const;
  SDValue lowerSaturatingConversion(SDValue Op, SelectionDAG &DAG) const;

  void configureIntegers();
  void configureFloats();
  void configureMemory();
  void configureControl();

  bool isEligibleForTailCall(const CallLoweringInfo &CLI,
                             unsigned StackBytes) const;

  /// Turns a call of a TP builtin into its node: TPBuiltinLowering.cpp. Returns
  /// the new chain, or nothing if the call is an ordinary one.
  SDValue lowerBuiltinCall(CallLoweringInfo &CLI,
                           SmallVectorImpl<SDValue> &InVals) const;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPISELLOWERING_H
