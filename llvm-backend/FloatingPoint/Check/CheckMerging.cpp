//===- CheckMerging.cpp - Fewer branches for the checks -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckMerging.h"
#include "llvm-backend/FloatingPoint/Check/CheckEmitter.h"
#include "llvm-backend/FloatingPoint/Check/CheckPass.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/MDBuilder.h"
#include "llvm/IR/PatternMatch.h"
#include <optional>

using namespace llvm;

/// The values of all merged checks' reports are alive until the branch: more of
/// them need more registers than there are.
static constexpr unsigned MostChecks = 16;

namespace {

/// A block's end in a check.
struct Check {
  Value *Condition;
  /// Whether the check has failed if the condition is true.
  bool FailsIfTrue;
  BasicBlock *Report;
  BasicBlock *Rest;
  /// Once it has been merged: the block that leads to the report.
  BasicBlock *Search = nullptr;
};

/// Consecutive checks, of which all but the first have lost their blocks.
class CheckGroup {
public:
  CheckGroup(BasicBlock &Head, const Check &First)
      : Head(Head), Checks{First} {}

  bool takeNext();
  void branch();

private:
  void detachLast();

  BasicBlock &Head;
  SmallVector<Check, MostChecks> Checks;
};

} // namespace

static std::optional<Check> findCheck(const BasicBlock &Block) {
  auto *Branch = dyn_cast<BranchInst>(Block.getTerminator());
  if (!Branch || !Branch->isConditional())
    return std::nullopt;
  for (unsigned Failed : {0, 1}) {
    BasicBlock *Report = Branch->getSuccessor(Failed);
    if (findReport(*Report))
      return Check{Branch->getCondition(), Failed == 0, Report,
                   Branch->getSuccessor(1 - Failed)};
  }
  return std::nullopt;
}

/// Whether it does not matter that an instruction is executed although a check
/// before it has failed. A load from an address that it would not have without
/// the failure is impossible: see the class's comment.
static bool isHarmless(const Instruction &I) {
  if (auto *Load = dyn_cast<LoadInst>(&I))
    return Load->isSimple();
  return isSafeToSpeculativelyExecute(&I) && !I.mayHaveSideEffects();
}

static bool isHarmless(const BasicBlock &Block) {
  return all_of(Block, [&](const Instruction &I) {
    return I.isTerminator() || (!isa<PHINode>(I) && isHarmless(I));
  });
}

/// Prepares the last check for the loss of its branch. Unrolled loops share
/// their reports, so that it matters where one comes from.
void CheckGroup::detachLast() {
  Check &Last = Checks.back();
  Last.Search = BasicBlock::Create(Head.getContext(), "", Head.getParent());
  Last.Report->replacePhiUsesWith(&Head, Last.Search);
}

bool CheckGroup::takeNext() {
  const Check &Last = Checks.back();
  BasicBlock *Next = Last.Rest;
  if (Checks.size() == MostChecks || Next == &Head ||
      findReport(*Last.Report)->Kind == tp::CheckKind::Conversion ||
      Next->getSinglePredecessor() != &Head || !isHarmless(*Next))
    return false;
  std::optional<Check> NextCheck = findCheck(*Next);
  if (!NextCheck || NextCheck->Rest == Next)
    return false;
  detachLast();
  Checks.push_back(*NextCheck);
  // Until branch() the block ends in the last check.
  Next->replaceSuccessorsPhiUsesWith(&Head);
  Head.getTerminator()->eraseFromParent();
  Head.splice(Head.end(), Next);
  Next->eraseFromParent();
  return true;
}

/// Computes a condition anew, from values that the report needs anyway.
static Value *recompute(Value *V, IRBuilderBase &Builder,
                        const BasicBlock &From) {
  auto *I = dyn_cast<Instruction>(V);
  if (!I || I->getParent() != &From)
    return V;
  if (!isa<BitCastInst, ICmpInst, SelectInst>(I) && !I->isBitwiseLogicOp() &&
      !match(I, PatternMatch::m_FAbs(PatternMatch::m_Value())))
    return V;
  Instruction *Copy = I->clone();
  for (Use &Operand : Copy->operands())
    Operand.set(recompute(Operand, Builder, From));
  return Builder.Insert(Copy);
}

/// Whether \p Each has failed, as an integer.
static Value *failureBit(IRBuilderBase &Builder, const Check &Each) {
  Value *Failed =
      Each.FailsIfTrue ? Each.Condition : Builder.CreateNot(Each.Condition);
  return Builder.CreateZExt(Failed, Builder.getInt32Ty());
}

void CheckGroup::branch() {
  if (Checks.size() == 1)
    return;
  detachLast();
  Instruction *LastBranch = Head.getTerminator();
  IRBuilder<> Builder(LastBranch);
  // As a word: a branch on `or` of conditions would come apart again.
  Value *Any = failureBit(Builder, Checks.front());
  for (const Check &Each : drop_begin(Checks))
    Any = Builder.CreateOr(Any, failureBit(Builder, Each));
  Builder.CreateCondBr(
      Builder.CreateIsNotNull(Any), Checks.front().Search, Checks.back().Rest,
      MDBuilder(Head.getContext()).createUnlikelyBranchWeights());

  for (auto [Each, Next] : zip(Checks, drop_begin(Checks))) {
    Builder.SetInsertPoint(Each.Search);
    Value *Condition = recompute(Each.Condition, Builder, Head);
    if (Each.FailsIfTrue)
      Builder.CreateCondBr(Condition, Each.Report, Next.Search);
    else
      Builder.CreateCondBr(Condition, Next.Search, Each.Report);
  }
  Builder.SetInsertPoint(Checks.back().Search);
  Builder.CreateBr(Checks.back().Report);
  LastBranch->eraseFromParent();
}

PreservedAnalyses
FloatingPointCheckMergingPass::run(Function &F, FunctionAnalysisManager &) {
  if (!F.hasFnAttribute(CheckedFunctionAttribute))
    return PreservedAnalyses::all();
  SmallVector<WeakVH> Blocks(make_pointer_range(F));
  for (const WeakVH &Block : Blocks) {
    auto *Head = cast_or_null<BasicBlock>(Block);
    if (!Head)
      continue;
    // The rest of a group that has become too large begins the next one.
    if (std::optional<Check> First = findCheck(*Head)) {
      CheckGroup Group(*Head, *First);
      while (Group.takeNext())
        ;
      Group.branch();
    }
  }
  return PreservedAnalyses::none();
}
