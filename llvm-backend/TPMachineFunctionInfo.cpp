//===- TPMachineFunctionInfo.cpp - Facts on a function --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPMachineFunctionInfo.h"
#include "llvm/CodeGen/MachineFrameInfo.h"

using namespace llvm;

MachineFunctionInfo *TPMachineFunctionInfo::clone(
    BumpPtrAllocator &, MachineFunction &DestMF,
    const DenseMap<MachineBasicBlock *, MachineBasicBlock *> &) const {
  return DestMF.cloneInfo<TPMachineFunctionInfo>(*this);
}

int TPMachineFunctionInfo::getByValCopy(MachineFunction &MF, unsigned Number,
                                        uint64_t Size, Align Alignment) {
  MachineFrameInfo &MFI = MF.getFrameInfo();
  while (ByValCopies.size() <= Number)
    ByValCopies.push_back(MFI.CreateStackObject(1, Align(4), false));
  int Index = ByValCopies[Number];
  if (MFI.getObjectSize(Index) < static_cast<int64_t>(Size))
    MFI.setObjectSize(Index, Size);
  if (MFI.getObjectAlign(Index) < Alignment) {
    MFI.setObjectAlignment(Index, Alignment);
    MFI.ensureMaxAlignment(Alignment);
  }
  return Index;
}
