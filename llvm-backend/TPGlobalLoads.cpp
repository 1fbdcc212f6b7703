//===- TPGlobalLoads.cpp - Keep what global memory gives in registers -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// To spill a value just loaded from global memory means to wait for it, a
// hundred cycles in which no other load starts. Any other value costs two. The
// allocator learns it from the register class: its registers are the same, its
// spill weight is higher.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TP.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/CodeGen/MachineFunctionPass.h"
#include "llvm/CodeGen/MachineRegisterInfo.h"
#include "llvm/InitializePasses.h"

using namespace llvm;

#define DEBUG_TYPE "tp-global-loads"

namespace {

class TPGlobalLoads : public MachineFunctionPass {
public:
  static char ID;

  TPGlobalLoads() : MachineFunctionPass(ID) {}

  StringRef getPassName() const override { return "TP global loads"; }

  void getAnalysisUsage(AnalysisUsage &AU) const override {
    AU.setPreservesAll();
    MachineFunctionPass::getAnalysisUsage(AU);
  }

  bool runOnMachineFunction(MachineFunction &MF) override;
};

} // namespace

char TPGlobalLoads::ID = 0;

INITIALIZE_PASS(TPGlobalLoads, DEBUG_TYPE,
                "Make values loaded from global memory dear to spill", false,
                false)

FunctionPass *llvm::createTPGlobalLoadsPass() { return new TPGlobalLoads(); }

bool TPGlobalLoads::runOnMachineFunction(MachineFunction &MF) {
  MachineRegisterInfo &MRI = MF.getRegInfo();
  bool Changed = false;
  for (MachineBasicBlock &MBB : MF)
    for (MachineInstr &MI : MBB) {
      if (MI.isCall() || MI.isInlineAsm() || !TPSubtarget::isGlobalLoad(MI))
        continue;
      for (MachineOperand &Def : MI.all_defs()) {
        if (!Def.getReg().isVirtual())
          continue;
        const TargetRegisterClass *Class = MRI.getRegClass(Def.getReg());
        if (Class != &TP::GPRRegClass && Class != &TP::FPRRegClass)
          continue;
        MRI.setRegClass(Def.getReg(), Class == &TP::GPRRegClass
                                          ? &TP::GPRLoadedRegClass
                                          : &TP::FPRLoadedRegClass);
        Changed = true;
      }
    }
  return Changed;
}
