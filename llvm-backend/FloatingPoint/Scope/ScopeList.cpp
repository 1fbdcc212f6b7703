//===- ScopeList.cpp - Lists what fast math may change --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Scope/ScopeList.h"
#include "llvm-backend/FloatingPoint/Scope/ScopeItems.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/InstrTypes.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/Operator.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/JSON.h"
#include "llvm/Support/Path.h"

using namespace llvm;

static std::string pathOf(const DIScope &Scope) {
  SmallString<128> Path(Scope.getFilename());
  if (sys::path::is_relative(Path)) {
    Path = Scope.getDirectory();
    sys::path::append(Path, Scope.getFilename());
  }
  return std::string(Path);
}

static std::string nameOf(const Instruction &I) {
  if (const auto *Call = dyn_cast<CallBase>(&I))
    if (const Function *Callee = Call->getCalledFunction())
      return "call " + demangle(Callee->getName());
  return I.getOpcodeName();
}

static std::string flagsOf(const Instruction &I) {
  std::string Flags;
  raw_string_ostream Stream(Flags);
  if (isa<FPMathOperator>(I))
    I.getFastMathFlags().print(Stream);
  return Flags;
}

static void writeItem(const ScopeItem &Item, json::OStream &JSON) {
  if (!Item.Place) {
    JSON.attribute("what", "promises");
    JSON.attribute("flags", "");
    return;
  }
  JSON.attribute("what", nameOf(*Item.Place));
  JSON.attribute("flags", StringRef(flagsOf(*Item.Place)).trim());
  if (const DebugLoc &Place = Item.Place->getDebugLoc()) {
    JSON.attribute("file", pathOf(*Place->getFile()));
    JSON.attribute("line", Place.getLine());
    JSON.attribute("column", Place.getCol());
  }
}

static void writeFunction(Function &F, ArrayRef<ScopeItem> Items,
                          json::OStream &JSON) {
  JSON.attribute("source", F.getParent()->getSourceFileName());
  JSON.attribute("function", F.getName());
  JSON.attribute("name", demangle(F.getName()));
  JSON.attribute("local", F.hasLocalLinkage());
  if (const DISubprogram *Described = F.getSubprogram()) {
    JSON.attribute("file", pathOf(*Described));
    JSON.attribute("line", Described->getLine());
  }
  JSON.attributeArray("items", [&] {
    for (const ScopeItem &Item : Items)
      JSON.object([&] { writeItem(Item, JSON); });
  });
}

Error llvm::appendScopeList(ArrayRef<Function *> Functions, StringRef Path) {
  // All at once: several compilers may append at a time.
  std::string Lines;
  raw_string_ostream Stream(Lines);
  for (Function *F : Functions) {
    SmallVector<ScopeItem> Items = scopeItems(*F);
    if (Items.empty())
      continue;
    json::OStream JSON(Stream);
    JSON.object([&] { writeFunction(*F, Items, JSON); });
    Stream << '\n';
  }
  std::error_code Failure;
  raw_fd_ostream File(Path, Failure, sys::fs::OF_Append);
  if (!Failure) {
    File.SetUnbuffered();
    File << Lines;
    Failure = File.error();
    File.clear_error();
  }
  if (Failure)
    return createStringError("cannot write the list of fast-math items '" +
                             Path + "': " + Failure.message());
  return Error::success();
}
