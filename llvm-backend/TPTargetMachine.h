//===- TPTargetMachine.h - The TP as a target of LLVM -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPTARGETMACHINE_H
#define TP_LLVM_BACKEND_TPTARGETMACHINE_H

#include "llvm-backend/TPSubtarget.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/CodeGen/CodeGenTargetMachineImpl.h"
#include <memory>
#include <optional>

namespace llvm {

class TPTargetMachine : public CodeGenTargetMachineImpl {
  std::unique_ptr<TargetLoweringObjectFile> ObjectFileLowering;
  /// By processor and features.
  mutable StringMap<std::unique_ptr<TPSubtarget>> Subtargets;

public:
  TPTargetMachine(const Target &T, const Triple &TT, StringRef CPU,
                  StringRef FS, const TargetOptions &Options,
                  std::optional<Reloc::Model> RM,
                  std::optional<CodeModel::Model> CM, CodeGenOptLevel OptLevel,
                  bool JIT);
  ~TPTargetMachine() override;

  const TPSubtarget *getSubtargetImpl(const Function &F) const override;
  TargetPassConfig *createPassConfig(PassManagerBase &PM) override;
  TargetTransformInfo getTargetTransformInfo(const Function &F) const override;
  TargetLoweringObjectFile *getObjFileLowering() const override {
    return ObjectFileLowering.get();
  }
  MachineFunctionInfo *
  createMachineFunctionInfo(BumpPtrAllocator &Allocator, const Function &F,
                            const TargetSubtargetInfo *STI) const override;
  void registerPassBuilderCallbacks(PassBuilder &PB) override;
};

} // namespace llvm

/// Registers the TP's code generator, and with it all its other parts, with
/// LLVM's target registry. May be called more than once.
extern "C" void LLVMInitializeTPTarget();

#endif // TP_LLVM_BACKEND_TPTARGETMACHINE_H
