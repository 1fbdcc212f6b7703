//===- TPAtomicLoops.cpp - What loops around a compare-exchange are for ---===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// An atomic operation without an instruction of its own becomes a loop around a
// compare-exchange, one on a byte an operation on the word around it. Two
// things are lost there that who looks for data races has to know: the load of
// the first guess does no harm if others write meanwhile, and of the word only
// some bytes are meant. Tags, which the expansion copies to all that it makes,
// keep them.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPAtomicLoops.h"
#include "llvm-backend/TP.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/MemoryModelRelaxationAnnotations.h"
#include "llvm/IR/Module.h"
#include "llvm/InitializePasses.h"
#include "llvm/Pass.h"

using namespace llvm;

static constexpr StringLiteral TagPrefix = "tp";
static constexpr StringLiteral WordTag = "word";
static constexpr StringLiteral PartOfWordTag = "part-of-word";

bool llvm::isPartOfWord(const Instruction &I) {
  return MMRAMetadata(I).hasTag(TagPrefix, PartOfWordTag);
}

namespace {

/// Before the expansion: tags the operations.
class TPAtomicTags : public FunctionPass {
public:
  static char ID;

  TPAtomicTags() : FunctionPass(ID) {}

  StringRef getPassName() const override { return "TP atomic tags"; }
  void getAnalysisUsage(AnalysisUsage &AU) const override {
    AU.setPreservesAll();
  }
  bool runOnFunction(Function &F) override;
};

/// Behind it: makes the loads atomic.
class TPAtomicLoops : public FunctionPass {
public:
  static char ID;

  TPAtomicLoops() : FunctionPass(ID) {}

  StringRef getPassName() const override { return "TP atomic loops"; }
  void getAnalysisUsage(AnalysisUsage &AU) const override {
    AU.setPreservesCFG();
  }
  bool runOnFunction(Function &F) override;
};

} // namespace

char TPAtomicTags::ID = 0;
char TPAtomicLoops::ID = 0;

INITIALIZE_PASS(TPAtomicTags, "tp-atomic-tags",
                "Tag atomic operations before they are expanded", false, false)
INITIALIZE_PASS(TPAtomicLoops, "tp-atomic-loops",
                "Make the first loads of compare-exchange loops atomic", false,
                false)

FunctionPass *llvm::createTPAtomicTagsPass() { return new TPAtomicTags(); }
FunctionPass *llvm::createTPAtomicLoopsPass() { return new TPAtomicLoops(); }

bool TPAtomicTags::runOnFunction(Function &F) {
  constexpr TypeSize WordBytes = TypeSize::getFixed(4);
  const DataLayout &Layout = F.getParent()->getDataLayout();
  bool Changed = false;
  for (Instruction &I : instructions(F)) {
    const Type *Changes = nullptr;
    if (auto *Change = dyn_cast<AtomicRMWInst>(&I))
      Changes = Change->getType();
    else if (auto *Exchange = dyn_cast<AtomicCmpXchgInst>(&I))
      Changes = Exchange->getNewValOperand()->getType();
    if (!Changes)
      continue;
    const TypeSize Bytes = Layout.getTypeStoreSize(const_cast<Type *>(Changes));
    // What is wider becomes calls, whose loads are not of the object.
    if (Bytes > WordBytes)
      continue;
    const bool IsPart = Bytes < WordBytes;
    I.setMetadata(LLVMContext::MD_mmra,
                  MMRAMetadata::getTagMD(F.getContext(), TagPrefix,
                                         IsPart ? PartOfWordTag : WordTag));
    Changed = true;
  }
  return Changed;
}

bool TPAtomicLoops::runOnFunction(Function &F) {
  bool Changed = false;
  for (Instruction &I : instructions(F)) {
    auto *Load = dyn_cast<LoadInst>(&I);
    if (!Load || Load->isAtomic() ||
        !MMRAMetadata(*Load).hasTagWithPrefix(TagPrefix))
      continue;
    // Unordered: nothing that stood on the other side of it needs to stay.
    Load->setAtomic(AtomicOrdering::Unordered);
    Changed = true;
  }
  return Changed;
}
