//===- Scope.cpp - Fast math in part of a program -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Scope/Scope.h"
#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm-backend/FloatingPoint/Scope/ScopeFile.h"
#include "llvm-backend/FloatingPoint/Scope/ScopeItems.h"
#include "llvm-backend/FloatingPoint/Scope/ScopeList.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/Module.h"

using namespace llvm;

// On functions that the pass has seen, with one of the two values: after
// linking they would no longer match what the file says of them.
static constexpr StringRef SeenAttribute = "tp-fp-scope";
static constexpr StringRef Kept = "kept";
static constexpr StringRef Strict = "strict";

// Whether something of \p F has become strict.
static bool restrict(Function &F, const ScopeSelection &Selected) {
  bool Changed = false;
  for (auto [Number, Item] : enumerate(scopeItems(F)))
    if (!Selected.contains(Number)) {
      makeStrict(Item, F);
      Changed = true;
    }
  return Changed;
}

static void applyScope(Module &M, const ScopeFile &File) {
  bool Changed = false;
  for (Function &F : M) {
    if (F.isDeclaration() || F.hasFnAttribute(SeenAttribute))
      continue;
    bool IsStrict =
        restrict(F, File.select(M.getSourceFileName(), F.getName()));
    F.addFnAttr(SeenAttribute, IsStrict ? Strict : Kept);
    Changed |= IsStrict;
  }
  // A call that keeps its freedom says itself what it promises.
  if (Changed)
    for (Function &F : M)
      if (F.isDeclaration())
        makeDeclarationStrict(F);
}

static Error listItems(Module &M, StringRef Path) {
  SmallVector<Function *> Unseen;
  for (Function &F : M)
    if (!F.isDeclaration() && !F.hasFnAttribute(SeenAttribute))
      Unseen.push_back(&F);
  return appendScopeList(Unseen, Path);
}

static Error listAndRestrict(Module &M, StringRef ListPath, StringRef Path) {
  if (!ListPath.empty())
    if (Error Failure = listItems(M, ListPath))
      return Failure;
  Expected<ScopeFile> File =
      Path.empty() ? ScopeFile::everything() : ScopeFile::read(Path);
  if (!File)
    return File.takeError();
  applyScope(M, *File);
  return Error::success();
}

PreservedAnalyses FloatingPointScopePass::run(Module &M,
                                              ModuleAnalysisManager &) {
  StringRef ListPath = getFloatingPointScopeListFile();
  StringRef Path = getFloatingPointScopeFile();
  if (ListPath.empty() && Path.empty())
    return PreservedAnalyses::all();
  if (Error Failure = listAndRestrict(M, ListPath, Path))
    M.getContext().emitError(toString(std::move(Failure)));
  return PreservedAnalyses::none();
}

bool llvm::isPartlyStrict(const Module &M) {
  return any_of(M, [](const Function &F) {
    return F.getFnAttribute(SeenAttribute).getValueAsString() == Strict;
  });
}
