//===- MathWrappers.cpp - std::sqrt and its like --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Expressions.h"
#include "llvm-backend/FloatingPoint/Canonicalize/MathFunctions.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/SmallPtrSet.h"
#include "llvm/Analysis/ConstantFolding.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/Transforms/Utils/Local.h"

using namespace llvm;

static bool isForwardedFunction(const CallBase &Call) {
  switch (getMathFunction(Call)) {
  case MathFunction::SquareRoot:
  case MathFunction::Power:
  case MathFunction::IntegerPower:
  case MathFunction::Minimum:
  case MathFunction::Maximum:
    return true;
  case MathFunction::None:
  case MathFunction::Approximate:
    return false;
  }
  return false;
}

namespace {

/// Follows the arguments of a call through its callee: through variables that
/// are stored and loaded, and through conversions.
class Forwarding {
public:
  /// \param Flags those of the call; an invoke cannot carry any and hands over
  /// all.
  Forwarding(CallBase &Site, FastMathFlags Flags) : Site(Site), Flags(Flags) {}

  /// Whether the callee does nothing but compute one math function, or another
  /// such callee, of its converted arguments.
  static bool isPossible(const CallBase &Site, unsigned Depth = 0);

  /// Computes the callee's result before the call.
  Value *create();

private:
  Value *get(Value &InCallee) const;
  Value *recreate(IRBuilderBase &Builder, Instruction &I);

  /// Callees deeper than that are not followed.
  static constexpr unsigned MaxDepth = 4;

  CallBase &Site;
  FastMathFlags Flags;
  DenseMap<const Value *, Value *> AtSite;
};

} // namespace

static bool isMarker(const Instruction &I) {
  return I.isDebugOrPseudoInst() || isa<LifetimeIntrinsic>(I);
}

// Whether \p I only moves or converts values.
static bool isPlumbing(const Instruction &I) {
  if (const auto *Load = dyn_cast<LoadInst>(&I))
    return Load->isSimple() && isa<AllocaInst>(Load->getPointerOperand());
  if (const auto *Store = dyn_cast<StoreInst>(&I))
    return Store->isSimple() && isa<AllocaInst>(Store->getPointerOperand());
  return isa<AllocaInst, FPExtInst, FPTruncInst, SIToFPInst, UIToFPInst,
             ReturnInst>(I) ||
         isMarker(I);
}

static const Function *getForwarder(const CallBase &Site) {
  const Function *Callee = Site.getCalledFunction();
  if (!isa<CallInst, InvokeInst>(Site) || Site.isMustTailCall() || !Callee ||
      Callee->isDeclaration() || Callee->isInterposable() ||
      Callee->isVarArg() || Callee->size() != 1 ||
      Callee->hasFnAttribute(Attribute::StrictFP) ||
      Callee == Site.getFunction() || !isRewrittenType(*Site.getType()))
    return nullptr;
  return Callee;
}

// Whether each operand of \p I is a constant or in \p Known; a variable is
// known once something is stored there.
static bool hasKnownOperands(const Instruction &I,
                             SmallPtrSetImpl<const Value *> &Known) {
  auto IsKnown = [&](const Value *V) {
    return isa<Constant>(V) || Known.contains(V);
  };
  if (const auto *Store = dyn_cast<StoreInst>(&I)) {
    Known.insert(Store->getPointerOperand());
    return IsKnown(Store->getValueOperand());
  }
  return isa<AllocaInst>(I) || isMarker(I) ||
         all_of(I.operand_values(), IsKnown);
}

bool Forwarding::isPossible(const CallBase &Site, unsigned Depth) {
  const Function *Callee = getForwarder(Site);
  if (!Callee || Depth == MaxDepth)
    return false;
  SmallPtrSet<const Value *, 8> Known;
  for (const Argument &Parameter : Callee->args())
    Known.insert(&Parameter);
  unsigned Calls = 0;
  for (const Instruction &I : Callee->front()) {
    if (!hasKnownOperands(I, Known))
      return false;
    if (!isa<AllocaInst>(I))
      Known.insert(&I);
    if (isPlumbing(I))
      continue;
    const auto *Inner = dyn_cast<CallInst>(&I);
    if (!Inner || ++Calls > 1 ||
        !(isForwardedFunction(*Inner) || isPossible(*Inner, Depth + 1)))
      return false;
  }
  return Calls == 1;
}

Value *Forwarding::get(Value &InCallee) const {
  return isa<Constant>(InCallee) ? &InCallee : AtSite.lookup(&InCallee);
}

Value *Forwarding::recreate(IRBuilderBase &Builder, Instruction &I) {
  if (isa<AllocaInst>(I) || isMarker(I))
    return nullptr;
  if (auto *Store = dyn_cast<StoreInst>(&I)) {
    AtSite[Store->getPointerOperand()] = get(*Store->getValueOperand());
    return nullptr;
  }
  if (auto *Load = dyn_cast<LoadInst>(&I))
    return get(*Load->getPointerOperand());
  Instruction *Copy = I.clone();
  for (Use &Operand : Copy->operands())
    if (!isa<Function>(Operand))
      Operand = get(*Operand);
  if (Constant *Folded =
          ConstantFoldInstruction(Copy, Site.getFunction()->getDataLayout());
      Folded && Copy->isCast()) {
    Copy->deleteValue();
    return Folded;
  }
  Copy->setDebugLoc(Site.getDebugLoc());
  return Builder.Insert(Copy);
}

Value *Forwarding::create() {
  Function &Callee = *Site.getCalledFunction();
  for (auto [Parameter, Argument] : zip(Callee.args(), Site.args()))
    AtSite[&Parameter] = Argument;
  IRBuilder<> Builder(&Site);
  for (Instruction &I : Callee.front()) {
    if (auto *Return = dyn_cast<ReturnInst>(&I))
      return get(*Return->getReturnValue());
    Value *Copy = recreate(Builder, I);
    AtSite[&I] = Copy;
    if (auto *Call = dyn_cast_or_null<CallInst>(Copy)) {
      Call->copyFastMathFlags(Call->getFastMathFlags() & Flags);
      if (isPossible(*Call)) {
        AtSite[&I] = Forwarding(*Call, Call->getFastMathFlags()).create();
        Call->eraseFromParent();
      }
    }
  }
  llvm_unreachable("one block that ends with a return");
}

void llvm::forwardMathWrappers(Function &F) {
  forEachInstruction(F, [](Instruction &I) {
    auto *Call = dyn_cast<CallBase>(&I);
    if (!Call || !Forwarding::isPossible(*Call))
      return;
    FastMathFlags Flags = FastMathFlags::getFast();
    if (auto *Invoke = dyn_cast<InvokeInst>(Call))
      Call = changeToCall(Invoke);
    else
      Flags = Call->getFastMathFlags();
    Value *Result = Forwarding(*Call, Flags).create();
    Call->replaceAllUsesWith(Result);
    Call->eraseFromParent();
  });
}
