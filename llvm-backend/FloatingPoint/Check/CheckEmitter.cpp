//===- CheckEmitter.cpp - Code that reports a failed check ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckEmitter.h"
#include "llvm-backend/FloatingPoint/Check/CheckConditions.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/MDBuilder.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/PatternMatch.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"

using namespace llvm;
using tp::CheckFailure;
using tp::CheckKind;
using tp::CheckOperation;
using tp::CheckType;

static constexpr const char ChipFunction[] = "tp_fp_check_failed";
static constexpr const char HostFunction[] = "__tp_fp_check_failed";

CheckEmitter::CheckEmitter(Module &M)
    : M(M), IsChip(M.getTargetTriple().getArchName() ==
                   Triple(TPTriple).getArchName()) {}

static CheckType checkTypeOf(const Type &Ty) {
  if (Ty.isHalfTy())
    return CheckType::Half;
  if (Ty.isBFloatTy())
    return CheckType::BFloat;
  return Ty.isFloatTy() ? CheckType::Float : CheckType::Double;
}

static CallInst *callFailure(IRBuilderBase &Builder, FunctionCallee Callee,
                             ArrayRef<Value *> Arguments) {
  CallInst *Call = Builder.CreateCall(Callee, Arguments);
  Call->setDoesNotReturn();
  Call->setDoesNotThrow();
  Call->addFnAttr(Attribute::Cold);
  // Each report keeps its own place in the source.
  Call->addFnAttr(Attribute::NoMerge);
  return Call;
}

void CheckEmitter::reportOnChip(IRBuilderBase &Builder, uint32_t Code,
                                CheckedValues Values) {
  Type *Word = Builder.getInt32Ty();
  SmallVector<Value *, 7> Arguments{Builder.getInt32(Code)};
  SmallVector<Value *, 3> HighWords;
  for (Value *Number : {Values.Result, Values.First, Values.Second}) {
    Value *Low = PoisonValue::get(Word), *High = PoisonValue::get(Word);
    if (Number) {
      Value *Bits = floatBits(Builder, Number);
      Low = Builder.CreateZExtOrTrunc(Bits, Word);
      if (Number->getType()->isDoubleTy())
        High = Builder.CreateTrunc(Builder.CreateLShr(Bits, 32), Word);
    }
    Arguments.push_back(Low);
    HighWords.push_back(High);
  }
  append_range(Arguments, HighWords);
  SmallVector<Type *, 7> Types(Arguments.size(), Word);
  FunctionCallee Callee = M.getOrInsertFunction(
      ChipFunction,
      FunctionType::get(Builder.getVoidTy(), Types, /*isVarArg=*/false));
  callFailure(Builder, Callee, Arguments);
}

/// `in function at file:line:column`, as far as it is known.
static std::string describePlace(const Function &F, const DILocation *Place) {
  std::string Text = "in " + demangle(F.getName());
  if (Place && Place->getLine() != 0)
    Text += " at " + Place->getFilename().str() + ":" +
            std::to_string(Place->getLine()) + ":" +
            std::to_string(Place->getColumn());
  return Text;
}

void CheckEmitter::reportOnHost(IRBuilderBase &Builder, uint32_t Code,
                                CheckedValues Values) {
  Type *Long = Builder.getInt64Ty();
  SmallVector<Value *, 5> Arguments{Builder.getInt32(Code)};
  for (Value *Number : {Values.Result, Values.First, Values.Second})
    Arguments.push_back(
        Number ? Builder.CreateZExt(floatBits(Builder, Number), Long)
               : Builder.getInt64(0));
  Arguments.push_back(Builder.CreateGlobalString(
      describePlace(*Builder.GetInsertBlock()->getParent(),
                    Builder.getCurrentDebugLocation().get())));
  SmallVector<Type *, 5> Types(
      map_range(Arguments, [](Value *V) { return V->getType(); }));
  FunctionCallee Callee = M.getOrInsertFunction(
      HostFunction,
      FunctionType::get(Builder.getVoidTy(), Types, /*isVarArg=*/false));
  callFailure(Builder, Callee, Arguments);
}

void CheckEmitter::failIf(IRBuilderBase &Builder, Value *Failed, CheckKind Kind,
                          CheckOperation Operation, CheckedValues Values) {
  if (match(Failed, PatternMatch::m_Zero()))
    return;
  Value *Shown = Values.Result ? Values.Result : Values.First;
  CheckFailure Failure{Kind, checkTypeOf(*Shown->getType()), Operation};
  Instruction *Next = &*Builder.GetInsertPoint();
  DebugLoc Place = Builder.getCurrentDebugLocation();
  Instruction *Unreachable = SplitBlockAndInsertIfThen(
      Failed, Next, /*Unreachable=*/true,
      MDBuilder(M.getContext()).createUnlikelyBranchWeights());
  BasicBlock *Report = Unreachable->getParent();
  Report->moveAfter(&Report->getParent()->back());
  Report->getSinglePredecessor()->getTerminator()->setDebugLoc(Place);

  IRBuilder<> Cold(Unreachable);
  Cold.SetCurrentDebugLocation(Place);
  if (IsChip)
    reportOnChip(Cold, Failure.code(), Values);
  else
    reportOnHost(Cold, Failure.code(), Values);
  Builder.SetInsertPoint(Next);
  Builder.SetCurrentDebugLocation(Place);
}

std::optional<CheckFailure> llvm::findReport(const BasicBlock &Block) {
  if (!isa<UnreachableInst>(Block.getTerminator()))
    return std::nullopt;
  auto *Call = dyn_cast_or_null<CallInst>(Block.getTerminator()->getPrevNode());
  const Function *Callee = Call ? Call->getCalledFunction() : nullptr;
  if (!Callee ||
      (Callee->getName() != ChipFunction && Callee->getName() != HostFunction))
    return std::nullopt;
  return CheckFailure::fromCode(
      cast<ConstantInt>(Call->getArgOperand(0))->getZExtValue());
}
