//===- TPCheckedObjects.cpp - Objects that checkers know ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// With -tp-check-objects, each object of the stack whose address is more than
// that of loads and stores gets bytes before and behind it that are nobody's,
// and the code tells who watches the run when its life begins and ends
// (runtime/include/tp/check.h). Lives do not share memory any more. Globals
// get such bytes behind them, and a table says which.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TP.h"
#include "runtime/include/tp/check.h"
#include "llvm/IR/DIBuilder.h"
#include "llvm/IR/DebugInfo.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InlineAsm.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"
#include "llvm/InitializePasses.h"
#include "llvm/Pass.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Transforms/Utils/Local.h"
#include "llvm/Transforms/Utils/ModuleUtils.h"
#include "llvm/Transforms/Utils/PromoteMemToReg.h"

using namespace llvm;
using tp::CheckedObject;
using tp::CheckMessage;

#define DEBUG_TYPE "tp-checked-objects"

static cl::opt<bool>
    CheckObjects("tp-check-objects", cl::Hidden, cl::init(false),
                 cl::desc("Tell checkers of the objects of the stack"));

namespace {

class TPCheckedObjects : public ModulePass {
public:
  static char ID;

  TPCheckedObjects() : ModulePass(ID) {}

  StringRef getPassName() const override { return "TP checked objects"; }
  bool runOnModule(Module &M) override;

private:
  void watch(AllocaInst &Object);
  /// Tells when \p Object, which \p Inside replaces, ceases to live. Gives the
  /// instructions before which it begins to: at least one.
  SmallVector<Instruction *> takeLifetimes(AllocaInst &Object, Value *Inside);
  /// Gives the padded global and its bytes as an entry of the table.
  Constant *pad(GlobalVariable &Global);
  void padGlobals(Module &M);
  /// The CheckedObject of \p Object, which has \p Bytes.
  Constant *describe(const AllocaInst &Object, const Value *Bytes);
  void tell(IRBuilder<> &Builder, CheckMessage Message, Value *What);
  void tellBegin(Instruction &Before, Constant *Descriptor, Value *Bytes,
                 Value *Object);
};

} // namespace

char TPCheckedObjects::ID = 0;

INITIALIZE_PASS(TPCheckedObjects, DEBUG_TYPE,
                "Tell checkers of the objects of the stack", false, false)

ModulePass *llvm::createTPCheckedObjectsPass() {
  return new TPCheckedObjects();
}

/// Bytes of each of the elements that \p Object holds.
static uint64_t elementBytes(const AllocaInst &Object) {
  return Object.getDataLayout().getTypeAllocSize(Object.getAllocatedType());
}

/// Whether accesses to \p Object can go wrong, and it may be moved.
static bool isWatched(const AllocaInst &Object) {
  return !Object.isUsedWithInAlloca() && !Object.isSwiftError() &&
         !isAllocaPromotable(&Object) && elementBytes(Object) != 0;
}

/// The source's name of \p Object.
static StringRef nameOf(const AllocaInst &Object) {
  for (const DbgVariableRecord *Record :
       findDVRDeclares(const_cast<AllocaInst *>(&Object)))
    return Record->getVariable()->getName();
  return Object.getName();
}

static Constant *makeConstant(Module &M, Constant *Value) {
  return new GlobalVariable(M, Value->getType(), /*isConstant=*/true,
                            GlobalValue::PrivateLinkage, Value);
}

Constant *TPCheckedObjects::describe(const AllocaInst &Object,
                                     const Value *Bytes) {
  Module &M = *const_cast<Module *>(Object.getModule());
  LLVMContext &Context = M.getContext();
  Constant *Name =
      makeConstant(M, ConstantDataArray::getString(Context, nameOf(Object)));
  const auto *Known = dyn_cast<ConstantInt>(Bytes);
  return makeConstant(
      M, ConstantStruct::getAnon(
             {ConstantInt::get(Bytes->getType(),
                               Known ? Known->getZExtValue()
                                     : CheckedObject::VariableBytes),
              Name}));
}

void TPCheckedObjects::tell(IRBuilder<> &Builder, CheckMessage Message,
                            Value *What) {
  Type *Word = Builder.getInt32Ty();
  auto *Type = FunctionType::get(Builder.getVoidTy(), {Word, What->getType()},
                                 /*isVarArg=*/false);
  InlineAsm *Code = InlineAsm::get(Type, "profv $0, $1", "K,r,~{memory}",
                                   /*hasSideEffects=*/true);
  Builder.CreateCall(Code, {Builder.getInt32(uint32_t(Message)), What});
}

void TPCheckedObjects::tellBegin(Instruction &Before, Constant *Descriptor,
                                 Value *Bytes, Value *Object) {
  IRBuilder<> Builder(&Before);
  tell(Builder, CheckMessage::StackObject, Descriptor);
  if (!isa<Constant>(Bytes))
    tell(Builder, CheckMessage::ObjectBytes, Bytes);
  tell(Builder, CheckMessage::ObjectBegins, Object);
}

SmallVector<Instruction *> TPCheckedObjects::takeLifetimes(AllocaInst &Object,
                                                           Value *Inside) {
  SmallVector<IntrinsicInst *> Lifetimes;
  for (User *U : Object.users())
    if (auto *Call = dyn_cast<IntrinsicInst>(U);
        Call && Call->isLifetimeStartOrEnd())
      Lifetimes.push_back(Call);
  SmallVector<Instruction *> Beginnings;
  for (IntrinsicInst *Call : Lifetimes) {
    if (Call->getIntrinsicID() == Intrinsic::lifetime_start) {
      Beginnings.push_back(Call->getNextNode());
    } else {
      IRBuilder<> Builder(Call);
      tell(Builder, CheckMessage::ObjectEnds, Inside);
    }
    Call->eraseFromParent();
  }
  if (!Beginnings.empty())
    return Beginnings;
  BasicBlock::iterator At = std::next(Object.getIterator());
  while (isa<AllocaInst>(At))
    ++At;
  return {&*At};
}

void TPCheckedObjects::watch(AllocaInst &Object) {
  const Align Alignment =
      std::max(Object.getAlign(), Align(CheckedObject::PaddingBytes));
  // The object keeps its alignment behind the padding.
  const uint64_t Offset = Alignment.value();

  IRBuilder<> Builder(&Object);
  Value *Bytes = Builder.CreateMul(
      Builder.CreateZExtOrTrunc(Object.getArraySize(), Builder.getInt32Ty()),
      Builder.getInt32(elementBytes(Object)));
  Value *Granules = Builder.CreateAnd(
      Builder.CreateAdd(Bytes, Builder.getInt32(7)), Builder.getInt32(~7u));
  Value *Whole = Builder.CreateAdd(
      Granules, Builder.getInt32(Offset + CheckedObject::PaddingBytes));
  AllocaInst *Padded = Builder.CreateAlloca(Builder.getInt8Ty(), Whole,
                                            Object.getName() + ".padded");
  Padded->setAlignment(Alignment);
  auto *Inside = cast<Instruction>(Builder.CreateConstInBoundsGEP1_64(
      Builder.getInt8Ty(), Padded, Offset, Object.getName()));

  Constant *Descriptor = describe(Object, Bytes);
  for (Instruction *Beginning : takeLifetimes(Object, Inside))
    tellBegin(*Beginning, Descriptor, Bytes, Inside);
  DIBuilder Information(*Object.getModule(), /*AllowUnresolved=*/false);
  replaceDbgDeclare(&Object, Padded, Information, DIExpression::ApplyOffset,
                    int(Offset));
  Object.replaceAllUsesWith(Inside);
  Object.eraseFromParent();
}

/// Whether \p Global is the program's own and may become larger.
static bool isPadded(const GlobalVariable &Global,
                     ArrayRef<GlobalValue *> Used) {
  return !Global.hasSection() && !Global.hasComdat() &&
         Global.hasExactDefinition() &&
         !Global.getName().starts_with("llvm.") &&
         !is_contained(Used, &Global) &&
         Global.getDataLayout().getTypeAllocSize(Global.getValueType()) != 0;
}

Constant *TPCheckedObjects::pad(GlobalVariable &Global) {
  LLVMContext &Context = Global.getContext();
  const uint64_t Bytes =
      Global.getDataLayout().getTypeAllocSize(Global.getValueType());
  Type *Padding =
      ArrayType::get(Type::getInt8Ty(Context),
                     alignTo(Bytes, 8) - Bytes + CheckedObject::PaddingBytes);
  auto *Padded = new GlobalVariable(
      *Global.getParent(),
      StructType::get(Context, {Global.getValueType(), Padding}),
      Global.isConstant(), Global.getLinkage(),
      ConstantStruct::getAnon(
          {Global.getInitializer(), Constant::getNullValue(Padding)}),
      "", &Global, Global.getThreadLocalMode());
  Padded->copyAttributesFrom(&Global);
  Padded->copyMetadata(&Global, 0);
  Padded->setAlignment(
      std::max({Global.getAlign().valueOrOne(),
                Global.getDataLayout().getPreferredAlign(&Global), Align(8)}));
  Padded->takeName(&Global);
  Global.replaceAllUsesWith(Padded);
  Global.eraseFromParent();
  return ConstantStruct::getAnon(
      {Padded, ConstantInt::get(Type::getInt32Ty(Context), Bytes)});
}

void TPCheckedObjects::padGlobals(Module &M) {
  SmallVector<GlobalValue *, 8> Used;
  collectUsedGlobalVariables(M, Used, /*CompilerUsed=*/false);
  SmallVector<GlobalVariable *> Globals;
  for (GlobalVariable &Global : M.globals())
    if (isPadded(Global, Used))
      Globals.push_back(&Global);
  SmallVector<Constant *> Entries;
  for (GlobalVariable *Global : Globals)
    Entries.push_back(pad(*Global));
  if (Entries.empty())
    return;
  auto *Type = ArrayType::get(Entries.front()->getType(), Entries.size());
  auto *Table = new GlobalVariable(
      M, Type, /*isConstant=*/true, GlobalValue::InternalLinkage,
      ConstantArray::get(Type, Entries), tp::CheckedGlobalsSymbol);
  // Linkers keep notes.
  Table->setSection(".note.tp_globals");
}

bool TPCheckedObjects::runOnModule(Module &M) {
  if (!CheckObjects)
    return false;
  padGlobals(M);
  SmallVector<AllocaInst *> Objects;
  for (Function &F : M)
    for (Instruction &I : instructions(F))
      if (auto *Object = dyn_cast<AllocaInst>(&I); Object && isWatched(*Object))
        Objects.push_back(Object);
  for (AllocaInst *Object : Objects)
    watch(*Object);
  return true;
}
