//===- Reductions.h - Sums of loops in several lanes ---------- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_REDUCTIONS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_REDUCTIONS_H

#include "llvm/IR/PassManager.h"

namespace llvm {

class Instruction;

// A loop that does nothing but add to a variable is a chain of dependent
// additions. With the flag `reassoc`, it is rewritten to add to several lanes
// in turn, which a fixed tree adds up. The number of lanes depends on the type
// alone, not on the target or the level. What is left of the trip count when
// it is divided by the number of lanes is added in order.

/// Lanes of a sum of float, and of double.
inline constexpr unsigned FloatLanes = 8;
inline constexpr unsigned DoubleLanes = 4;

/// The name of the metadata that marks an addition to a variable of a loop.
inline constexpr char ReductionMark[] = "tp.floating_point.reduction";

/// Marks the additions of \p F, as clang emits it, that add to a variable in an
/// innermost loop.
/// \returns whether there are any.
bool markReductions(Function &F);

/// Marks \p To if \p From is marked.
void copyReductionMark(const Instruction &From, Instruction &To);

/// Splits the marked sums where the loop is simple enough, at every
/// optimization level, and removes the marks.
void splitReductions(Function &F, FunctionAnalysisManager &Analyses);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_REDUCTIONS_H
