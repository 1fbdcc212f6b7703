//===- TPOutlining.cpp - Common code in functions of its own --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What the machine outliner asks. A call destroys r31, so that code is outlined
// only where nothing is in it. The outlined function has no frame: it uses the
// caller's through r29.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPInstrInfo.h"
#include "llvm/CodeGen/MachineInstrBuilder.h"
#include "llvm/CodeGen/MachineOutliner.h"
#include "llvm/IR/Module.h"

using namespace llvm;

bool TPInstrInfo::isFunctionSafeToOutlineFrom(
    MachineFunction &MF, bool OutlineFromLinkOnceODRs) const {
  const Function &F = MF.getFunction();
  return !F.hasSection() && !F.hasFnAttribute(Attribute::Naked) &&
         (OutlineFromLinkOnceODRs || !F.hasLinkOnceODRLinkage());
}

outliner::InstrType
TPInstrInfo::getOutliningTypeImpl(const MachineModuleInfo &,
                                  MachineBasicBlock::iterator &MIT,
                                  unsigned) const {
  const MachineInstr &MI = *MIT;
  // Unwinding relies on the places of prologues and epilogues.
  if (MI.isCFIInstruction() || MI.getFlag(MachineInstr::FrameSetup) ||
      MI.getFlag(MachineInstr::FrameDestroy) || MI.isCall() ||
      MI.isTerminator() || MI.modifiesRegister(TP::R29, &RI) ||
      MI.readsRegister(TP::R31, &RI) || MI.modifiesRegister(TP::R31, &RI))
    return outliner::InstrType::Illegal;
  // Whoever looks for data races must find them.
  if (any_of(MI.memoperands(), [](const MachineMemOperand *Operand) {
        return Operand->isAtomic();
      }))
    return outliner::InstrType::Illegal;
  return outliner::InstrType::Legal;
}

std::optional<std::unique_ptr<outliner::OutlinedFunction>>
TPInstrInfo::getOutliningCandidateInfo(
    const MachineModuleInfo &,
    std::vector<outliner::Candidate> &RepeatedSequenceLocs,
    unsigned MinRepeats) const {
  llvm::erase_if(RepeatedSequenceLocs, [&](outliner::Candidate &C) {
    return !C.isAvailableAcrossAndOutOfSeq(TP::R31, RI);
  });
  if (RepeatedSequenceLocs.size() < MinRepeats)
    return std::nullopt;
  unsigned Bytes = 0;
  for (const MachineInstr &MI : RepeatedSequenceLocs.front())
    Bytes += getInstSizeInBytes(MI);
  for (outliner::Candidate &C : RepeatedSequenceLocs)
    C.setCallInfo(/*CID=*/0, /*CO=*/get(TP::JAL).getSize());
  return std::make_unique<outliner::OutlinedFunction>(
      RepeatedSequenceLocs, Bytes, /*FrameOverhead=*/get(TP::RET).getSize(),
      /*FrameConstructionID=*/0);
}

void TPInstrInfo::buildOutlinedFrame(MachineBasicBlock &MBB, MachineFunction &,
                                     const outliner::OutlinedFunction &) const {
  MBB.addLiveIn(TP::R31);
  BuildMI(&MBB, DebugLoc(), get(TP::RET));
}

MachineBasicBlock::iterator TPInstrInfo::insertOutlinedCall(
    Module &M, MachineBasicBlock &MBB, MachineBasicBlock::iterator &It,
    MachineFunction &MF, outliner::Candidate &) const {
  It = BuildMI(MBB, It, DebugLoc(), get(TP::JAL))
           .addGlobalAddress(M.getNamedValue(MF.getName()));
  return It;
}
