//===- FloatingPointTarget.h - What a function's target can do  -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTTARGET_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTTARGET_H

#include "llvm/ADT/StringRef.h"
#include "llvm/TargetParser/Triple.h"

namespace llvm {

class Function;
class Type;

/// What the rewrites have to know of the target that a function is compiled
/// for: its triple and its features.
class FloatingPointTarget {
public:
  explicit FloatingPointTarget(const Function &F);

  bool isTP() const;

  /// Whether a multiply-add that is rounded once is one instruction for \p T.
  bool hasFusedMultiplyAdd(const Type &T) const;

private:
  bool hasFeature(StringRef Name) const;

  const Triple &TargetTriple;
  /// As in the attribute "target-features": `+fma,-trig`.
  StringRef Features;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTTARGET_H
