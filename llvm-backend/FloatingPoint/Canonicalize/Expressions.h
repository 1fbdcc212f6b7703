//===- Expressions.h - Parts of floating-point expressions ---- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_EXPRESSIONS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_EXPRESSIONS_H

#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/IR/FMF.h"

namespace llvm {

class CallBase;
class Constant;
class Function;
class IRBuilderBase;
class Instruction;
class Type;
class Value;

// An expression is a tree of instructions with one use each, in one block. In
// what clang emits, before variables become values, that is at most a full
// expression of the source: a variable is stored and loaded.

/// Whether the rewrites apply to \p T: float, double or a vector of them.
bool isRewrittenType(const Type &T);

/// Calls \p Rewrite for each instruction of \p F that can be reached, operands
/// before their users. It may delete instructions.
void forEachInstruction(Function &F, function_ref<void(Instruction &)> Rewrite);

/// The flags for what takes the place of \p I.
FastMathFlags getRewriteFlags(const Instruction &I);

/// Puts \p New in the place of \p Old, and deletes what only \p Old used.
void replaceExpression(Instruction &Old, Value &New);

/// Whether \p V is computed for \p User's expression alone.
bool isPartOf(const Value &V, const Instruction &User);

/// Whether \p A and \p B are the same for a reader of the source: equal
/// operations on equal operands. Loads are the same where nothing between them
/// writes memory.
bool isSameValue(const Value *A, const Value *B);

/// Whether \p V is 1, or a vector of ones.
bool isOne(const Value &V);

/// Whether each element of \p C is finite, not zero and not subnormal.
bool isNormalConstant(const Constant &C);

/// The quotient of normal constants; null if it is not normal.
Constant *divideConstants(Constant &Dividend, Constant &Divisor);

/// The product of normal constants; null if it is not normal.
Constant *multiplyConstants(Constant &A, Constant &B);

/// \p Base multiplied by itself \p Exponent times (at least once), by repeated
/// squaring.
Value *createPower(IRBuilderBase &Builder, Value &Base, unsigned Exponent);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_EXPRESSIONS_H
