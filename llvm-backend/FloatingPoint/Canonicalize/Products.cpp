//===- Products.cpp - Products of several factors -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Expressions.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstrTypes.h"

using namespace llvm;

static bool isProduct(const Instruction &I) {
  return I.getOpcode() == Instruction::FMul && I.hasAllowReassoc();
}

static bool isReciprocal(const Instruction &I) {
  return I.getOpcode() == Instruction::FDiv && I.hasAllowReassoc() &&
         I.hasAllowReciprocal() && isOne(*I.getOperand(0));
}

static bool isNegation(const Instruction &I) {
  return I.getOpcode() == Instruction::FNeg;
}

static bool isChainLink(const Instruction &I) {
  return isProduct(I) || isReciprocal(I);
}

namespace {

/// A factor and how often it occurs.
struct Factor {
  Value *Base;
  unsigned Exponent;
};

using Factors = SmallVector<Factor, 8>;

/// A product with all that its expression multiplies and divides by.
class ProductChain {
public:
  explicit ProductChain(Instruction &Root)
      : Root(Root), Flags(getRewriteFlags(Root)) {
    collect(Root, /*Inverse=*/false);
  }

  /// Whether another order saves an operation.
  bool isWorthRebuilding() const;

  /// Computes the product before the root; null where the product of its
  /// constants is not normal.
  Value *rebuild();

private:
  void collect(Value &V, bool Inverse);
  bool collectOperands(Instruction &I, bool Inverse);
  bool mergeConstants(Constant *&Merged) const;

  Instruction &Root;
  FastMathFlags Flags;
  Factors Numerator, Denominator;
  SmallVector<Constant *, 4> Multipliers, Divisors;
  unsigned Links = 0;
  unsigned Reciprocals = 0;
  unsigned Negations = 0;
};

} // namespace

static void addFactor(Factors &To, Value &Base) {
  for (Factor &Known : To)
    if (isSameValue(Known.Base, &Base)) {
      ++Known.Exponent;
      return;
    }
  To.push_back({&Base, 1});
}

bool ProductChain::collectOperands(Instruction &I, bool Inverse) {
  if (isNegation(I)) {
    ++Negations;
    collect(*I.getOperand(0), Inverse);
    return true;
  }
  if (!isChainLink(I))
    return false;
  ++Links;
  Flags &= I.getFastMathFlags();
  if (isReciprocal(I)) {
    ++Reciprocals;
    collect(*I.getOperand(1), !Inverse);
    return true;
  }
  collect(*I.getOperand(0), Inverse);
  collect(*I.getOperand(1), Inverse);
  return true;
}

void ProductChain::collect(Value &V, bool Inverse) {
  if (&V == &Root || isPartOf(V, Root))
    if (collectOperands(*cast<Instruction>(&V), Inverse))
      return;
  if (auto *Literal = dyn_cast<Constant>(&V);
      Literal && isNormalConstant(*Literal))
    (Inverse ? Divisors : Multipliers).push_back(Literal);
  else
    addFactor(Inverse ? Denominator : Numerator, V);
}

static bool hasPower(const Factors &Product) {
  return any_of(Product, [](const Factor &F) { return F.Exponent > 1; });
}

bool ProductChain::isWorthRebuilding() const {
  return Links > 1 &&
         (hasPower(Numerator) || hasPower(Denominator) || Negations > 1 ||
          Multipliers.size() + Divisors.size() > 1 || !Divisors.empty() ||
          Reciprocals > 1 || (!Multipliers.empty() && !Denominator.empty()));
}

bool ProductChain::mergeConstants(Constant *&Merged) const {
  Merged = nullptr;
  if (Multipliers.empty() && Divisors.empty())
    return true;
  Merged = ConstantFP::get(Root.getType(), 1.0);
  for (Constant *Multiplier : Multipliers)
    if (Merged)
      Merged = multiplyConstants(*Merged, *Multiplier);
  Constant *Divisor = ConstantFP::get(Root.getType(), 1.0);
  for (Constant *Next : Divisors)
    if (Divisor)
      Divisor = multiplyConstants(*Divisor, *Next);
  if (Merged && Divisor)
    Merged = divideConstants(*Merged, *Divisor);
  return Merged && Divisor;
}

static Value *multiply(IRBuilderBase &Builder, Value *Product, Value &Next) {
  return Product ? Builder.CreateFMul(Product, &Next) : &Next;
}

static Value *createProduct(IRBuilderBase &Builder, const Factors &Of) {
  Value *Product = nullptr;
  for (const Factor &Next : Of)
    Product = multiply(Builder, Product,
                       *createPower(Builder, *Next.Base, Next.Exponent));
  return Product;
}

Value *ProductChain::rebuild() {
  Constant *Literal;
  if (!mergeConstants(Literal))
    return nullptr;
  IRBuilder<> Builder(&Root);
  Builder.setFastMathFlags(Flags);
  Value *Product = createProduct(Builder, Numerator);
  // The literal goes with the reciprocal: in loops, divisors often stay.
  Value *Scale = Literal && !isOne(*Literal) ? Literal : nullptr;
  if (!Denominator.empty()) {
    Value *Reciprocal = Builder.CreateFDiv(ConstantFP::get(Root.getType(), 1.0),
                                           createProduct(Builder, Denominator));
    Scale = multiply(Builder, Scale, *Reciprocal);
  }
  if (Scale)
    Product = multiply(Builder, Product, *Scale);
  if (!Product)
    return nullptr;
  return Negations % 2 ? Builder.CreateFNeg(Product) : Product;
}

// Whether the chain of a user takes \p I in.
static bool isInner(const Instruction &I) {
  const Instruction *Link = &I;
  do {
    if (!Link->hasOneUse())
      return false;
    const auto *User = dyn_cast<Instruction>(Link->user_back());
    if (!User || User->getParent() != I.getParent())
      return false;
    Link = User;
  } while (isNegation(*Link));
  return isChainLink(*Link);
}

void llvm::rebuildProducts(Function &F) {
  forEachInstruction(F, [](Instruction &I) {
    if (!isRewrittenType(*I.getType()) || !isChainLink(I) || isInner(I))
      return;
    ProductChain Chain(I);
    if (!Chain.isWorthRebuilding())
      return;
    if (Value *Product = Chain.rebuild())
      replaceExpression(I, *Product);
  });
}
