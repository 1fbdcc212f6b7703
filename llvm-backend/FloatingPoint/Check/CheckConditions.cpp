//===- CheckConditions.cpp - When a floating-point check fails ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckConditions.h"
#include "llvm/ADT/APFloat.h"

using namespace llvm;

bool llvm::isCheckableScalar(const Type *Ty) {
  return Ty->isHalfTy() || Ty->isBFloatTy() || Ty->isFloatTy() ||
         Ty->isDoubleTy();
}

Value *llvm::floatBits(IRBuilderBase &Builder, Value *Number) {
  return Builder.CreateBitCast(
      Number, Builder.getIntNTy(Number->getType()->getScalarSizeInBits()));
}

static Value *magnitudeBits(IRBuilderBase &Builder, Value *Bits) {
  unsigned Size = Bits->getType()->getIntegerBitWidth();
  return Builder.CreateAnd(
      Bits, ConstantInt::get(Bits->getType(), APInt::getSignedMaxValue(Size)));
}

Value *llvm::isNonFinite(IRBuilderBase &Builder, Value *Number,
                         NonFinite Classes) {
  Value *Magnitude = magnitudeBits(Builder, floatBits(Builder, Number));
  Constant *Infinity = ConstantInt::get(
      Magnitude->getType(),
      APFloat::getInf(Number->getType()->getFltSemantics()).bitcastToAPInt());
  CmpInst::Predicate Predicate = CmpInst::ICMP_UGE;
  if (!Classes.Infinity)
    Predicate = CmpInst::ICMP_UGT;
  else if (!Classes.NaN)
    Predicate = CmpInst::ICMP_EQ;
  return Builder.CreateICmp(Predicate, Magnitude, Infinity);
}

/// The bits of the smallest magnitude in \p Semantics that \p Conversion cannot
/// take, of negative numbers or of the others.
static APInt firstMagnitudeOutOfRange(const fltSemantics &Semantics,
                                      IntegerConversion Conversion,
                                      bool IsNegative) {
  unsigned Width = Conversion.Bits + 3;
  APInt Greatest =
      IsNegative
          ? APInt(Width, 0)
          : APInt::getLowBitsSet(Width, Conversion.Bits - Conversion.IsSigned);
  if (IsNegative && Conversion.IsSigned)
    Greatest.setBit(Conversion.Bits - 1);
  APInt Halves = (Greatest + 1) << 1;
  if (Conversion.Rounding != IntegerConversion::TowardZero)
    Halves -= 1;
  // What lies halfway behind an even number still rounds to that.
  bool HalfwayFits =
      Conversion.Rounding == IntegerConversion::ToNearestEven && !Greatest[0];

  APFloat Limit(APFloat::IEEEquad());
  Limit.convertFromAPInt(Halves, /*IsSigned=*/false, APFloat::rmTowardPositive);
  Limit = scalbn(Limit, -1, APFloat::rmTowardPositive);
  bool IsRounded = false;
  Limit.convert(Semantics, APFloat::rmTowardPositive, &IsRounded);
  if (HalfwayFits && !IsRounded)
    Limit.next(/*nextDown=*/false);
  return Limit.bitcastToAPInt();
}

Value *llvm::isOutOfRange(IRBuilderBase &Builder, Value *Number,
                          IntegerConversion Conversion) {
  const fltSemantics &Semantics = Number->getType()->getFltSemantics();
  Value *Bits = floatBits(Builder, Number);
  Value *IsNegative =
      Builder.CreateICmpSLT(Bits, Constant::getNullValue(Bits->getType()));
  Value *Limit = Builder.CreateSelect(
      IsNegative,
      ConstantInt::get(Bits->getType(),
                       firstMagnitudeOutOfRange(Semantics, Conversion, true)),
      ConstantInt::get(Bits->getType(),
                       firstMagnitudeOutOfRange(Semantics, Conversion, false)));
  return Builder.CreateICmpUGE(magnitudeBits(Builder, Bits), Limit);
}
