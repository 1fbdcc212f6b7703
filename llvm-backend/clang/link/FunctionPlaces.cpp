//===- FunctionPlaces.cpp - Where the source has a function ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/FunctionPlaces.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/Metadata.h"

using namespace llvm;

namespace tp {

static constexpr const char MetadataName[] = "tp.source";

void setFunctionPlace(Function &F, const FunctionPlace &Known) {
  LLVMContext &Context = F.getContext();
  auto Number = [&](unsigned Value) {
    return ConstantAsMetadata::get(
        ConstantInt::get(Type::getInt32Ty(Context), Value));
  };
  F.setMetadata(MetadataName,
                MDNode::get(Context, {MDString::get(Context, Known.Place.File),
                                      Number(Known.Place.Line),
                                      Number(Known.Place.Column),
                                      Number(Known.IsFrameLimitAnError)}));
}

FunctionPlace functionPlace(const Function &F) {
  FunctionPlace Result;
  if (const MDNode *Node = F.getMetadata(MetadataName)) {
    auto Number = [&](unsigned Index) -> unsigned {
      return mdconst::extract<ConstantInt>(Node->getOperand(Index))
          ->getZExtValue();
    };
    Result.Place = {cast<MDString>(Node->getOperand(0))->getString().str(),
                    Number(1), Number(2)};
    Result.IsFrameLimitAnError = Number(3) != 0;
    return Result;
  }
  if (const DISubprogram *Subprogram = F.getSubprogram())
    Result.Place = {Subprogram->getFilename().str(), Subprogram->getLine(), 0};
  return Result;
}

} // namespace tp
