//===- Reductions.cpp - Sums of loops in several lanes --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/Reductions.h"
#include "llvm/Analysis/AssumptionCache.h"
#include "llvm/Analysis/InstructionSimplify.h"
#include "llvm/Analysis/LoopInfo.h"
#include "llvm/Analysis/OptimizationRemarkEmitter.h"
#include "llvm/Analysis/ScalarEvolution.h"
#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/Transforms/Scalar/EarlyCSE.h"
#include "llvm/Transforms/Scalar/SROA.h"
#include "llvm/Transforms/Scalar/SimplifyCFG.h"
#include "llvm/Transforms/Utils/LoopRotationUtils.h"
#include "llvm/Transforms/Utils/LoopSimplify.h"
#include "llvm/Transforms/Utils/LoopUtils.h"
#include "llvm/Transforms/Utils/UnrollLoop.h"

using namespace llvm;

/// Larger loops gain nothing from lanes.
static constexpr unsigned MaxLoopSize = 64;
/// The default of loop rotation.
static constexpr unsigned MaxHeaderSize = 16;

static bool isMarked(const Value &V) {
  const auto *I = dyn_cast<Instruction>(&V);
  return I && I->hasMetadata(ReductionMark);
}

//===----------------------------------------------------------------------===//
// Chains of additions
//===----------------------------------------------------------------------===//

namespace {

/// The additions to one variable in a loop of one block, in their order.
class AccumulationChain {
public:
  /// Follows \p Sum through the block of \p L.
  AccumulationChain(PHINode &Sum, const Loop &L);

  /// Whether the additions are all there is, and nothing else reads a sum.
  bool isComplete() const { return IsComplete; }

  /// Divides the additions among \p Lanes sums.
  void split(unsigned Lanes);

private:
  Use &getSumOperand(unsigned Index) const;
  PHINode *createLane(unsigned Lane);
  Value *addLanes(IRBuilderBase &Builder, SmallVector<Value *> Sums) const;

  PHINode &Sum;
  const Loop &L;
  SmallVector<Instruction *, 16> Additions;
  bool IsComplete = false;
};

} // namespace

// The only instruction of \p Block that uses \p V, apart from its phis.
static Instruction *getOnlyUser(const Value &V, const BasicBlock &Block) {
  Instruction *Only = nullptr;
  for (const Use &Operand : V.uses()) {
    auto *User = cast<Instruction>(Operand.getUser());
    if (User->getParent() != &Block || isa<PHINode>(User))
      continue;
    if (Only)
      return nullptr;
    Only = User;
  }
  return Only;
}

AccumulationChain::AccumulationChain(PHINode &Sum, const Loop &L)
    : Sum(Sum), L(L) {
  const BasicBlock &Block = *L.getHeader();
  const Value *Last = Sum.getIncomingValueForBlock(&Block);
  for (const Value *V = &Sum; !IsComplete;) {
    Instruction *Next = getOnlyUser(*V, Block);
    if (!Next || !isMarked(*Next))
      return;
    Additions.push_back(Next);
    IsComplete = Next == Last;
    V = Next;
  }
  // The last sum is read behind the loop only.
  IsComplete &= !getOnlyUser(*Last, Block);
}

Use &AccumulationChain::getSumOperand(unsigned Index) const {
  const Value *Before = Index ? cast<Value>(Additions[Index - 1]) : &Sum;
  for (Use &Operand : Additions[Index]->operands())
    if (Operand == Before)
      return Operand;
  llvm_unreachable("an addition uses the sum before it");
}

PHINode *AccumulationChain::createLane(unsigned Lane) {
  if (Lane == 0)
    return &Sum;
  PHINode *Result = PHINode::Create(Sum.getType(), 2, "lane");
  Result->insertBefore(L.getHeader()->getFirstNonPHIIt());
  Result->addIncoming(ConstantFP::getNegativeZero(Sum.getType()),
                      L.getLoopPreheader());
  Result->addIncoming(&Sum, L.getHeader());
  return Result;
}

// Halves the list until one sum is left.
Value *AccumulationChain::addLanes(IRBuilderBase &Builder,
                                   SmallVector<Value *> Sums) const {
  while (Sums.size() > 1) {
    unsigned Half = Sums.size() / 2;
    for (unsigned Lane = 0; Lane != Half; ++Lane)
      Sums[Lane] = Builder.CreateFAdd(Sums[Lane], Sums[Lane + Half]);
    Sums.truncate(Half);
  }
  return Sums.front();
}

void AccumulationChain::split(unsigned Lanes) {
  SmallVector<Use *, 16> Before;
  for (unsigned Index = 0; Index != Additions.size(); ++Index)
    Before.push_back(&getSumOperand(Index));

  SmallVector<PHINode *, 8> LanePhis;
  for (unsigned Lane = 0; Lane != Lanes; ++Lane)
    LanePhis.push_back(createLane(Lane));
  for (unsigned Index = 0; Index != Additions.size(); ++Index)
    Before[Index]->set(Index < Lanes ? cast<Value>(LanePhis[Index])
                                     : Additions[Index - Lanes]);

  Instruction *Last = Additions.back();
  BasicBlock *Exit = L.getExitBlock();
  SmallVector<Value *> Sums;
  for (unsigned Lane = 0; Lane != Lanes; ++Lane) {
    Instruction *LaneLast = Additions[Additions.size() - Lanes + Lane];
    LanePhis[Lane]->setIncomingValueForBlock(L.getHeader(), LaneLast);
    PHINode *AtExit = PHINode::Create(Sum.getType(), 1, "lane.sum");
    AtExit->insertBefore(Exit->getFirstNonPHIIt());
    AtExit->addIncoming(LaneLast, L.getHeader());
    Sums.push_back(AtExit);
  }
  IRBuilder<> Builder(Exit, Exit->getFirstNonPHIIt());
  PHINode *LastAtExit = cast<PHINode>(Sums.back());
  Value *Total = addLanes(Builder, Sums);
  for (PHINode &Phi : make_early_inc_range(Exit->phis()))
    if (&Phi != LastAtExit && Phi.getIncomingValue(0) == Last)
      Phi.replaceAllUsesWith(Total);
}

//===----------------------------------------------------------------------===//
// Loops
//===----------------------------------------------------------------------===//

namespace {

/// The loops of one function.
class ReductionLoops {
public:
  ReductionLoops(Function &F, FunctionAnalysisManager &Analyses)
      : F(F), Loops(Analyses.getResult<LoopAnalysis>(F)),
        Evolution(Analyses.getResult<ScalarEvolutionAnalysis>(F)),
        Dominators(Analyses.getResult<DominatorTreeAnalysis>(F)),
        Assumptions(Analyses.getResult<AssumptionAnalysis>(F)),
        Target(Analyses.getResult<TargetIRAnalysis>(F)),
        Remarks(Analyses.getResult<OptimizationRemarkEmitterAnalysis>(F)) {}

  void splitAll();

private:
  void rotate(Loop &L);
  bool unroll(Loop &L, unsigned Count);
  void split(Loop &L);

  Function &F;
  LoopInfo &Loops;
  ScalarEvolution &Evolution;
  DominatorTree &Dominators;
  AssumptionCache &Assumptions;
  TargetTransformInfo &Target;
  OptimizationRemarkEmitter &Remarks;
};

} // namespace

static bool hasMark(const Loop &L) {
  return any_of(L.blocks(), [](const BasicBlock *Block) {
    return any_of(*Block, [](const Instruction &I) { return isMarked(I); });
  });
}

// Whether the body is one block that is worth several copies: short, and
// without calls that may turn out to be long.
static bool isSimpleEnough(const Loop &L) {
  if (L.getNumBlocks() != 1 || !L.getLoopPreheader() || !L.getExitBlock() ||
      L.getHeader()->size() > MaxLoopSize)
    return false;
  return none_of(*L.getHeader(), [](const Instruction &I) {
    return isa<CallBase>(I) && !isa<IntrinsicInst>(I) && I.mayWriteToMemory();
  });
}

static SmallVector<PHINode *, 4> getSums(const Loop &L) {
  SmallVector<PHINode *, 4> Sums;
  for (PHINode &Phi : L.getHeader()->phis())
    if (Phi.getType()->isFloatingPointTy() &&
        AccumulationChain(Phi, L).isComplete())
      Sums.push_back(&Phi);
  return Sums;
}

void ReductionLoops::rotate(Loop &L) {
  simplifyLoop(&L, &Dominators, &Loops, &Evolution, &Assumptions,
               /*MSSAU=*/nullptr, /*PreserveLCSSA=*/false);
  formLCSSARecursively(L, Dominators, &Loops, &Evolution);
  SimplifyQuery Query(F.getDataLayout(), &Dominators, &Assumptions);
  LoopRotation(&L, &Loops, &Target, &Assumptions, &Dominators, &Evolution,
               /*MSSAU=*/nullptr, Query, /*RotationOnly=*/false, MaxHeaderSize,
               /*IsUtilMode=*/false);
  simplifyLoop(&L, &Dominators, &Loops, &Evolution, &Assumptions,
               /*MSSAU=*/nullptr, /*PreserveLCSSA=*/true);
}

bool ReductionLoops::unroll(Loop &L, unsigned Count) {
  UnrollLoopOptions Options;
  Options.Count = Count;
  Options.Force = false;
  Options.Runtime = true;
  Options.AllowExpensiveTripCount = true;
  Options.UnrollRemainder = false;
  Options.ForgetAllSCEV = true;
  Options.SCEVExpansionBudget = UINT_MAX;
  return UnrollLoop(&L, Options, &Loops, &Evolution, &Dominators, &Assumptions,
                    &Target, &Remarks, /*PreserveLCSSA=*/true) ==
         LoopUnrollResult::PartiallyUnrolled;
}

void ReductionLoops::split(Loop &L) {
  SmallVector<PHINode *, 4> Sums;
  if (isSimpleEnough(L))
    Sums = getSums(L);
  if (Sums.empty())
    return;
  bool HasDouble = any_of(
      Sums, [](const PHINode *Sum) { return Sum->getType()->isDoubleTy(); });
  unsigned Lanes = HasDouble ? DoubleLanes : FloatLanes;
  if (!unroll(L, Lanes) || L.getNumBlocks() != 1 || !L.getExitBlock() ||
      L.getExitBlock()->getSinglePredecessor() != L.getHeader())
    return;
  for (PHINode *Sum : getSums(L))
    AccumulationChain(*Sum, L).split(Lanes);
  L.setLoopAlreadyUnrolled();
}

void ReductionLoops::splitAll() {
  SmallVector<Loop *, 8> Marked;
  for (Loop *L : Loops.getLoopsInPreorder())
    if (L->isInnermost() && hasMark(*L))
      Marked.push_back(L);
  for (Loop *L : Marked) {
    rotate(*L);
    split(*L);
  }
}

//===----------------------------------------------------------------------===//
// Functions
//===----------------------------------------------------------------------===//

namespace {

/// Takes away, for its lifetime, the attributes of a function that tell passes
/// how much to optimize.
class WithoutLevel {
public:
  explicit WithoutLevel(Function &F) : F(F) {
    for (Attribute::AttrKind Kind :
         {Attribute::OptimizeNone, Attribute::OptimizeForSize,
          Attribute::MinSize, Attribute::OptimizeForDebugging})
      if (F.hasFnAttribute(Kind)) {
        F.removeFnAttr(Kind);
        Removed.push_back(Kind);
      }
  }
  ~WithoutLevel() {
    for (Attribute::AttrKind Kind : Removed)
      F.addFnAttr(Kind);
  }

private:
  Function &F;
  SmallVector<Attribute::AttrKind, 2> Removed;
};

} // namespace

// Not by a pass manager: that would leave passes out for optnone and when a
// search for a miscompilation asks it to.
template <typename Pass>
static void runPass(Pass &&ThePass, Function &F,
                    FunctionAnalysisManager &Analyses) {
  PreservedAnalyses Preserved = ThePass.run(F, Analyses);
  Analyses.invalidate(F, Preserved);
}

void llvm::splitReductions(Function &F, FunctionAnalysisManager &Analyses) {
  {
    WithoutLevel Scope(F);
    Analyses.invalidate(F, PreservedAnalyses::none());
    runPass(SROAPass(SROAOptions::ModifyCFG), F, Analyses);
    runPass(EarlyCSEPass(), F, Analyses);
    runPass(SimplifyCFGPass(SimplifyCFGOptions().speculateBlocks(false)), F,
            Analyses);
    ReductionLoops(F, Analyses).splitAll();
    Analyses.invalidate(F, PreservedAnalyses::none());
  }
  for (Instruction &I : instructions(F))
    I.setMetadata(ReductionMark, nullptr);
}
