//===- FunctionPlaces.h - Where the source has a function -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_FUNCTIONPLACES_H
#define TP_LLVM_BACKEND_CLANG_LINK_FUNCTIONPLACES_H

#include "llvm-backend/clang/link/SourceMessages.h"
#include "llvm/IR/Function.h"

namespace tp {

/// What the front end tells the link of a function, with or without debug
/// information.
struct FunctionPlace {
  SourcePlace Place;
  /// Whether a frame larger than -Wframe-larger-than= says is an error.
  bool IsFrameLimitAnError = false;
};

/// Notes \p Known in the metadata of \p F.
void setFunctionPlace(llvm::Function &F, const FunctionPlace &Known);

/// What setFunctionPlace() noted, or else debug information says, of \p F;
/// without a line if neither does.
FunctionPlace functionPlace(const llvm::Function &F);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_FUNCTIONPLACES_H
