//===- TPTargetMachine.cpp - The TP as a target of LLVM -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPTargetMachine.h"
#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm-backend/FloatingPoint/FloatingPointPasses.h"
#include "llvm-backend/TP.h"
#include "llvm-backend/TPAtomicSizes.h"
#include "llvm-backend/TPBuiltinAttributes.h"
#include "llvm-backend/TPByValArguments.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/TPMachineFunctionInfo.h"
#include "llvm-backend/TPTargetTransformInfo.h"
#include "llvm-backend/TargetInfo/TPTargetInfo.h"
#include "llvm/CodeGen/Passes.h"
#include "llvm/CodeGen/TargetLoweringObjectFileImpl.h"
#include "llvm/CodeGen/TargetPassConfig.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Passes/PassBuilder.h"

using namespace llvm;

extern "C" LLVM_EXTERNAL_VISIBILITY void LLVMInitializeTPTarget() {
  static const bool Initialized = [] {
    LLVMInitializeTPTargetInfo();
    LLVMInitializeTPTargetMC();
    LLVMInitializeTPAsmParser();
    LLVMInitializeTPDisassembler();
    RegisterTargetMachine<TPTargetMachine> X(getTheTPTarget());
    registerTPAsmPrinter();

    PassRegistry &Registry = *PassRegistry::getPassRegistry();
    initializeTPAsmPrinterPass(Registry);
    initializeTPPointedVariablesPass(Registry);
    initializeTPAtomicLoopsPass(Registry);
    initializeTPAtomicTagsPass(Registry);
    initializeTPCheckedObjectsPass(Registry);
    initializeTPBuiltinAttributesLegacyPass(Registry);
    initializeTPDAGToDAGISelLegacyPass(Registry);
    initializeTPGlobalLoadsPass(Registry);
    initializeTPStrictHalfFloatsPass(Registry);
    return true;
  }();
  (void)Initialized;
}

/// The triple's name and a processor stand for nothing: everything is static,
/// at absolute addresses.
TPTargetMachine::TPTargetMachine(const Target &T, const Triple &TT,
                                 StringRef CPU, StringRef FS,
                                 const TargetOptions &Options,
                                 std::optional<Reloc::Model>,
                                 std::optional<CodeModel::Model> CM,
                                 CodeGenOptLevel OptLevel, bool)
    : CodeGenTargetMachineImpl(
          T, TPDataLayout, TT, CPU.empty() ? "generic" : CPU, FS, Options,
          Reloc::Static, getEffectiveCodeModel(CM, CodeModel::Small), OptLevel),
      ObjectFileLowering(std::make_unique<TargetLoweringObjectFileELF>()) {
  this->Options.EnableCFIFixup = true;
  // Only where an option asks for it.
  setMachineOutliner(true);
  setSupportsDebugEntryValues(true);
  if (isFloatingPointCanonicalizationEnabled())
    this->Options.AllowFPOpFusion = FPOpFusion::Strict;
  initAsmInfo();
}

TPTargetMachine::~TPTargetMachine() = default;

const TPSubtarget *TPTargetMachine::getSubtargetImpl(const Function &F) const {
  Attribute CPUAttribute = F.getFnAttribute("target-cpu");
  Attribute FSAttribute = F.getFnAttribute("target-features");
  StringRef CPU =
      CPUAttribute.isValid() ? CPUAttribute.getValueAsString() : TargetCPU;
  StringRef FS = FSAttribute.isValid() ? FSAttribute.getValueAsString()
                                       : StringRef(TargetFS);
  if (CPU.empty())
    CPU = "generic";
  std::unique_ptr<TPSubtarget> &Subtarget = Subtargets[(CPU + FS).str()];
  if (!Subtarget)
    Subtarget = std::make_unique<TPSubtarget>(TargetTriple, CPU, FS, *this);
  return Subtarget.get();
}

TargetTransformInfo
TPTargetMachine::getTargetTransformInfo(const Function &F) const {
  return TargetTransformInfo(std::make_unique<TPTTIImpl>(this, F));
}

MachineFunctionInfo *TPTargetMachine::createMachineFunctionInfo(
    BumpPtrAllocator &Allocator, const Function &F,
    const TargetSubtargetInfo *STI) const {
  return TPMachineFunctionInfo::create<TPMachineFunctionInfo>(Allocator, F,
                                                              STI);
}

void TPTargetMachine::registerPassBuilderCallbacks(PassBuilder &PB) {
  // First: they call builtins.
  registerFloatingPointPasses(PB);
  PB.registerPipelineStartEPCallback(
      [](ModulePassManager &PM, auto...) { PM.addPass(TPAtomicSizesPass()); });
  auto AddAttributes = [](ModulePassManager &PM, auto...) {
    PM.addPass(TPBuiltinAttributesPass());
  };
  PB.registerPipelineStartEPCallback(AddAttributes);
  PB.registerFullLinkTimeOptimizationEarlyEPCallback(AddAttributes);
  auto WriteOutByVal = [](ModulePassManager &PM, OptimizationLevel Level,
                          auto...) {
    if (Level != OptimizationLevel::O0)
      PM.addPass(TPByValArgumentsPass());
  };
  PB.registerPipelineStartEPCallback(WriteOutByVal);
  PB.registerFullLinkTimeOptimizationEarlyEPCallback(WriteOutByVal);
  PB.registerPipelineParsingCallback(
      [](StringRef Name, ModulePassManager &PM,
         ArrayRef<PassBuilder::PipelineElement>) {
        if (Name == "tp-builtin-attributes")
          PM.addPass(TPBuiltinAttributesPass());
        else if (Name == "tp-byval-arguments")
          PM.addPass(TPByValArgumentsPass());
        else
          return false;
        return true;
      });
}

//===----------------------------------------------------------------------===//
// Passes
//===----------------------------------------------------------------------===//

namespace {

class TPPassConfig : public TargetPassConfig {
public:
  TPPassConfig(TPTargetMachine &TM, PassManagerBase &PM)
      : TargetPassConfig(TM, PM) {
    if (TM.getOptLevel() != CodeGenOptLevel::None)
      substitutePass(&PostRASchedulerID, &PostMachineSchedulerID);
  }

  TPTargetMachine &getTPTargetMachine() const {
    return getTM<TPTargetMachine>();
  }

  void addIRPasses() override {
    addPass(createTPBuiltinAttributesPass());
    addPass(createTPStrictHalfFloatsPass());
    addPass(createTPCheckedObjectsPass());
    addPass(createTPPointedVariablesPass());
    addPass(createTPAtomicTagsPass());
    addPass(createAtomicExpandLegacyPass());
    addPass(createTPAtomicLoopsPass());
    TargetPassConfig::addIRPasses();
  }

  void addCodeGenPrepare() override {
    if (getOptLevel() != CodeGenOptLevel::None)
      addPass(createTypePromotionLegacyPass());
    TargetPassConfig::addCodeGenPrepare();
  }

  bool addInstSelector() override {
    addPass(createTPISelDag(getTPTargetMachine(), getOptLevel()));
    return false;
  }

  void addPreRegAlloc() override {
    if (getOptLevel() != CodeGenOptLevel::None)
      addPass(createTPGlobalLoadsPass());
  }

  void addPreEmitPass() override { addPass(&BranchRelaxationPassID); }
};

} // namespace

TargetPassConfig *TPTargetMachine::createPassConfig(PassManagerBase &PM) {
  return new TPPassConfig(*this, PM);
}
