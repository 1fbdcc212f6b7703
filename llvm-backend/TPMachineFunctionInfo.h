//===- TPMachineFunctionInfo.h - Facts on a function ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPMACHINEFUNCTIONINFO_H
#define TP_LLVM_BACKEND_TPMACHINEFUNCTIONINFO_H

#include "llvm/ADT/SmallVector.h"
#include "llvm/CodeGen/MachineFunction.h"

namespace llvm {

/// The TP's private information on one machine function.
class TPMachineFunctionInfo : public MachineFunctionInfo {
  int VarArgsFrameIndex = 0;
  SmallVector<int, 4> ByValCopies;

public:
  TPMachineFunctionInfo(const Function &, const TargetSubtargetInfo *) {}

  MachineFunctionInfo *
  clone(BumpPtrAllocator &Allocator, MachineFunction &DestMF,
        const DenseMap<MachineBasicBlock *, MachineBasicBlock *> &)
      const override;

  /// The frame index of the first unnamed argument of a variadic function.
  int getVarArgsFrameIndex() const { return VarArgsFrameIndex; }
  void setVarArgsFrameIndex(int Index) { VarArgsFrameIndex = Index; }

  /// Returns the frame index of the memory that holds the caller's copy of the
  /// \p Number-th struct that a call passes by value, at least \p Size bytes
  /// aligned to \p Alignment. Calls do not overlap, so they share these
  /// objects.
  int getByValCopy(MachineFunction &MF, unsigned Number, uint64_t Size,
                   Align Alignment);
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPMACHINEFUNCTIONINFO_H
