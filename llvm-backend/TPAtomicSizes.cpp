//===- TPAtomicSizes.cpp - Atomic objects that are too large --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPAtomicSizes.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/Module.h"

using namespace llvm;

static constexpr uint64_t MaxAtomicBytes = 8;

static constexpr StringLiteral GenericFunctions[] = {
    "__atomic_load", "__atomic_store", "__atomic_exchange",
    "__atomic_compare_exchange"};

static void report(const Instruction &I, uint64_t Bytes) {
  const Function &F = *I.getFunction();
  I.getContext().diagnose(DiagnosticInfoUnsupported(
      F,
      "atomic operation on " + Twine(Bytes) + " bytes in '" +
          demangle(F.getName()) + "'; the TP has them for at most " +
          Twine(MaxAtomicBytes) + ": protect the object with a lock",
      I.getDebugLoc()));
}

static bool isGenericFunction(const Function *F) {
  return F && is_contained(GenericFunctions, F->getName());
}

/// The number of bytes that \p I accesses if it is atomic, or 0.
static uint64_t getAtomicBytes(const Instruction &I, const DataLayout &Layout) {
  // Operations on types that are no integers are calls already.
  if (auto *Call = dyn_cast<CallBase>(&I)) {
    if (!isGenericFunction(Call->getCalledFunction()))
      return 0;
    auto *Bytes = dyn_cast<ConstantInt>(Call->getArgOperand(0));
    return Bytes ? Bytes->getZExtValue() : 0;
  }
  if (!I.isAtomic() || isa<FenceInst>(I))
    return 0;
  if (auto *Exchange = dyn_cast<AtomicCmpXchgInst>(&I))
    return Layout.getTypeStoreSize(Exchange->getNewValOperand()->getType());
  if (auto *Change = dyn_cast<AtomicRMWInst>(&I))
    return Layout.getTypeStoreSize(Change->getType());
  return Layout.getTypeStoreSize(getLoadStoreType(&I));
}

PreservedAnalyses TPAtomicSizesPass::run(Module &M, ModuleAnalysisManager &) {
  for (const Function &F : M)
    for (const Instruction &I : instructions(F))
      if (uint64_t Bytes = getAtomicBytes(I, M.getDataLayout());
          Bytes > MaxAtomicBytes) {
        report(I, Bytes);
        // One is enough: a switch over memory orders has several.
        break;
      }
  return PreservedAnalyses::all();
}
