//===- TPInstrInfo.cpp - Instructions for code generation -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPInstrInfo.h"
#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/CodeGen/MachineFrameInfo.h"
#include "llvm/CodeGen/MachineInstrBuilder.h"
#include "llvm/CodeGen/MachineMemOperand.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/MC/MCAsmInfo.h"
#include "llvm/Support/ErrorHandling.h"
#include "llvm/Target/TargetMachine.h"

#define GET_INSTRINFO_CTOR_DTOR
#include "TPGenInstrInfo.inc"

using namespace llvm;

TPInstrInfo::TPInstrInfo(const TPSubtarget &STI)
    : TPGenInstrInfo(STI, RI, TP::ADJCALLSTACKDOWN, TP::ADJCALLSTACKUP) {}

//===----------------------------------------------------------------------===//
// Constants, copies and spills
//===----------------------------------------------------------------------===//

void TPInstrInfo::loadConstant(MachineBasicBlock &MBB,
                               MachineBasicBlock::iterator I,
                               const DebugLoc &DL, Register Dst, int64_t Value,
                               MachineInstr::MIFlag Flag) const {
  if (isInt<16>(Value)) {
    BuildMI(MBB, I, DL, get(TP::ADDI), Dst)
        .addReg(TP::R0)
        .addImm(Value)
        .setMIFlag(Flag);
    return;
  }
  BuildMI(MBB, I, DL, get(TP::LUI), Dst)
      .addImm((Value >> 16) & 0xffff)
      .setMIFlag(Flag);
  if (Value & 0xffff)
    BuildMI(MBB, I, DL, get(TP::ORI), Dst)
        .addReg(Dst, RegState::Kill)
        .addImm(Value & 0xffff)
        .setMIFlag(Flag);
}

void TPInstrInfo::addConstant(MachineBasicBlock &MBB,
                              MachineBasicBlock::iterator I, const DebugLoc &DL,
                              Register Dst, Register Src, int64_t Amount,
                              MachineInstr::MIFlag Flag) const {
  if (isInt<16>(Amount)) {
    BuildMI(MBB, I, DL, get(TP::ADDI), Dst)
        .addReg(Src)
        .addImm(Amount)
        .setMIFlag(Flag);
    return;
  }
  loadConstant(MBB, I, DL, TP::R1, Amount, Flag);
  BuildMI(MBB, I, DL, get(TP::ADD), Dst)
      .addReg(Src)
      .addReg(TP::R1, RegState::Kill)
      .setMIFlag(Flag);
}

void TPInstrInfo::copyPhysReg(MachineBasicBlock &MBB,
                              MachineBasicBlock::iterator I, const DebugLoc &DL,
                              Register DestReg, Register SrcReg, bool KillSrc,
                              bool, bool) const {
  bool FromFloat = TP::FPRRegClass.contains(SrcReg);
  bool ToFloat = TP::FPRRegClass.contains(DestReg);
  unsigned Opcode = FromFloat ? (ToFloat ? TP::MOV_S : TP::MFC1)
                              : (ToFloat ? TP::MTC1 : TP::ADDI);
  MachineInstrBuilder Copy = BuildMI(MBB, I, DL, get(Opcode), DestReg)
                                 .addReg(SrcReg, getKillRegState(KillSrc));
  if (Opcode == TP::ADDI)
    Copy.addImm(0);
}

std::optional<DestSourcePair>
TPInstrInfo::isCopyInstrImpl(const MachineInstr &MI) const {
  // Before register allocation a move is a COPY; generic code expects more of
  // it (no undefined source, for one) than an addi promises.
  bool IsMove = MI.getOpcode() == TP::MOV_S ||
                (MI.getOpcode() == TP::ADDI && MI.getOperand(1).isReg() &&
                 MI.getOperand(1).getReg() != TP::R0 &&
                 MI.getOperand(2).isImm() && MI.getOperand(2).getImm() == 0);
  if (IsMove && MI.getOperand(0).getReg().isPhysical() &&
      MI.getOperand(1).getReg().isPhysical() && !MI.getOperand(1).isUndef())
    return DestSourcePair{MI.getOperand(0), MI.getOperand(1)};
  return std::nullopt;
}

bool TPInstrInfo::isReMaterializableImpl(const MachineInstr &MI) const {
  switch (MI.getOpcode()) {
  case TP::ADDI:
    if (MI.getOperand(1).isFI())
      return true;
    [[fallthrough]];
  case TP::ORI:
  case TP::MTC1:
    return MI.getOperand(1).isReg() && MI.getOperand(1).getReg() == TP::R0;
  default:
    return TargetInstrInfo::isReMaterializableImpl(MI);
  }
}

bool TPInstrInfo::isAsCheapAsAMove(const MachineInstr &MI) const {
  switch (MI.getOpcode()) {
  case TP::ADDI:
  case TP::ORI:
  case TP::MTC1:
    // Constants and addresses of locals; the others compute something that is
    // worth keeping.
    return isReMaterializableImpl(MI);
  default:
    return TargetInstrInfo::isAsCheapAsAMove(MI);
  }
}

static MachineMemOperand *getSpillOperand(MachineFunction &MF, int FrameIndex,
                                          MachineMemOperand::Flags Flags) {
  return MF.getMachineMemOperand(
      MachinePointerInfo::getFixedStack(MF, FrameIndex), Flags, 4, Align(4));
}

void TPInstrInfo::storeRegToStackSlot(MachineBasicBlock &MBB,
                                      MachineBasicBlock::iterator I,
                                      Register SrcReg, bool IsKill,
                                      int FrameIndex,
                                      const TargetRegisterClass *RC, Register,
                                      MachineInstr::MIFlag Flags) const {
  unsigned Opcode = TP::FPRRegClass.hasSubClassEq(RC) ? TP::SWC1 : TP::SW;
  // No place of the source: a debugger would stop there again.
  BuildMI(MBB, I, DebugLoc(), get(Opcode))
      .addReg(SrcReg, getKillRegState(IsKill))
      .addFrameIndex(FrameIndex)
      .addImm(0)
      .addMemOperand(getSpillOperand(*MBB.getParent(), FrameIndex,
                                     MachineMemOperand::MOStore))
      .setMIFlag(Flags);
}

void TPInstrInfo::loadRegFromStackSlot(MachineBasicBlock &MBB,
                                       MachineBasicBlock::iterator I,
                                       Register DestReg, int FrameIndex,
                                       const TargetRegisterClass *RC, Register,
                                       unsigned,
                                       MachineInstr::MIFlag Flags) const {
  unsigned Opcode = TP::FPRRegClass.hasSubClassEq(RC) ? TP::LWC1 : TP::LW;
  const DebugLoc DL = MBB.findDebugLoc(I);
  BuildMI(MBB, I, DL, get(Opcode), DestReg)
      .addFrameIndex(FrameIndex)
      .addImm(0)
      .addMemOperand(getSpillOperand(*MBB.getParent(), FrameIndex,
                                     MachineMemOperand::MOLoad))
      .setMIFlag(Flags);
}

static Register getStackSlotRegister(const MachineInstr &MI, int &FrameIndex) {
  if (!MI.getOperand(1).isFI() || !MI.getOperand(2).isImm() ||
      MI.getOperand(2).getImm() != 0)
    return Register();
  FrameIndex = MI.getOperand(1).getIndex();
  return MI.getOperand(0).getReg();
}

Register TPInstrInfo::isLoadFromStackSlot(const MachineInstr &MI,
                                          int &FrameIndex) const {
  if (MI.getOpcode() != TP::LW && MI.getOpcode() != TP::LWC1)
    return Register();
  return getStackSlotRegister(MI, FrameIndex);
}

Register TPInstrInfo::isStoreToStackSlot(const MachineInstr &MI,
                                         int &FrameIndex) const {
  if (MI.getOpcode() != TP::SW && MI.getOpcode() != TP::SWC1)
    return Register();
  return getStackSlotRegister(MI, FrameIndex);
}

// Behind frame lowering only the memory operand knows the slot.
static Register
getLoweredSlotRegister(const MachineInstr &MI,
                       ArrayRef<const MachineMemOperand *> Accesses,
                       int &FrameIndex) {
  if (Accesses.empty())
    return Register();
  FrameIndex =
      cast<FixedStackPseudoSourceValue>(Accesses.front()->getPseudoValue())
          ->getFrameIndex();
  return MI.getOperand(0).getReg();
}

Register TPInstrInfo::isLoadFromStackSlotPostFE(const MachineInstr &MI,
                                                int &FrameIndex) const {
  SmallVector<const MachineMemOperand *, 1> Accesses;
  if ((MI.getOpcode() != TP::LW && MI.getOpcode() != TP::LWC1) ||
      !hasLoadFromStackSlot(MI, Accesses))
    return Register();
  return getLoweredSlotRegister(MI, Accesses, FrameIndex);
}

Register TPInstrInfo::isStoreToStackSlotPostFE(const MachineInstr &MI,
                                               int &FrameIndex) const {
  SmallVector<const MachineMemOperand *, 1> Accesses;
  if ((MI.getOpcode() != TP::SW && MI.getOpcode() != TP::SWC1) ||
      !hasStoreToStackSlot(MI, Accesses))
    return Register();
  return getLoweredSlotRegister(MI, Accesses, FrameIndex);
}

//===----------------------------------------------------------------------===//
// What debuggers are told
//===----------------------------------------------------------------------===//

std::optional<RegImmPair> TPInstrInfo::isAddImmediate(const MachineInstr &MI,
                                                      Register Reg) const {
  if (MI.getOpcode() != TP::ADDI || MI.getOperand(0).getReg() != Reg ||
      !MI.getOperand(1).isReg() || !MI.getOperand(2).isImm())
    return std::nullopt;
  return RegImmPair{MI.getOperand(1).getReg(), MI.getOperand(2).getImm()};
}

// The bits that \p MI puts into its register, if they are a constant.
static std::optional<uint32_t> getLoadedConstant(const MachineInstr &MI) {
  switch (MI.getOpcode()) {
  case TP::ADDI:
  case TP::ORI:
    if (MI.getOperand(1).isReg() && MI.getOperand(1).getReg() == TP::R0 &&
        MI.getOperand(2).isImm())
      return MI.getOperand(2).getImm();
    return std::nullopt;
  case TP::LUI:
    if (MI.getOperand(1).isImm())
      return MI.getOperand(1).getImm() << 16;
    return std::nullopt;
  case TP::MTC1:
    if (MI.getOperand(1).getReg() == TP::R0)
      return 0;
    return std::nullopt;
  default:
    return std::nullopt;
  }
}

std::optional<ParamLoadedValue>
TPInstrInfo::describeLoadedValue(const MachineInstr &MI, Register Reg) const {
  if (std::optional<uint32_t> Value = getLoadedConstant(MI);
      Value && MI.getOperand(0).getReg() == Reg)
    return ParamLoadedValue(
        MachineOperand::CreateImm(*Value),
        DIExpression::get(MI.getMF()->getFunction().getContext(), {}));
  return TPGenInstrInfo::describeLoadedValue(MI, Reg);
}

//===----------------------------------------------------------------------===//
// Branches. A condition is {opcode, first register, second register}.
//===----------------------------------------------------------------------===//

MachineBasicBlock *
TPInstrInfo::getBranchDestBlock(const MachineInstr &MI) const {
  return MI.getOperand(MI.getNumExplicitOperands() - 1).getMBB();
}

static void parseConditionalBranch(const MachineInstr &MI,
                                   SmallVectorImpl<MachineOperand> &Cond) {
  Cond.push_back(MachineOperand::CreateImm(MI.getOpcode()));
  Cond.push_back(MI.getOperand(0));
  Cond.push_back(MI.getOperand(1));
}

bool TPInstrInfo::analyzeBranch(MachineBasicBlock &MBB, MachineBasicBlock *&TBB,
                                MachineBasicBlock *&FBB,
                                SmallVectorImpl<MachineOperand> &Cond,
                                bool AllowModify) const {
  TBB = FBB = nullptr;
  Cond.clear();
  SmallVector<MachineInstr *, 4> Terminators; // The last one first.
  for (MachineInstr &MI : reverse(MBB)) {
    if (MI.isDebugInstr())
      continue;
    if (!isUnpredicatedTerminator(MI))
      break;
    if (MI.isUnconditionalBranch() && AllowModify) {
      // What follows an unconditional branch is never reached.
      for (MachineInstr *Dead : Terminators)
        Dead->eraseFromParent();
      Terminators.clear();
    }
    Terminators.push_back(&MI);
  }
  if (Terminators.empty())
    return false;
  if (Terminators.size() > 2)
    return true;

  MachineInstr *Last = Terminators.front();
  MachineInstr *First = Terminators.back();
  if (Last->isConditionalBranch() && First == Last) {
    TBB = getBranchDestBlock(*Last);
    parseConditionalBranch(*Last, Cond);
    return false;
  }
  if (!Last->isUnconditionalBranch() || Last->getOpcode() != TP::J)
    return true;
  if (First == Last) {
    TBB = getBranchDestBlock(*Last);
    return false;
  }
  if (!First->isConditionalBranch())
    return true;
  TBB = getBranchDestBlock(*First);
  FBB = getBranchDestBlock(*Last);
  parseConditionalBranch(*First, Cond);
  return false;
}

unsigned TPInstrInfo::removeBranch(MachineBasicBlock &MBB,
                                   int *BytesRemoved) const {
  unsigned Count = 0;
  MachineBasicBlock::iterator I = MBB.getLastNonDebugInstr();
  while (I != MBB.end() &&
         (I->isConditionalBranch() || I->getOpcode() == TP::J)) {
    I->eraseFromParent();
    ++Count;
    I = MBB.getLastNonDebugInstr();
  }
  if (BytesRemoved)
    *BytesRemoved = 4 * Count;
  return Count;
}

unsigned TPInstrInfo::insertBranch(MachineBasicBlock &MBB,
                                   MachineBasicBlock *TBB,
                                   MachineBasicBlock *FBB,
                                   ArrayRef<MachineOperand> Cond,
                                   const DebugLoc &DL, int *BytesAdded) const {
  unsigned Count = 1;
  if (Cond.empty()) {
    BuildMI(&MBB, DL, get(TP::J)).addMBB(TBB);
  } else {
    BuildMI(&MBB, DL, get(Cond[0].getImm()))
        .add(Cond[1])
        .add(Cond[2])
        .addMBB(TBB);
    if (FBB) {
      BuildMI(&MBB, DL, get(TP::J)).addMBB(FBB);
      ++Count;
    }
  }
  if (BytesAdded)
    *BytesAdded = 4 * Count;
  return Count;
}

bool TPInstrInfo::reverseBranchCondition(
    SmallVectorImpl<MachineOperand> &Cond) const {
  auto Opposite = [](unsigned Opcode) -> unsigned {
    switch (Opcode) {
    case TP::BEQ:
      return TP::BNE;
    case TP::BNE:
      return TP::BEQ;
    case TP::BLT:
      return TP::BGE;
    case TP::BGE:
      return TP::BLT;
    case TP::BLTU:
      return TP::BGEU;
    case TP::BGEU:
      return TP::BLTU;
    default:
      llvm_unreachable("not a conditional branch");
    }
  };
  Cond[0].setImm(Opposite(Cond[0].getImm()));
  return false;
}

bool TPInstrInfo::isBranchOffsetInRange(unsigned BranchOpcode,
                                        int64_t Offset) const {
  return BranchOpcode == TP::J ? isInt<28>(Offset) : isInt<18>(Offset);
}

unsigned TPInstrInfo::getInstSizeInBytes(const MachineInstr &MI) const {
  if (MI.isInlineAsm()) {
    const MachineFunction &MF = *MI.getMF();
    return getInlineAsmLength(MI.getOperand(0).getSymbolName(),
                              *MF.getTarget().getMCAsmInfo());
  }
  return MI.getDesc().getSize();
}

//===----------------------------------------------------------------------===//
// Memory
//===----------------------------------------------------------------------===//

bool TPInstrInfo::isGlobalMemoryObject(const MachineInstr *MI) const {
  switch (MI->getOpcode()) {
  case TP::DIV:
  case TP::DIVU:
  case TP::REM:
  case TP::REMU:
    // Their side effect, the trap, keeps them from being executed where the
    // source does not; it does not order memory.
    return false;
  default:
    return TargetInstrInfo::isGlobalMemoryObject(MI);
  }
}

static std::optional<unsigned> getAccessBytes(unsigned Opcode) {
  switch (Opcode) {
  case TP::LB:
  case TP::LBU:
  case TP::SB:
    return 1;
  case TP::LH:
  case TP::LHU:
  case TP::SH:
    return 2;
  case TP::LW:
  case TP::LWC1:
  case TP::SW:
  case TP::SWC1:
    return 4;
  default:
    return std::nullopt;
  }
}

bool TPInstrInfo::getMemOperandsWithOffsetWidth(
    const MachineInstr &MI, SmallVectorImpl<const MachineOperand *> &BaseOps,
    int64_t &Offset, bool &OffsetIsScalable, LocationSize &Width,
    const TargetRegisterInfo *) const {
  std::optional<unsigned> Bytes = getAccessBytes(MI.getOpcode());
  if (!Bytes || !MI.getOperand(2).isImm() ||
      !(MI.getOperand(1).isReg() || MI.getOperand(1).isFI()))
    return false;
  BaseOps.push_back(&MI.getOperand(1));
  Offset = MI.getOperand(2).getImm();
  OffsetIsScalable = false;
  Width = LocationSize::precise(*Bytes);
  return true;
}

bool TPInstrInfo::areMemAccessesTriviallyDisjoint(const MachineInstr &A,
                                                  const MachineInstr &B) const {
  if (A.hasUnmodeledSideEffects() || B.hasUnmodeledSideEffects() ||
      A.hasOrderedMemoryRef() || B.hasOrderedMemoryRef())
    return false;
  SmallVector<const MachineOperand *, 1> BasesA, BasesB;
  int64_t OffsetA, OffsetB;
  bool Scalable;
  LocationSize WidthA = LocationSize::precise(0);
  LocationSize WidthB = LocationSize::precise(0);
  if (!getMemOperandsWithOffsetWidth(A, BasesA, OffsetA, Scalable, WidthA,
                                     &RI) ||
      !getMemOperandsWithOffsetWidth(B, BasesB, OffsetB, Scalable, WidthB,
                                     &RI) ||
      !BasesA[0]->isIdenticalTo(*BasesB[0]))
    return false;
  int64_t LowerEnd =
      OffsetA < OffsetB
          ? OffsetA + static_cast<int64_t>(WidthA.getValue().getFixedValue())
          : OffsetB + static_cast<int64_t>(WidthB.getValue().getFixedValue());
  return LowerEnd <= std::max(OffsetA, OffsetB);
}

//===----------------------------------------------------------------------===//
// Machine IR as text
//===----------------------------------------------------------------------===//

std::pair<unsigned, unsigned>
TPInstrInfo::decomposeMachineOperandsTargetFlags(unsigned Flags) const {
  return {Flags, 0};
}

ArrayRef<std::pair<unsigned, const char *>>
TPInstrInfo::getSerializableDirectMachineOperandTargetFlags() const {
  static const std::pair<unsigned, const char *> Names[] = {
      {TPII::MO_HI, "tp-hi"}, {TPII::MO_LO, "tp-lo"}};
  return Names;
}

ArrayRef<std::pair<MachineMemOperand::Flags, const char *>>
TPInstrInfo::getSerializableMachineMemOperandTargetFlags() const {
  static const std::pair<MachineMemOperand::Flags, const char *> Names[] = {
      {TPII::MOPartOfWord, "tp-part-of-word"}};
  return Names;
}
