//===- Powers.cpp - Powers with a literal exponent ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Expressions.h"
#include "llvm-backend/FloatingPoint/Canonicalize/MathFunctions.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstrTypes.h"
#include "llvm/IR/PatternMatch.h"
#include <cmath>

using namespace llvm;
using namespace PatternMatch;

// Larger exponents are left to the library.
static constexpr int MaxExponent = 32;

static Value *createSignedPower(IRBuilderBase &Builder, Value &Base,
                                int Exponent) {
  Constant *One = ConstantFP::get(Base.getType(), 1.0);
  if (Exponent == 0)
    return One;
  Value *Power = createPower(Builder, Base, std::abs(Exponent));
  return Exponent < 0 ? Builder.CreateFDiv(One, Power) : Power;
}

// pow(-0, 0.5) is 0 and pow(-inf, 0.5) is inf.
static Value *createHalfPower(IRBuilderBase &Builder, Value &Base,
                              FastMathFlags Given) {
  Value *Root = Builder.CreateUnaryIntrinsic(Intrinsic::sqrt, &Base);
  if (!Given.noSignedZeros())
    Root = Builder.CreateUnaryIntrinsic(Intrinsic::fabs, Root);
  if (Given.noInfs())
    return Root;
  Value *IsInfinite = Builder.CreateFCmpOEQ(
      &Base, ConstantFP::getInfinity(Base.getType(), /*Negative=*/true));
  return Builder.CreateSelect(IsInfinite,
                              ConstantFP::getInfinity(Base.getType()), Root);
}

// Null where the library has to compute the power.
static Value *createPower(IRBuilderBase &Builder, Value &Base, double Exponent,
                          FastMathFlags Given) {
  // These are as exact as the library's function, or more so.
  if (Exponent == 0 || Exponent == 1 || Exponent == 2 || Exponent == -1)
    return createSignedPower(Builder, Base, int(Exponent));
  if (Exponent == 0.5)
    return createHalfPower(Builder, Base, Given);
  if (!Given.approxFunc() || std::fabs(Exponent) > MaxExponent)
    return nullptr;
  double Whole = std::trunc(Exponent);
  double Fraction = std::fabs(Exponent - Whole);
  if (Fraction == 0)
    return createSignedPower(Builder, Base, int(Whole));
  if (Fraction != 0.5 || !Given.noInfs())
    return nullptr;
  Value *Power = createHalfPower(Builder, Base, Given);
  if (Whole != 0)
    Power = Builder.CreateFMul(
        createPower(Builder, Base, unsigned(std::fabs(Whole))), Power);
  return Exponent > 0
             ? Power
             : Builder.CreateFDiv(ConstantFP::get(Base.getType(), 1.0), Power);
}

static void expandPower(CallInst &Call) {
  IRBuilder<> Builder(&Call);
  Builder.setFastMathFlags(getRewriteFlags(Call));
  Value &Base = *Call.getArgOperand(0);
  Value *Exponent = Call.getArgOperand(1);
  Value *Expanded = nullptr;
  const APFloat *Real;
  const APInt *Integer;
  if (match(Exponent, m_APFloat(Real)))
    Expanded = createPower(Builder, Base, Real->convertToDouble(),
                           Call.getFastMathFlags());
  else if (match(Exponent, m_APInt(Integer)) && Integer->abs().ule(MaxExponent))
    // As the library's __powisf2 computes it.
    Expanded = createSignedPower(Builder, Base, int(Integer->getSExtValue()));
  if (Expanded)
    replaceExpression(Call, *Expanded);
}

void llvm::expandPowers(Function &F) {
  forEachInstruction(F, [](Instruction &I) {
    auto *Call = dyn_cast<CallInst>(&I);
    if (!Call)
      return;
    MathFunction Function = getMathFunction(*Call);
    if (Function == MathFunction::Power ||
        Function == MathFunction::IntegerPower)
      expandPower(*Call);
  });
}
