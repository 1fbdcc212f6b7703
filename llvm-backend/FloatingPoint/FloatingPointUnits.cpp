//===- FloatingPointUnits.cpp - What units assume of infinity -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/FloatingPointUnits.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/Metadata.h"
#include "llvm/IR/Module.h"

using namespace llvm;

static constexpr StringRef MetadataName = "tp.floating_point";

// In a section: one of these, then the file's name and a zero.
static constexpr char HonoursInfinities = 'h';
static constexpr char AssumesFinite = 'f';

void llvm::addFloatingPointUnit(Module &M, const FloatingPointUnit &Unit) {
  LLVMContext &Context = M.getContext();
  Metadata *Node[] = {
      MDString::get(Context, Unit.SourceFile),
      ConstantAsMetadata::get(ConstantInt::getBool(Context, Unit.IsFinite))};
  M.getOrInsertNamedMetadata(MetadataName)
      ->addOperand(MDNode::get(Context, Node));
}

SmallVector<FloatingPointUnit> llvm::floatingPointUnits(const Module &M) {
  SmallVector<FloatingPointUnit> Units;
  const NamedMDNode *Nodes = M.getNamedMetadata(MetadataName);
  if (!Nodes)
    return Units;
  for (const MDNode *Node : Nodes->operands()) {
    if (Node->getNumOperands() != 2)
      continue;
    auto *Name = dyn_cast_or_null<MDString>(Node->getOperand(0));
    auto *IsFinite =
        mdconst::dyn_extract_or_null<ConstantInt>(Node->getOperand(1));
    if (Name && IsFinite)
      Units.push_back({Name->getString().str(), IsFinite->isOne()});
  }
  return Units;
}

std::string llvm::encodeFloatingPointUnits(
    const SmallVectorImpl<FloatingPointUnit> &Units) {
  std::string Section;
  for (const FloatingPointUnit &Unit : Units) {
    Section += Unit.IsFinite ? AssumesFinite : HonoursInfinities;
    Section += Unit.SourceFile;
    Section += '\0';
  }
  return Section;
}

SmallVector<FloatingPointUnit>
llvm::decodeFloatingPointUnits(StringRef Section) {
  SmallVector<FloatingPointUnit> Units;
  while (true) {
    size_t End = Section.find('\0');
    if (End == StringRef::npos || End == 0 ||
        (Section.front() != AssumesFinite &&
         Section.front() != HonoursInfinities))
      return Units;
    Units.push_back(
        {Section.slice(1, End).str(), Section.front() == AssumesFinite});
    Section = Section.drop_front(End + 1);
  }
}
