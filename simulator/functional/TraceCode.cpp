//===- TraceCode.cpp - A trace as an LLVM function ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Values are both kept for the later steps and written to the thread at once,
// so that the interpreter can take over at each step. The quantum is counted
// as the interpreter does: taken off where a block ends, tested there.
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/TraceCode.h"

#include "simulator/functional/FunctionalStep.h"
#include "simulator/jit/BodyLibrary.h"
#include "simulator/jit/CodeSession.h"
#include "simulator/jit/ControlFlow.h"

#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/MDBuilder.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstring>

using namespace llvm;

// All members of these classes are public; only library types in them keep
// them from being what offsetof() asks for.
#pragma clang diagnostic ignored "-Winvalid-offsetof"

namespace tp {

namespace {

class TraceBuilder {
public:
  TraceBuilder(Module &M, const std::string &Name,
               const FunctionalSubject &Subject, const Trace &Steps);

  void build();

private:
  void beginLoop();
  /// Registers that are read before they are written.
  std::bitset<NumRegisters> inputs() const;
  /// Builds a step; false if the trace cannot go on behind it.
  bool buildStep(const TraceStep &Step);
  void checkStackPointer();
  Value *callStep();
  bool endBranch(const TraceStep &Step, Value *Result, Value *Kind);

  /// Goes on in a new block if \p Condition holds; else the interpreter does
  /// the instruction at hand.
  void proceedIf(Value *Condition);
  /// A block ends behind the step at hand and another begins in the slot:
  /// counts both and goes on, or ends the turn.
  void beginBlock(Value *NextSlot);
  /// Leaves to the word, which follows without a jump or begins the block.
  void leaveTo(uint32_t Next);
  /// Leaves to the slot, which begins the block.
  void leaveToBlock(Value *NextSlot);
  void leave(Value *Handler, Value *NextSlot, Value *Block);
  void loopBack();

  Value *valueOf(uint8_t Register);
  Value *inThread(size_t Offset);
  Value *registerAddress(uint8_t Register);
  Value *field(Value *Result, size_t Offset, Type *Of);
  Value *inSlot(Value *Slot, size_t Offset);
  Value *slotAddress(uint32_t Slot);
  Value *address(const void *Pointer);
  void increment(Value *Address);
  MDNode *likely() {
    return MDBuilder(B.getContext()).createLikelyBranchWeights();
  }
  BasicBlock *newBlock(const char *Name) {
    return BasicBlock::Create(B.getContext(), Name, F);
  }
  uint32_t head() const { return Steps.front().Word; }

  Module &M;
  const FunctionalSubject &Subject;
  const Trace &Steps;
  std::span<const tp::Instruction> Text;
  Function *F;
  IRBuilder<> B;
  Value *Thread, *Runner;
  std::array<Value *, NumRegisters> Registers{};

  /// What remained of the quantum when the block at hand began.
  Value *Quantum = nullptr;
  /// Steps of the block at hand; it began so many words before.
  uint32_t InBlock = 0;

  BasicBlock *Loop = nullptr;
  PHINode *LoopQuantum = nullptr;
  std::array<PHINode *, NumRegisters> LoopRegisters{};

  /// The step at hand.
  uint32_t Word = 0;
  const tp::Instruction *Decoded = nullptr;
  /// Where the interpreter takes over at it, once that is needed.
  BasicBlock *Stop = nullptr;
};

} // namespace

TraceBuilder::TraceBuilder(Module &M, const std::string &Name,
                           const FunctionalSubject &Subject, const Trace &Steps)
    : M(M), Subject(Subject), Steps(Steps), Text(Subject.Text->instructions()),
      B(M.getContext()) {
  Type *Pointer = B.getPtrTy();
  auto *HandlerType = FunctionType::get(
      B.getVoidTy(), {Pointer, Pointer, Pointer, B.getInt64Ty(), Pointer},
      /*isVarArg=*/false);
  F = Function::Create(HandlerType, GlobalValue::ExternalLinkage, Name, M);
  F->setCallingConv(CallingConv::PreserveNone);
  prepareFunction(*F);
  for (unsigned Argument : {0, 4})
    F->addParamAttr(Argument, Attribute::NoAlias);
  Thread = F->getArg(0);
  Runner = F->getArg(4);
}

Value *TraceBuilder::address(const void *Pointer) {
  return B.CreateIntToPtr(B.getInt64(reinterpret_cast<uintptr_t>(Pointer)),
                          B.getPtrTy());
}

Value *TraceBuilder::slotAddress(uint32_t Slot) {
  return address(Subject.Runner->Slots + Slot);
}

Value *TraceBuilder::inSlot(Value *Slot, size_t Offset) {
  return B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), Slot, Offset);
}

Value *TraceBuilder::inThread(size_t Offset) {
  return B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), Thread, Offset);
}

Value *TraceBuilder::registerAddress(uint8_t Register) {
  return inThread(offsetof(FunctionalThread, Registers) +
                  Register * sizeof(uint32_t));
}

Value *TraceBuilder::valueOf(uint8_t Register) {
  if (Register == 0)
    return B.getInt32(0);
  Value *&Known = Registers[Register];
  if (!Known)
    Known = B.CreateLoad(B.getInt32Ty(), registerAddress(Register),
                         "r" + Twine(Register));
  return Known;
}

void TraceBuilder::increment(Value *Address) {
  Value *Old = B.CreateLoad(B.getInt64Ty(), Address);
  B.CreateStore(B.CreateAdd(Old, B.getInt64(1)), Address);
}

std::bitset<NumRegisters> TraceBuilder::inputs() const {
  std::bitset<NumRegisters> Read, Written;
  Written[0] = true;
  for (const TraceStep &Step : Steps) {
    const tp::Instruction &Decoded = Text[Step.Word];
    for (uint8_t Source : Decoded.Source)
      Read[Source] = Read[Source] || !Written[Source];
    if (Decoded.Destination != NoRegister)
      Written[Decoded.Destination] = true;
  }
  return Read;
}

void TraceBuilder::beginLoop() {
  BasicBlock *Entry = B.GetInsertBlock();
  std::bitset<NumRegisters> Inputs = inputs();
  for (unsigned Register = 0; Register != NumRegisters; ++Register)
    if (Inputs[Register])
      valueOf(uint8_t(Register));
  Loop = newBlock("loop");
  B.CreateBr(Loop);
  B.SetInsertPoint(Loop);
  LoopQuantum = B.CreatePHI(B.getInt64Ty(), 2);
  LoopQuantum->addIncoming(Quantum, Entry);
  Quantum = LoopQuantum;
  for (unsigned Register = 0; Register != NumRegisters; ++Register) {
    if (!Inputs[Register])
      continue;
    PHINode *Phi = B.CreatePHI(B.getInt32Ty(), 2);
    Phi->addIncoming(Registers[Register], Entry);
    Registers[Register] = LoopRegisters[Register] = Phi;
  }
}

void TraceBuilder::loopBack() {
  BasicBlock *From = B.GetInsertBlock();
  LoopQuantum->addIncoming(Quantum, From);
  for (unsigned Register = 0; Register != NumRegisters; ++Register)
    if (PHINode *Phi = LoopRegisters[Register])
      Phi->addIncoming(Registers[Register], From);
  B.CreateBr(Loop);
}

void TraceBuilder::leave(Value *Handler, Value *NextSlot, Value *Block) {
  CallInst *Call = B.CreateCall(F->getFunctionType(), Handler,
                                {Thread, NextSlot, Block, Quantum, Runner});
  Call->setCallingConv(CallingConv::PreserveNone);
  Call->setTailCallKind(CallInst::TCK_MustTail);
  B.CreateRetVoid();
}

void TraceBuilder::leaveTo(uint32_t Next) {
  Value *NextSlot = slotAddress(Next);
  Value *Handler = B.CreateLoad(
      B.getPtrTy(), inSlot(NextSlot, offsetof(FunctionalSlot, Execute)));
  leave(Handler, NextSlot, slotAddress(Next - InBlock));
}

void TraceBuilder::leaveToBlock(Value *NextSlot) {
  Value *Handler = B.CreateLoad(
      B.getPtrTy(), inSlot(NextSlot, offsetof(FunctionalSlot, Execute)));
  leave(Handler, NextSlot, NextSlot);
}

void TraceBuilder::proceedIf(Value *Condition) {
  BasicBlock *Go = newBlock("go");
  if (!Stop) {
    Stop = newBlock("stop");
    IRBuilder<>::InsertPointGuard Guard(B);
    B.SetInsertPoint(Stop);
    leave(address(reinterpret_cast<const void *>(Subject.Interpreter[Word])),
          slotAddress(Word), slotAddress(Word - InBlock));
  }
  B.CreateCondBr(Condition, Go, Stop, likely());
  B.SetInsertPoint(Go);
}

void TraceBuilder::checkStackPointer() {
  uint32_t Limit = Subject.Runner->StackLimit;
  if (Limit != 0 && Word != 0 && movesStackPointer(Text[Word - 1]))
    proceedIf(
        B.CreateICmpUGE(valueOf(StackPointerRegister), B.getInt32(Limit)));
}

Value *TraceBuilder::callStep() {
  uint32_t Pc = Subject.Text->textBegin() + Word * 4;
  Subnormals Mode = Subnormals::Keep;
  if (Subject.FlushToZero)
    Mode =
        Subject.Text->isFloatChecked(Pc) ? Subnormals::Trap : Subnormals::Flush;
  Function *Step = M.getFunction(stepName(Decoded->Op, Mode));
  IRBuilder<> AtEntry(&F->getEntryBlock(), F->getEntryBlock().begin());
  AllocaInst *Result = AtEntry.CreateAlloca(
      ArrayType::get(B.getInt8Ty(), sizeof(FunctionalStepResult)), nullptr,
      "result");
  Result->setAlignment(Align(alignof(FunctionalStepResult)));
  SmallVector<Value *> Arguments = {Thread, Runner, B.getInt32(Pc),
                                    B.getInt32(Decoded->Immediate),
                                    B.getInt8(Decoded->SecondImmediate)};
  for (uint8_t Source : Decoded->Source)
    Arguments.push_back(valueOf(Source));
  Arguments.push_back(Result);
  B.CreateCall(Step, Arguments);
  return Result;
}

Value *TraceBuilder::field(Value *Result, size_t Offset, Type *Of) {
  return B.CreateLoad(
      Of, B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), Result, Offset));
}

void TraceBuilder::beginBlock(Value *NextSlot) {
  increment(inSlot(slotAddress(Word + 1), offsetof(FunctionalSlot, Ended)));
  increment(inSlot(NextSlot, offsetof(FunctionalSlot, Begun)));
  Quantum = B.CreateSub(Quantum, B.getInt64(InBlock));
  BasicBlock *Go = newBlock("block");
  BasicBlock *End = newBlock("end");
  B.CreateCondBr(B.CreateICmpSGT(Quantum, B.getInt64(0)), Go, End, likely());
  B.SetInsertPoint(End);
  leave(address(reinterpret_cast<const void *>(Subject.EndTurn)), NextSlot,
        NextSlot);
  B.SetInsertPoint(Go);
}

bool TraceBuilder::endBranch(const TraceStep &Step, Value *Result,
                             Value *Kind) {
  bool MayGoOn = flowOf(Decoded->Op) == Flow::Branch;
  bool IsDirect = flowOf(Decoded->Op) != Flow::IndirectJump && Step.Target;
  BasicBlock *Next = nullptr;
  if (MayGoOn) {
    BasicBlock *Taken = newBlock("taken");
    Next = newBlock("next");
    B.CreateCondBr(B.CreateICmpEQ(Kind, B.getInt8(FunctionalStepBranch)), Taken,
                   Next);
    B.SetInsertPoint(Taken);
  }
  Value *QuantumBefore = Quantum;
  Value *NextSlot = nullptr;
  Value *Target = nullptr;
  if (IsDirect) {
    NextSlot = slotAddress(*Step.Target);
  } else {
    Target = field(Result, offsetof(FunctionalStepResult, TargetWord),
                   B.getInt32Ty());
    NextSlot = B.CreateGEP(B.getInt8Ty(), slotAddress(0),
                           B.CreateMul(B.CreateZExt(Target, B.getInt64Ty()),
                                       B.getInt64(sizeof(FunctionalSlot))));
  }
  beginBlock(NextSlot);
  if (Step.FollowsTarget) {
    if (!IsDirect) {
      BasicBlock *Expected = newBlock("expected");
      BasicBlock *Other = newBlock("other");
      B.CreateCondBr(B.CreateICmpEQ(Target, B.getInt32(*Step.Target)), Expected,
                     Other, likely());
      B.SetInsertPoint(Other);
      leaveToBlock(NextSlot);
      B.SetInsertPoint(Expected);
    }
    if (Next) {
      IRBuilder<>::InsertPointGuard Guard(B);
      Value *QuantumAfter = std::exchange(Quantum, QuantumBefore);
      B.SetInsertPoint(Next);
      leaveTo(Word + 1);
      Quantum = QuantumAfter;
    }
    InBlock = 0;
    return true;
  }
  if (IsDirect && Loop && *Step.Target == head())
    loopBack();
  else
    leaveToBlock(NextSlot);
  Quantum = QuantumBefore;
  if (!Next)
    return false;
  B.SetInsertPoint(Next);
  return true;
}

bool TraceBuilder::buildStep(const TraceStep &Step) {
  Word = Step.Word;
  Decoded = &Text[Word];
  Stop = nullptr;
  checkStackPointer();
  Value *Result = callStep();
  Value *Kind =
      field(Result, offsetof(FunctionalStepResult, Kind), B.getInt8Ty());
  static_assert(FunctionalStepNext < FunctionalStepBranch &&
                FunctionalStepBranch == 1);
  proceedIf(B.CreateICmpULE(Kind, B.getInt8(FunctionalStepBranch)));
  if (uint8_t Register = Decoded->Destination; Register != NoRegister) {
    Registers[Register] =
        field(Result, offsetof(FunctionalStepResult, Value), B.getInt32Ty());
    B.CreateStore(Registers[Register], registerAddress(Register));
  }
  ++InBlock;
  return flowOf(Decoded->Op) == Flow::Next || endBranch(Step, Result, Kind);
}

void TraceBuilder::build() {
  B.SetInsertPoint(newBlock("entry"));
  // From here on the block begins at the head.
  Value *Distance = B.CreateSub(
      B.getInt64(reinterpret_cast<uintptr_t>(Subject.Runner->Slots + head())),
      B.CreatePtrToInt(F->getArg(2), B.getInt64Ty()));
  Quantum = B.CreateSub(
      F->getArg(3),
      B.CreateExactSDiv(Distance, B.getInt64(sizeof(FunctionalSlot))));
  bool IsLoop = std::ranges::any_of(Steps, [&](const TraceStep &Step) {
    return Step.Target == head() &&
           flowOf(Text[Step.Word].Op) != Flow::IndirectJump;
  });
  if (IsLoop)
    beginLoop();
  for (const TraceStep &Step : Steps)
    if (!buildStep(Step))
      return;
  const TraceStep &Last = Steps.back();
  uint32_t End = Last.FollowsTarget ? *Last.Target : Last.Word + 1;
  if (Loop && End == head() && InBlock == 0)
    loopBack();
  else
    leaveTo(End);
}

void addTrace(Module &M, const std::string &Name,
              const FunctionalSubject &Subject, const Trace &Steps) {
  TraceBuilder(M, Name, Subject, Steps).build();
}

/// The bytes of the address space at \p Offset as a constant of type \p Of.
static Constant *constantAt(const AddressSpace &Space, uint64_t Offset,
                            Type *Of, const DataLayout &Layout) {
  uint64_t Bytes = Layout.getTypeStoreSize(Of);
  if (Bytes > sizeof(uint64_t) || Offset + Bytes > sizeof(AddressSpace))
    return nullptr;
  uint64_t Value = 0;
  std::memcpy(&Value, reinterpret_cast<const char *>(&Space) + Offset, Bytes);
  auto *Integer =
      ConstantInt::get(IntegerType::get(Of->getContext(), Bytes * 8), Value);
  if (Of->isPointerTy())
    return ConstantExpr::getIntToPtr(Integer, Of);
  return Of == Integer->getType() ? Integer : nullptr;
}

void foldAddresses(Function &Handler, const FunctionalSubject &Subject) {
  static_assert(offsetof(FunctionalRunner, Space) == 0);
  const DataLayout &Layout = Handler.getDataLayout();
  const Argument *Thread = Handler.getArg(0);
  const Argument *Runner = Handler.getArg(4);
  LoadInst *Bias = nullptr;
  for (llvm::Instruction &I : make_early_inc_range(instructions(Handler))) {
    auto *Load = dyn_cast<LoadInst>(&I);
    if (!Load || Load == Bias)
      continue;
    APInt Offset(64, 0);
    const Value *Base =
        Load->getPointerOperand()->stripAndAccumulateConstantOffsets(
            Layout, Offset, /*AllowNonInbounds=*/true);
    Value *Known = nullptr;
    if (Base == Runner)
      Known = constantAt(Subject.Runner->Space, Offset.getZExtValue(),
                         Load->getType(), Layout);
    if (Base == Thread && Load->getType()->isIntegerTy(64) &&
        Offset == offsetof(FunctionalThread, LocalStoreBias)) {
      if (!Bias) {
        IRBuilder<> B(&*Handler.getEntryBlock().getFirstInsertionPt());
        Bias = B.CreateLoad(
            B.getInt64Ty(),
            B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), Handler.getArg(0),
                                         Offset.getZExtValue()));
      }
      Known = Bias;
    }
    if (Known) {
      Load->replaceAllUsesWith(Known);
      Load->eraseFromParent();
    }
  }
}

} // namespace tp
