//===- TPProfilePort.h - Where profile instructions write -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPPROFILEPORT_H
#define TP_LLVM_BACKEND_TPPROFILEPORT_H

#include "llvm/CodeGen/PseudoSourceValue.h"
#include "llvm/Support/raw_ostream.h"

namespace llvm {

/// The memory that profile instructions write for the code generator: no other
/// access touches it. So they keep their order and stay in their loops and
/// branches, and no load or store waits for them.
class TPProfilePort final : public PseudoSourceValue {
public:
  explicit TPProfilePort(const TargetMachine &TM)
      : PseudoSourceValue(TargetCustom, TM) {}

  bool isConstant(const MachineFrameInfo *) const override { return false; }
  bool isAliased(const MachineFrameInfo *) const override { return false; }
  bool mayAlias(const MachineFrameInfo *) const override { return false; }

private:
  void printCustom(raw_ostream &OS) const override { OS << "ProfilePort"; }
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPPROFILEPORT_H
