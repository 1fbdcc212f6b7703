//===- Sums.cpp - Sums of products ----------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Expressions.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Reductions.h"
#include "llvm-backend/FloatingPoint/FloatingPointTarget.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/PatternMatch.h"

using namespace llvm;
using namespace PatternMatch;

static bool isSum(const Value &V) {
  return match(&V, m_FAdd(m_Value(), m_Value())) ||
         match(&V, m_FSub(m_Value(), m_Value()));
}

//===----------------------------------------------------------------------===//
// llvm.fmuladd
//===----------------------------------------------------------------------===//

static void splitMultiplyAdd(IntrinsicInst &MultiplyAdd) {
  IRBuilder<> Builder(&MultiplyAdd);
  FastMathFlags Flags = getRewriteFlags(MultiplyAdd);
  Flags.setAllowContract();
  Builder.setFastMathFlags(Flags);
  Value *A = MultiplyAdd.getArgOperand(0);
  Value *B = MultiplyAdd.getArgOperand(1);
  Value *C = MultiplyAdd.getArgOperand(2);
  Value *Subtracted, *Negated;
  Value *Sum;
  // Clang negates for c - a * b and for a * b - c.
  if (match(A, m_FNeg(m_Value(Negated))))
    Sum = Builder.CreateFSub(C, Builder.CreateFMul(Negated, B));
  else if (match(C, m_FNeg(m_Value(Subtracted))))
    Sum = Builder.CreateFSub(Builder.CreateFMul(A, B), Subtracted);
  else
    Sum = Builder.CreateFAdd(Builder.CreateFMul(A, B), C);
  replaceExpression(MultiplyAdd, *Sum);
}

void llvm::splitMultiplyAdds(Function &F) {
  forEachInstruction(F, [](Instruction &I) {
    if (auto *Intrinsic = dyn_cast<IntrinsicInst>(&I);
        Intrinsic && Intrinsic->getIntrinsicID() == Intrinsic::fmuladd)
      splitMultiplyAdd(*Intrinsic);
  });
}

//===----------------------------------------------------------------------===//
// a * k + b * k
//===----------------------------------------------------------------------===//

static bool isAssociative(const Instruction &I) {
  return I.hasAllowReassoc() && I.hasNoSignedZeros();
}

static Instruction *matchAssociativeProduct(Value &V, const Instruction &Sum) {
  auto *Product = dyn_cast<Instruction>(&V);
  if (!Product || Product->getOpcode() != Instruction::FMul ||
      !isAssociative(*Product) || !isPartOf(V, Sum))
    return nullptr;
  return Product;
}

static Value *createFactoredSum(Instruction &Sum, Value *A, Value *B,
                                Value *Common, FastMathFlags Flags) {
  IRBuilder<> Builder(&Sum);
  Builder.setFastMathFlags(Flags);
  Value *Inner = Sum.getOpcode() == Instruction::FAdd
                     ? Builder.CreateFAdd(A, B)
                     : Builder.CreateFSub(A, B);
  return Builder.CreateFMul(Inner, Common);
}

static void factorSum(Instruction &Sum) {
  Instruction *Left = matchAssociativeProduct(*Sum.getOperand(0), Sum);
  Instruction *Right = matchAssociativeProduct(*Sum.getOperand(1), Sum);
  if (!Left || !Right)
    return;
  FastMathFlags Flags =
      getRewriteFlags(Sum) & getRewriteFlags(*Left) & getRewriteFlags(*Right);
  for (unsigned L : {0, 1})
    for (unsigned R : {0, 1}) {
      Value *Common = Left->getOperand(L);
      if (!isSameValue(Common, Right->getOperand(R)))
        continue;
      replaceExpression(Sum, *createFactoredSum(Sum, Left->getOperand(1 - L),
                                                Right->getOperand(1 - R),
                                                Common, Flags));
      return;
    }
}

void llvm::factorSums(Function &F) {
  forEachInstruction(F, [](Instruction &I) {
    if (isSum(I) && isAssociative(I) && isRewrittenType(*I.getType()))
      factorSum(I);
  });
}

//===----------------------------------------------------------------------===//
// Contraction
//===----------------------------------------------------------------------===//

// What was last stored in the variable that \p V loads, if the same block
// stores it or nothing else does.
static Value *getVariableValue(Value &V) {
  auto *Load = dyn_cast<LoadInst>(&V);
  if (!Load || !isa<AllocaInst>(Load->getPointerOperand()))
    return nullptr;
  const Value *Variable = Load->getPointerOperand();
  for (Instruction *I = Load->getPrevNode(); I; I = I->getPrevNode())
    if (auto *Store = dyn_cast<StoreInst>(I);
        Store && Store->getPointerOperand() == Variable)
      return Store->getValueOperand();
  Value *Stored = nullptr;
  for (User *User : Load->getPointerOperand()->users())
    if (auto *Store = dyn_cast<StoreInst>(User);
        Store && Store->getPointerOperand() == Variable) {
      if (Stored)
        return nullptr;
      Stored = Store->getValueOperand();
    }
  return Stored;
}

namespace {

/// The products in a sum: positive and negative ones.
struct ProductSigns {
  bool Positive = false;
  bool Negative = false;

  void add(bool IsNegative) { (IsNegative ? Negative : Positive) = true; }
  bool isMixed() const { return Positive && Negative; }
};

} // namespace

// Whether the sign of \p V as written is a minus; looks through factors.
static bool isNegativeFactor(const Value &V) {
  const APFloat *Literal;
  Value *A, *B;
  if (match(&V, m_APFloat(Literal)))
    return Literal->isNegative();
  if (match(&V, m_FNeg(m_Value(A))))
    return !isNegativeFactor(*A);
  if (match(&V, m_FMul(m_Value(A), m_Value(B))))
    return isNegativeFactor(*A) != isNegativeFactor(*B);
  return false;
}

static void addProducts(Value &V, bool IsNegative, const Instruction &Root,
                        ProductSigns &Signs) {
  Value *A, *B;
  if (match(&V, m_FNeg(m_Value(A))))
    return addProducts(*A, !IsNegative, Root, Signs);
  if (match(&V, m_FMul(m_Value(), m_Value())))
    return Signs.add(IsNegative != isNegativeFactor(V));
  if (Value *Stored = getVariableValue(V);
      Stored && match(Stored, m_FMul(m_Value(), m_Value())))
    return Signs.add(IsNegative != isNegativeFactor(*Stored));
  if (&V != &Root && !isPartOf(V, Root))
    return;
  if (match(&V, m_FAdd(m_Value(A), m_Value(B)))) {
    addProducts(*A, IsNegative, Root, Signs);
    addProducts(*B, IsNegative, Root, Signs);
  } else if (match(&V, m_FSub(m_Value(A), m_Value(B)))) {
    addProducts(*A, IsNegative, Root, Signs);
    addProducts(*B, !IsNegative, Root, Signs);
  }
}

static Instruction *matchContractableProduct(Value &V, const Instruction &Sum) {
  auto *Product = dyn_cast<Instruction>(&V);
  if (!Product || Product->getOpcode() != Instruction::FMul ||
      !Product->hasAllowContract() || !isPartOf(V, Sum))
    return nullptr;
  return Product;
}

static Instruction *createFused(IRBuilderBase &Builder, Value *A, Value *B,
                                Value *C) {
  return Builder.CreateIntrinsic(Intrinsic::fma, {A->getType()}, {A, B, C});
}

static Instruction *createFusedSum(Instruction &Sum) {
  Value *Left = Sum.getOperand(0), *Right = Sum.getOperand(1);
  bool IsDifference = Sum.getOpcode() == Instruction::FSub;
  IRBuilder<> Builder(&Sum);
  if (const Instruction *Product = matchContractableProduct(*Right, Sum)) {
    Value *A = Product->getOperand(0);
    return createFused(Builder, IsDifference ? Builder.CreateFNeg(A) : A,
                       Product->getOperand(1), Left);
  }
  if (const Instruction *Product = matchContractableProduct(*Left, Sum))
    return createFused(Builder, Product->getOperand(0), Product->getOperand(1),
                       IsDifference ? Builder.CreateFNeg(Right) : Right);
  return nullptr;
}

static void contractSum(Instruction &Sum) {
  Instruction *Fused = createFusedSum(Sum);
  if (!Fused)
    return;
  copyReductionMark(Sum, *Fused);
  replaceExpression(Sum, *Fused);
}

// The sum whose terms \p I adds to, through other sums.
static Instruction &getWholeSum(Instruction &I) {
  Instruction *Whole = &I;
  Instruction *Next = &I;
  while (Next->hasOneUse()) {
    auto *User = dyn_cast<Instruction>(Next->user_back());
    if (!User || User->getParent() != I.getParent())
      break;
    if (isSum(*User))
      Whole = User;
    else if (User->getOpcode() != Instruction::FNeg)
      break;
    Next = User;
  }
  return *Whole;
}

// Whether the terms of \p Whole are products of both signs.
static bool isMixed(Instruction &Whole) {
  ProductSigns Signs;
  addProducts(Whole, /*IsNegative=*/false, Whole, Signs);
  return Signs.isMixed();
}

void llvm::contractSums(Function &F, const FloatingPointTarget &Target) {
  SmallVector<Instruction *, 32> Sums;
  DenseMap<const Instruction *, bool> IsMixed;
  // All are judged before any is rewritten.
  forEachInstruction(F, [&](Instruction &I) {
    if (!isSum(I) || !I.hasAllowContract() ||
        !Target.hasFusedMultiplyAdd(*I.getType()))
      return;
    Instruction &Whole = getWholeSum(I);
    auto [Known, IsNew] = IsMixed.try_emplace(&Whole);
    if (IsNew)
      Known->second = isMixed(Whole);
    if (!Known->second)
      Sums.push_back(&I);
  });
  for (Instruction *Sum : Sums)
    contractSum(*Sum);
}
