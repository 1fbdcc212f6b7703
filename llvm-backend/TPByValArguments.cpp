//===- TPByValArguments.cpp - Structs passed by value ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPByValArguments.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"

using namespace llvm;

static bool hasByVal(const CallBase &Call) {
  for (unsigned Number = 0; Number != Call.arg_size(); ++Number)
    if (Call.isByValArgument(Number))
      return true;
  return false;
}

/// What `byval` promises of the callee's copy, and the backend's alignment.
static AttrBuilder getCopyAttributes(LLVMContext &Context, Type *Struct,
                                     const DataLayout &Layout) {
  AttrBuilder Attributes(Context);
  if (uint64_t Bytes = Layout.getTypeAllocSize(Struct))
    Attributes.addDereferenceableAttr(Bytes);
  Attributes.addAttribute(Attribute::NoAlias);
  Attributes.addAttribute(Attribute::DeadOnReturn);
  return Attributes;
}

/// The read and the writes of a copy were the caller's, or nobody's, affair.
static MemoryEffects withCopies(MemoryEffects Effects) {
  return Effects | MemoryEffects::argMemOnly();
}

/// The least alignment of the copy for argument \p Number.
static Align getCopyAlign(const CallBase &Call, unsigned Number) {
  return std::max(Call.getParamAlign(Number).valueOrOne(), Align(4));
}

namespace {
/// What an instruction does with an object of its function.
enum class Access { None, Write, Other };
} // namespace

/// \p Use is one of the object's address. Only the write of a whole struct of
/// \p Bytes counts as one.
static Access getAccess(const Use &Use, uint64_t Bytes) {
  const auto *User = cast<Instruction>(Use.getUser());
  if (User->isLifetimeStartOrEnd())
    return Access::None;
  if (const auto *Copy = dyn_cast<MemTransferInst>(User)) {
    const auto *Length = dyn_cast<ConstantInt>(Copy->getLength());
    return !Copy->isVolatile() && &Copy->getRawDestUse() == &Use && Length &&
                   Length->getValue().uge(Bytes)
               ? Access::Write
               : Access::Other;
  }
  const auto *Call = dyn_cast<CallInst>(User);
  if (!Call || !Call->isArgOperand(&Use))
    return Access::Other;
  const unsigned Number = Call->getArgOperandNo(&Use);
  if (!Call->paramHasAttr(Number, Attribute::StructRet))
    return Access::Other;
  const TypeSize Written = Call->getDataLayout().getTypeAllocSize(
      Call->getParamStructRetType(Number));
  return Written >= Bytes ? Access::Write : Access::Other;
}

/// Whether argument \p Number is a temporary that is made anew for each
/// execution of \p Call, and nobody else reads: then it may itself be what the
/// callee changes.
static bool isTemporaryOf(const CallInst &Call, unsigned Number) {
  const auto *Temporary = dyn_cast<AllocaInst>(Call.getArgOperand(Number));
  if (!Temporary || !Temporary->isStaticAlloca() ||
      Temporary->getAlign() < getCopyAlign(Call, Number) ||
      Call.getFunction()->callsFunctionThatReturnsTwice())
    return false;
  const uint64_t Bytes =
      Call.getDataLayout().getTypeAllocSize(Call.getParamByValType(Number));
  bool IsNew = false;
  for (const Use &Use : Temporary->uses()) {
    if (&Use == &Call.getArgOperandUse(Number))
      continue;
    const Access Kind = getAccess(Use, Bytes);
    const auto *User = cast<Instruction>(Use.getUser());
    if (Kind == Access::Other || User == &Call)
      return false;
    IsNew |= Kind == Access::Write && User->getParent() == Call.getParent() &&
             User->comesBefore(&Call);
  }
  return IsNew;
}

static Value *createCopy(CallInst &Call, unsigned Number) {
  Function &Caller = *Call.getFunction();
  const DataLayout &Layout = Caller.getDataLayout();
  Type *Struct = Call.getParamByValType(Number);
  const Align Alignment = getCopyAlign(Call, Number);

  IRBuilder<> Builder(&Caller.getEntryBlock(),
                      Caller.getEntryBlock().getFirstInsertionPt());
  AllocaInst *Copy = Builder.CreateAlloca(Struct, nullptr, "byval-copy");
  Copy->setAlignment(Alignment);

  Builder.SetInsertPoint(&Call);
  Builder.CreateLifetimeStart(Copy);
  if (uint64_t Bytes = Layout.getTypeAllocSize(Struct))
    Builder.CreateMemCpy(Copy, Alignment, Call.getArgOperand(Number),
                         Call.getParamAlign(Number), Bytes);
  if (!Call.doesNotReturn()) {
    Builder.SetInsertPoint(Call.getNextNode());
    Builder.CreateLifetimeEnd(Copy);
  }
  return Copy;
}

static void rewriteCall(CallInst &Call) {
  LLVMContext &Context = Call.getContext();
  for (unsigned Number = 0; Number != Call.arg_size(); ++Number) {
    if (!Call.isByValArgument(Number))
      continue;
    Type *Struct = Call.getParamByValType(Number);
    if (!isTemporaryOf(Call, Number))
      Call.setArgOperand(Number, createCopy(Call, Number));
    Call.removeParamAttr(Number, Attribute::ByVal);
    AttributeList List = Call.getAttributes().addParamAttributes(
        Context, Number,
        getCopyAttributes(Context, Struct, Call.getDataLayout()));
    Call.setAttributes(List);
  }
  // The caller's frame holds the copies.
  Call.setTailCallKind(CallInst::TCK_None);
  if (Call.getAttributes().hasFnAttr(Attribute::Memory))
    Call.setMemoryEffects(withCopies(Call.getAttributes().getMemoryEffects()));
}

static bool rewriteParameters(Function &F) {
  bool Changed = false;
  for (Argument &Parameter : F.args()) {
    if (!Parameter.hasByValAttr())
      continue;
    Type *Struct = Parameter.getParamByValType();
    Parameter.removeAttr(Attribute::ByVal);
    AttrBuilder Attributes =
        getCopyAttributes(F.getContext(), Struct, F.getDataLayout());
    Parameter.addAttrs(Attributes);
    Changed = true;
  }
  if (Changed && F.hasFnAttribute(Attribute::Memory))
    F.setMemoryEffects(withCopies(F.getMemoryEffects()));
  return Changed;
}

/// The functions whose parameters stay as they are: those of guaranteed tail
/// calls, which have no frame to hold copies and require that caller and callee
/// agree.
static SmallPtrSet<const Function *, 4> findKeptFunctions(Module &M) {
  SmallPtrSet<const Function *, 4> Kept;
  for (Function &F : M)
    for (Instruction &I : instructions(F)) {
      const auto *Call = dyn_cast<CallInst>(&I);
      if (!Call || !Call->isMustTailCall() || !hasByVal(*Call))
        continue;
      Kept.insert(&F);
      if (const Function *Callee = Call->getCalledFunction())
        Kept.insert(Callee);
    }
  return Kept;
}

/// A call of a function that is kept says so itself: a module that did not know
/// may have made the copies.
static bool restoreByVal(CallInst &Call, const Function &Callee) {
  bool Changed = false;
  for (unsigned Number = 0; Number != Callee.arg_size(); ++Number) {
    if (Number >= Call.arg_size() || !Callee.getArg(Number)->hasByValAttr() ||
        Call.getAttributes().hasParamAttr(Number, Attribute::ByVal))
      continue;
    Call.removeParamAttr(Number, Attribute::NoAlias);
    Call.removeParamAttr(Number, Attribute::DeadOnReturn);
    Call.addParamAttr(
        Number, Attribute::getWithByValType(Call.getContext(),
                                            Callee.getParamByValType(Number)));
    Changed = true;
  }
  return Changed;
}

PreservedAnalyses TPByValArgumentsPass::run(Module &M,
                                            ModuleAnalysisManager &) {
  const SmallPtrSet<const Function *, 4> Kept = findKeptFunctions(M);
  bool Changed = false;
  SmallVector<CallInst *> Calls;
  for (Function &F : M)
    for (Instruction &I : instructions(F)) {
      auto *Call = dyn_cast<CallInst>(&I);
      if (!Call || !hasByVal(*Call) || Call->isMustTailCall())
        continue;
      const Function *Callee = Call->getCalledFunction();
      if (Callee && Kept.contains(Callee))
        Changed |= restoreByVal(*Call, *Callee);
      else
        Calls.push_back(Call);
    }
  // Before the parameters, whose attributes count for calls too.
  for (CallInst *Call : Calls) {
    rewriteCall(*Call);
    Changed = true;
  }
  for (Function &F : M)
    if (!F.isIntrinsic() && !Kept.contains(&F))
      Changed |= rewriteParameters(F);
  return Changed ? PreservedAnalyses::none() : PreservedAnalyses::all();
}
