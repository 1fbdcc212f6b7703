//===- CodeSession.cpp - LLVM as a compiler in memory ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/CodeSession.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Analysis/CGSCCPassManager.h"
#include "llvm/ExecutionEngine/Orc/ExecutionUtils.h"
#include "llvm/Passes/PassBuilder.h"
#include "llvm/Support/TargetSelect.h"
#include "llvm/TargetParser/Host.h"
#include "llvm/TargetParser/SubtargetFeature.h"
#include "llvm/Transforms/IPO/AlwaysInliner.h"
#include "llvm/Transforms/IPO/GlobalDCE.h"
#include "llvm/Transforms/InstCombine/InstCombine.h"
#include "llvm/Transforms/Scalar/ADCE.h"
#include "llvm/Transforms/Scalar/DeadStoreElimination.h"
#include "llvm/Transforms/Scalar/EarlyCSE.h"
#include "llvm/Transforms/Scalar/SROA.h"
#include "llvm/Transforms/Scalar/SimplifyCFG.h"

using namespace llvm;

namespace tp {

static const std::string &hostFeatures() {
  static const std::string Features = [] {
    SubtargetFeatures Result;
    for (const auto &[Name, IsOn] : sys::getHostCPUFeatures())
      Result.AddFeature(Name, IsOn);
    return Result.getString();
  }();
  return Features;
}

void prepareFunction(Function &F) {
  F.setDoesNotThrow();
  F.addFnAttr("target-cpu", sys::getHostCPUName());
  F.addFnAttr("target-features", hostFeatures());
  F.addFnAttr("frame-pointer", "none");
}

static FunctionPassManager passesBeforeSpecialization() {
  FunctionPassManager Passes;
  Passes.addPass(SROAPass(SROAOptions::ModifyCFG));
  Passes.addPass(EarlyCSEPass());
  return Passes;
}

static FunctionPassManager passesAfterSpecialization() {
  FunctionPassManager Passes;
  Passes.addPass(InstCombinePass());
  Passes.addPass(SimplifyCFGPass());
  Passes.addPass(EarlyCSEPass(/*UseMemorySSA=*/true));
  Passes.addPass(InstCombinePass());
  Passes.addPass(DSEPass());
  Passes.addPass(SimplifyCFGPass());
  Passes.addPass(ADCEPass());
  return Passes;
}

/// Reads the bodies of the functions that are called, and drops the others:
/// most of the library is not used by one batch.
static void materializeUsed(Module &M) {
  for (bool Found = true; Found;) {
    Found = false;
    for (Function &F : M) {
      if (!F.isMaterializable() || F.use_empty())
        continue;
      Found = true;
      // The bitcode is the simulator's own.
      cantFail(F.materialize());
    }
  }
  for (Function &F : make_early_inc_range(M))
    if (F.isMaterializable())
      F.eraseFromParent();
  cantFail(M.materializeAll());
}

void optimize(Module &M, function_ref<void(Function &)> Specialize) {
  LoopAnalysisManager Loops;
  FunctionAnalysisManager Functions;
  CGSCCAnalysisManager Components;
  ModuleAnalysisManager Modules;
  PassBuilder Builder;
  Builder.registerModuleAnalyses(Modules);
  Builder.registerCGSCCAnalyses(Components);
  Builder.registerFunctionAnalyses(Functions);
  Builder.registerLoopAnalyses(Loops);
  Builder.crossRegisterProxies(Loops, Functions, Components, Modules);

  materializeUsed(M);
  ModulePassManager Inlining;
  Inlining.addPass(GlobalDCEPass());
  Inlining.addPass(AlwaysInlinerPass(/*InsertLifetime=*/false));
  Inlining.addPass(GlobalDCEPass());
  Inlining.run(M, Modules);
  FunctionPassManager Before = passesBeforeSpecialization();
  FunctionPassManager After = passesAfterSpecialization();
  for (Function &F : M) {
    if (F.isDeclaration() || F.hasLocalLinkage())
      continue;
    Before.run(F, Functions);
    Specialize(F);
    Functions.invalidate(F, PreservedAnalyses::none());
    After.run(F, Functions);
  }
}

Expected<std::unique_ptr<CodeSession>> CodeSession::create() {
  InitializeNativeTarget();
  InitializeNativeTargetAsmPrinter();
  Expected<orc::JITTargetMachineBuilder> Target =
      orc::JITTargetMachineBuilder::detectHost();
  if (!Target)
    return Target.takeError();
  Target->setCodeGenOptLevel(CodeGenOptLevel::Default);
  Expected<std::unique_ptr<orc::LLJIT>> Jit =
      orc::LLJITBuilder()
          .setJITTargetMachineBuilder(std::move(*Target))
          .create();
  if (!Jit)
    return Jit.takeError();
  return std::unique_ptr<CodeSession>(new CodeSession(std::move(*Jit)));
}

Expected<std::vector<const void *>>
CodeSession::compile(std::unique_ptr<Module> M,
                     std::unique_ptr<LLVMContext> Context,
                     const std::vector<std::string> &Names) {
  M->setDataLayout(Jit->getDataLayout());
  if (Error E = Jit->addIRModule(
          orc::ThreadSafeModule(std::move(M), std::move(Context))))
    return E;
  std::vector<const void *> Addresses;
  for (const std::string &Name : Names) {
    Expected<orc::ExecutorAddr> Address = Jit->lookup(Name);
    if (!Address)
      return Address.takeError();
    Addresses.push_back(Address->toPtr<const void *>());
  }
  return Addresses;
}

} // namespace tp
