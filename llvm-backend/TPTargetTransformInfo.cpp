//===- TPTargetTransformInfo.cpp - Costs for the optimizer ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPTargetTransformInfo.h"
#include "llvm-backend/FloatingPoint/Check/CheckPass.h"
#include "llvm-backend/TPBuiltins.h"

using namespace llvm;

TPTTIImpl::TPTTIImpl(const TPTargetMachine *TM, const Function &F)
    : BaseT(TM, F.getDataLayout()), ST(TM->getSubtargetImpl(F)),
      TLI(ST->getTargetLowering()) {}

bool TPTTIImpl::isLoweredToCall(const Function *F) const {
  return TPBuiltin::getID(*F) == TPBuiltin::ID::None &&
         BaseT::isLoweredToCall(F);
}

InstructionCost TPTTIImpl::getInstructionCost(const User *U,
                                              ArrayRef<const Value *> Operands,
                                              TTI::TargetCostKind Kind) const {
  // Messages to the observer take no time: code with them is worth what it is
  // without.
  if (const auto *Call = dyn_cast<CallInst>(U))
    if (const Function *Callee = Call->getCalledFunction()) {
      TPBuiltin::ID Builtin = TPBuiltin::getID(*Callee);
      if (Builtin == TPBuiltin::ID::prof || Builtin == TPBuiltin::ID::profv)
        return TTI::TCC_Free;
    }
  return BaseT::getInstructionCost(U, Operands, Kind);
}

bool TPTTIImpl::areInlineCompatible(const Function *Caller,
                                    const Function *Callee) const {
  // Whether an operation is checked is decided by the function that it is in.
  return Caller->hasFnAttribute(CheckedFunctionAttribute) ==
             Callee->hasFnAttribute(CheckedFunctionAttribute) &&
         BaseT::areInlineCompatible(Caller, Callee);
}

unsigned TPTTIImpl::getNumberOfRegisters(unsigned ClassID) const {
  // Class 1 is the vectors: there are none.
  return ClassID == 1 ? 0 : 28;
}

TypeSize
TPTTIImpl::getRegisterBitWidth(TargetTransformInfo::RegisterKind Kind) const {
  return TypeSize::getFixed(Kind == TargetTransformInfo::RGK_Scalar ? 32 : 0);
}

/// Instructions that make one word.
static unsigned getWordCost(uint32_t Word) {
  const bool One = isInt<16>(static_cast<int32_t>(Word)) || isUInt<16>(Word) ||
                   (Word & 0xffff) == 0;
  return One ? 1 : 2;
}

InstructionCost TPTTIImpl::getIntImmCost(const APInt &Imm, Type *Ty,
                                         TTI::TargetCostKind) const {
  unsigned Cost = 0;
  const APInt Value = Imm.sextOrTrunc(alignTo(Ty->getScalarSizeInBits(), 32));
  for (unsigned Bit = 0; Bit < Value.getBitWidth(); Bit += 32)
    if (uint32_t Word = Value.extractBitsAsZExtValue(32, Bit))
      Cost += getWordCost(Word);
  return Cost;
}

InstructionCost TPTTIImpl::getIntImmCostInst(unsigned Opcode, unsigned Idx,
                                             const APInt &Imm, Type *Ty,
                                             TTI::TargetCostKind CostKind,
                                             Instruction *) const {
  const bool IsWord = Imm.getBitWidth() <= 32;
  const bool IsSigned16 = IsWord && Imm.isSignedIntN(16);
  const bool IsUnsigned16 = IsWord && Imm.isIntN(16);
  switch (Opcode) {
  case Instruction::Add:
  case Instruction::ICmp:
    if (Idx == 1 && IsSigned16)
      return TTI::TCC_Free;
    break;
  case Instruction::Sub:
    if (Idx == 1 && IsWord && (-Imm).isSignedIntN(16))
      return TTI::TCC_Free;
    break;
  case Instruction::And:
    if (Idx == 1 && (IsUnsigned16 || Imm.isMask()))
      return TTI::TCC_Free;
    break;
  case Instruction::Or:
  case Instruction::Xor:
    if (Idx == 1 && IsUnsigned16)
      return TTI::TCC_Free;
    break;
  case Instruction::Shl:
  case Instruction::LShr:
  case Instruction::AShr:
    if (Idx == 1)
      return TTI::TCC_Free;
    break;
  case Instruction::UDiv:
  case Instruction::SDiv:
  case Instruction::URem:
  case Instruction::SRem:
    // A division by a constant becomes multiplications by others.
    if (Idx == 1)
      return TTI::TCC_Free;
    break;
  case Instruction::Store:
    if (Idx == 0)
      break;
    return TTI::TCC_Free;
  case Instruction::Mul:
  case Instruction::Select:
  case Instruction::Ret:
  case Instruction::PHI:
  case Instruction::Call:
    break;
  default:
    return TTI::TCC_Free;
  }
  if (Imm.isZero())
    return TTI::TCC_Free;
  return getIntImmCost(Imm, Ty, CostKind);
}

InstructionCost TPTTIImpl::getIntImmCostIntrin(Intrinsic::ID, unsigned,
                                               const APInt &, Type *,
                                               TTI::TargetCostKind) const {
  return TTI::TCC_Free;
}

InstructionCost TPTTIImpl::getArithmeticInstrCost(
    unsigned Opcode, Type *Ty, TTI::TargetCostKind CostKind,
    TTI::OperandValueInfo Left, TTI::OperandValueInfo Right,
    ArrayRef<const Value *> Args, const Instruction *CxtI) const {
  if (CostKind != TTI::TCK_CodeSize && Ty->isIntegerTy() &&
      Ty->getIntegerBitWidth() <= 32 && !Right.isConstant()) {
    switch (Opcode) {
    case Instruction::SDiv:
    case Instruction::UDiv:
    case Instruction::SRem:
    case Instruction::URem:
      // The unit's latency, and few of it among many threads.
      return 16;
    default:
      break;
    }
  }
  if (CostKind != TTI::TCK_CodeSize && Ty->isFloatTy() &&
      Opcode == Instruction::FDiv)
    return 16;
  return BaseT::getArithmeticInstrCost(Opcode, Ty, CostKind, Left, Right, Args,
                                       CxtI);
}

static bool hasCall(const Loop &L, const TPTTIImpl &Costs) {
  return any_of(L.blocks(), [&](const BasicBlock *Block) {
    return any_of(*Block, [&](const Instruction &I) {
      const auto *Call = dyn_cast<CallBase>(&I);
      if (!Call || Call->isInlineAsm())
        return false;
      const Function *Callee = Call->getCalledFunction();
      return !Callee || Costs.isLoweredToCall(Callee);
    });
  });
}

void TPTTIImpl::getUnrollingPreferences(Loop *L, ScalarEvolution &,
                                        TTI::UnrollingPreferences &UP,
                                        OptimizationRemarkEmitter *) const {
  // Unrolling lets loads overlap and costs no instruction fetches, but more
  // than the registers hold is spilled. A loop of unknown length stays.
  UP.Threshold = 300;
  UP.PartialThreshold = 100;
  UP.OptSizeThreshold = UP.PartialOptSizeThreshold = 0;
  // Loads do not overlap across calls.
  UP.Partial = !hasCall(*L, *this);
  UP.Runtime = false;
  UP.UpperBound = true;
  UP.DefaultUnrollRuntimeCount = 4;
  UP.MaxCount = 8;
  UP.FullUnrollMaxCount = 64;
  UP.BEInsns = 2;
}

TTI::MemCmpExpansionOptions TPTTIImpl::enableMemCmpExpansion(bool OptSize,
                                                             bool) const {
  TTI::MemCmpExpansionOptions Options;
  Options.MaxNumLoads = TLI->getMaxExpandSizeMemcmp(OptSize);
  // Unaligned words trap, so only bytes are safe without knowing more.
  Options.LoadSizes = {1};
  Options.NumLoadsPerBlock = Options.MaxNumLoads;
  return Options;
}
