//===- TPTargetTransformInfo.h - Costs for the optimizer --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPTARGETTRANSFORMINFO_H
#define TP_LLVM_BACKEND_TPTARGETTRANSFORMINFO_H

#include "llvm-backend/TPTargetMachine.h"
#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/CodeGen/BasicTTIImpl.h"

namespace llvm {

/// Tells the optimizer what things cost on a scalar, in-order processor with a
/// slow memory and an instruction cache that never misses.
class TPTTIImpl final : public BasicTTIImplBase<TPTTIImpl> {
  using BaseT = BasicTTIImplBase<TPTTIImpl>;
  using TTI = TargetTransformInfo;
  friend BaseT;

  const TPSubtarget *ST;
  const TPTargetLowering *TLI;

  const TPSubtarget *getST() const { return ST; }
  const TPTargetLowering *getTLI() const { return TLI; }

public:
  TPTTIImpl(const TPTargetMachine *TM, const Function &F);

  bool isLoweredToCall(const Function *F) const override;
  InstructionCost getInstructionCost(const User *U,
                                     ArrayRef<const Value *> Operands,
                                     TTI::TargetCostKind Kind) const override;
  bool areInlineCompatible(const Function *Caller,
                           const Function *Callee) const override;

  unsigned getNumberOfRegisters(unsigned ClassID) const override;
  TypeSize
  getRegisterBitWidth(TargetTransformInfo::RegisterKind Kind) const override;
  bool enableInterleavedAccessVectorization() const override { return false; }

  InstructionCost getIntImmCost(const APInt &Imm, Type *Ty,
                                TTI::TargetCostKind CostKind) const override;
  InstructionCost getIntImmCostInst(unsigned Opcode, unsigned Idx,
                                    const APInt &Imm, Type *Ty,
                                    TTI::TargetCostKind CostKind,
                                    Instruction *Inst = nullptr) const override;
  InstructionCost
  getIntImmCostIntrin(Intrinsic::ID IID, unsigned Idx, const APInt &Imm,
                      Type *Ty, TTI::TargetCostKind CostKind) const override;

  InstructionCost getArithmeticInstrCost(
      unsigned Opcode, Type *Ty, TTI::TargetCostKind CostKind,
      TTI::OperandValueInfo Left = {TTI::OK_AnyValue, TTI::OP_None},
      TTI::OperandValueInfo Right = {TTI::OK_AnyValue, TTI::OP_None},
      ArrayRef<const Value *> Args = {},
      const Instruction *CxtI = nullptr) const override;

  void getUnrollingPreferences(Loop *L, ScalarEvolution &SE,
                               TTI::UnrollingPreferences &UP,
                               OptimizationRemarkEmitter *ORE) const override;
  bool haveFastSqrt(Type *Ty) const override { return Ty->isFloatTy(); }
  TTI::PopcntSupportKind getPopcntSupport(unsigned) const override {
    return TTI::PSK_Software;
  }
  TTI::MemCmpExpansionOptions
  enableMemCmpExpansion(bool OptSize, bool IsZeroCmp) const override;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPTARGETTRANSFORMINFO_H
