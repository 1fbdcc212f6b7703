//===- CheckConditions.h - When a floating-point check fails ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The conditions inspect a number's bits as an integer: whatever flags and
// options promise of floating-point values, no pass can conclude from them that
// a condition is false.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKCONDITIONS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKCONDITIONS_H

#include "llvm/IR/IRBuilder.h"

namespace llvm {

/// Values that are not numbers, or not finite ones.
struct NonFinite {
  bool NaN = false;
  bool Infinity = false;

  bool any() const { return NaN || Infinity; }
  bool covers(NonFinite Other) const {
    return (NaN || !Other.NaN) && (Infinity || !Other.Infinity);
  }
  NonFinite operator|(NonFinite Other) const {
    return {NaN || Other.NaN, Infinity || Other.Infinity};
  }
};

/// A conversion to an integer.
struct IntegerConversion {
  enum RoundingKind {
    TowardZero,
    /// To the nearest, halves to the even one.
    ToNearestEven,
    /// To the nearest, halves away from zero.
    ToNearestAway,
  };
  unsigned Bits = 32;
  bool IsSigned = true;
  RoundingKind Rounding = TowardZero;
};

/// Whether numbers of \p Ty can be checked: half, bfloat, float and double.
bool isCheckableScalar(const Type *Ty);

/// The bits of the scalar \p Number as an integer.
Value *floatBits(IRBuilderBase &Builder, Value *Number);

/// Whether \p Number is one of \p Classes, of which there is at least one.
Value *isNonFinite(IRBuilderBase &Builder, Value *Number, NonFinite Classes);

/// Whether \p Number is NaN, or out of range of \p Conversion.
Value *isOutOfRange(IRBuilderBase &Builder, Value *Number,
                    IntegerConversion Conversion);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKCONDITIONS_H
