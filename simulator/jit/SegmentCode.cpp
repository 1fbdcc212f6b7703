//===- SegmentCode.cpp - A segment as an LLVM function --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// All cycles are the cycle of entry plus a constant: what cannot be known, such
// as a resource that is not free, ends the segment at the instruction at hand.
// Values are both kept for the later steps and written to the thread at once,
// so that ending costs nothing.
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/SegmentCode.h"

#include "simulator/core/DecodedText.h"
#include "simulator/jit/BodyLibrary.h"
#include "simulator/jit/CodeSession.h"
#include "simulator/jit/Step.h"

#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/MDBuilder.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <optional>

using namespace llvm;

// All members of these classes are public; only library types in them keep
// them from being what offsetof() asks for.
#pragma clang diagnostic ignored "-Winvalid-offsetof"

namespace tp {

namespace {

/// What is known of a register at a step. Cycles count from entry.
struct RegisterState {
  llvm::Value *Value = nullptr;
  /// When it is ready, if that is known; else its ready word, or null if that
  /// is the one in the thread.
  std::optional<uint32_t> ReadyCycle;
  llvm::Value *ReadyWord = nullptr;
  Opcode Producer = Opcode(0);
  /// By when the thread's ready word has passed, if that is known.
  std::optional<uint32_t> PassedCycle;
};

class SegmentBuilder {
public:
  SegmentBuilder(Module &M, const std::string &Name, const CodeSubject &Subject,
                 const Segment &Steps, size_t FirstCount);

  SegmentCounts build();

private:
  void buildStep(const SegmentStep &Step);
  void checkStackPointer();
  void waitForSources();
  void takeResources();
  llvm::Value *callStep();
  void writeResult(llvm::Value *Result);
  void leaveBranch(const SegmentStep &Step, llvm::Value *Result,
                   llvm::Value *Kind);

  /// Charges a wait; the interpreter does one that reaches the window's end.
  void wait(Loss Reason, uint32_t Cycles);
  /// Goes on in a new block if \p Condition holds; else the interpreter does
  /// the instruction at hand.
  void proceedIf(llvm::Value *Condition);
  /// Leaves for the next instruction, whose slot that is.
  void leaveTo(llvm::Value *SlotAddress);
  void leave(llvm::Value *Handler, llvm::Value *SlotAddress);
  void countExit(uint32_t Executed);

  llvm::Value *valueOf(uint8_t Register);
  llvm::Value *readyWordOf(uint8_t Register);
  llvm::Value *inThread(size_t Offset);
  llvm::Value *inRunner(size_t Offset);
  llvm::Value *registerAddress(uint8_t Register);
  llvm::Value *readyAddress(uint8_t Register);
  llvm::Value *field(llvm::Value *Result, size_t Offset, Type *Of);
  /// The lowest ready word of a cycle.
  llvm::Value *readyIn(uint32_t Cycle);
  llvm::Value *address(const void *Pointer);
  llvm::Value *slotAddress(uint32_t Slot);
  MDNode *likely() {
    return MDBuilder(B.getContext()).createLikelyBranchWeights();
  }
  BasicBlock *newBlock(const char *Name) {
    return BasicBlock::Create(B.getContext(), Name, F);
  }
  uint32_t pc() const { return Subject.Text->textBegin() + Word * 4; }

  Module &M;
  const CodeSubject &Subject;
  const Segment &Steps;
  const size_t FirstCount;
  std::span<const tp::Instruction> Text;
  Function *F;
  IRBuilder<> B;
  llvm::Value *Thread, *Cycle, *Free, *Runner;
  /// The entry cycle's resource word, and the entry cycle in a ready word.
  llvm::Value *FreeNow, *ReadyNow;
  std::array<RegisterState, NumRegisters> Registers;
  SegmentCounts Counts;

  /// The step at hand.
  uint32_t Index = 0;
  uint32_t Word = 0;
  const tp::Instruction *Decoded = nullptr;
  uint32_t Now = 0;
  /// Steps whose waits have been charged.
  uint32_t Waited = 0;
  /// Where the interpreter takes over at the cycle at hand, once it is needed.
  BasicBlock *Stop = nullptr;
  /// What it will write to the resource words, and where.
  SmallVector<std::pair<llvm::Value *, llvm::Value *>, 2> Taken;
};

} // namespace

SegmentBuilder::SegmentBuilder(Module &M, const std::string &Name,
                               const CodeSubject &Subject, const Segment &Steps,
                               size_t FirstCount)
    : M(M), Subject(Subject), Steps(Steps), FirstCount(FirstCount),
      Text(Subject.Text->instructions()), B(M.getContext()) {
  Type *Pointer = B.getPtrTy();
  auto *HandlerType = FunctionType::get(
      B.getVoidTy(), {Pointer, Pointer, B.getInt64Ty(), Pointer, Pointer},
      /*isVarArg=*/false);
  F = Function::Create(HandlerType, GlobalValue::ExternalLinkage, Name, M);
  F->setCallingConv(CallingConv::PreserveNone);
  prepareFunction(*F);
  for (unsigned Argument : {0, 3, 4})
    F->addParamAttr(Argument, Attribute::NoAlias);
  Thread = F->getArg(0);
  Cycle = F->getArg(2);
  Free = F->getArg(3);
  Runner = F->getArg(4);
  B.SetInsertPoint(newBlock("entry"));
  FreeNow =
      B.CreateGEP(B.getInt8Ty(), Free,
                  B.CreateMul(Cycle, B.getInt64(Subject.WordBytes)), "free");
  ReadyNow = B.CreateShl(B.CreateTrunc(Cycle, B.getInt32Ty()),
                         ready::CycleShift, "ready");
  Counts.Steps = Steps;
  Counts.Waits.resize(Steps.size());
}

llvm::Value *SegmentBuilder::address(const void *Pointer) {
  return B.CreateIntToPtr(B.getInt64(reinterpret_cast<uintptr_t>(Pointer)),
                          B.getPtrTy());
}

llvm::Value *SegmentBuilder::slotAddress(uint32_t Slot) {
  return address(static_cast<const char *>(Subject.Slots) +
                 Slot * Subject.SlotBytes);
}

llvm::Value *SegmentBuilder::inThread(size_t Offset) {
  return B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), Thread, Offset);
}

llvm::Value *SegmentBuilder::inRunner(size_t Offset) {
  return B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), Runner, Offset);
}

llvm::Value *SegmentBuilder::registerAddress(uint8_t Register) {
  return inThread(offsetof(tp::Thread, Registers) +
                  Register * sizeof(uint32_t));
}

llvm::Value *SegmentBuilder::readyAddress(uint8_t Register) {
  return inThread(offsetof(tp::Thread, Ready) + Register * sizeof(ReadyWord));
}

llvm::Value *SegmentBuilder::valueOf(uint8_t Register) {
  if (Register == 0)
    return B.getInt32(0);
  RegisterState &State = Registers[Register];
  if (!State.Value)
    State.Value = B.CreateLoad(B.getInt32Ty(), registerAddress(Register),
                               "r" + Twine(Register));
  return State.Value;
}

llvm::Value *SegmentBuilder::readyWordOf(uint8_t Register) {
  RegisterState &State = Registers[Register];
  if (!State.ReadyWord)
    State.ReadyWord = B.CreateLoad(B.getInt32Ty(), readyAddress(Register));
  return State.ReadyWord;
}

llvm::Value *SegmentBuilder::readyIn(uint32_t Cycle) {
  return B.CreateAdd(ReadyNow, B.getInt32(Cycle << ready::CycleShift));
}

void SegmentBuilder::countExit(uint32_t Executed) {
  uint64_t Number = FirstCount + Counts.Exits.size();
  Counts.Exits.push_back({Executed, Waited});
  llvm::Value *All = B.CreateLoad(
      B.getPtrTy(), inRunner(offsetof(TmRunnerState, CodeCountsBegin)));
  llvm::Value *Count =
      B.CreateConstInBoundsGEP1_64(B.getInt64Ty(), All, Number);
  llvm::Value *Old = B.CreateLoad(B.getInt64Ty(), Count);
  B.CreateStore(B.CreateAdd(Old, B.getInt64(1)), Count);
}

void SegmentBuilder::leave(llvm::Value *Handler, llvm::Value *SlotAddress) {
  llvm::Value *Now = B.CreateAdd(Cycle, B.getInt64(this->Now));
  CallInst *Call = B.CreateCall(F->getFunctionType(), Handler,
                                {Thread, SlotAddress, Now, Free, Runner});
  Call->setCallingConv(CallingConv::PreserveNone);
  Call->setTailCallKind(CallInst::TCK_MustTail);
  B.CreateRetVoid();
}

void SegmentBuilder::leaveTo(llvm::Value *SlotAddress) {
  countExit(Index + 1);
  llvm::Value *Handler = B.CreateLoad(
      B.getPtrTy(), B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), SlotAddress,
                                                 Subject.HandlerOffset));
  leave(Handler, SlotAddress);
}

void SegmentBuilder::proceedIf(llvm::Value *Condition) {
  BasicBlock *Go = newBlock("go");
  if (!Stop) {
    Stop = newBlock("stop");
    IRBuilder<>::InsertPointGuard Guard(B);
    B.SetInsertPoint(Stop);
    countExit(Index);
    leave(address(Subject.Interpreter[Word]), slotAddress(Word));
  }
  B.CreateCondBr(Condition, Go, Stop, likely());
  B.SetInsertPoint(Go);
}

void SegmentBuilder::checkStackPointer() {
  if (Subject.Context->StackLimit == 0 || Word == 0 ||
      !movesStackPointer(Text[Word - 1]))
    return;
  proceedIf(B.CreateICmpUGE(valueOf(StackPointerRegister),
                            B.getInt32(Subject.Context->StackLimit)));
}

void SegmentBuilder::waitForSources() {
  KnownWait &Wait = Counts.Waits[Index];
  ReadyWord Latest = 0;
  for (uint8_t Source : Decoded->Source) {
    RegisterState &State = Registers[Source];
    if (Source == 0)
      continue;
    if (State.ReadyCycle) {
      Latest =
          std::max(Latest, ready::after(*State.ReadyCycle, State.Producer));
      continue;
    }
    // A message can come in the cycle after the window, before the commit makes
    // a result that is ready then.
    uint32_t Limit = takesTime(Decoded->Op) ? Now + 1 : Now;
    proceedIf(B.CreateICmpULT(readyWordOf(Source), readyIn(Limit)));
    State.ReadyCycle = State.PassedCycle = Now;
  }
  uint64_t Until = ready::cycleOf(Latest);
  if (Until > Now && takesTime(Decoded->Op)) {
    Wait = {uint32_t(Until - Now), ready::producerOf(Latest)};
    wait(Loss::Data, Wait.Cycles);
    Waited = Index + 1;
    Stop = nullptr;
  }
}

void SegmentBuilder::wait(Loss Reason, uint32_t Cycles) {
  llvm::Value *Limit =
      B.CreateLoad(B.getInt64Ty(), inRunner(offsetof(TmRunnerState, Limit)));
  proceedIf(
      B.CreateICmpULT(B.CreateAdd(Cycle, B.getInt64(Now + Cycles)), Limit));
  llvm::Value *Lost = inThread(offsetof(tp::Thread, Lost) +
                               unsigned(Reason) * sizeof(uint64_t));
  B.CreateStore(
      B.CreateAdd(B.CreateLoad(B.getInt64Ty(), Lost), B.getInt64(Cycles)),
      Lost);
  Now += Cycles;
}

void SegmentBuilder::takeResources() {
  Taken.clear();
  if (!takesTime(Decoded->Op))
    return;
  WideWord Use = Subject.Uses[Word];
  WideWord Guards = Subject.Guards;
  constexpr unsigned LimbBits = 64;
  for (size_t Limb = 0; Limb != Subject.WordBytes / sizeof(uint64_t); ++Limb) {
    auto UseOfLimb = uint64_t(Use >> (Limb * LimbBits));
    // The limbs are independent, and each says whether the cycle is closed.
    if (UseOfLimb == 0 && (Use != 0 || Limb != 0))
      continue;
    llvm::Value *Address =
        B.CreateConstGEP1_64(B.getInt8Ty(), FreeNow,
                             Now * Subject.WordBytes + Limb * sizeof(uint64_t));
    llvm::Value *Used =
        B.CreateAdd(B.CreateAlignedLoad(B.getInt64Ty(), Address, Align(8)),
                    B.getInt64(UseOfLimb));
    llvm::Value *Over =
        B.CreateAnd(Used, B.getInt64(uint64_t(Guards >> (Limb * LimbBits))));
    proceedIf(B.CreateICmpEQ(Over, B.getInt64(0)));
    if (UseOfLimb != 0)
      Taken.push_back({Used, Address});
  }
}

llvm::Value *SegmentBuilder::callStep() {
  Subnormals Mode = Subnormals::Keep;
  if (Subject.FlushToZero)
    Mode = Subject.Text->isFloatChecked(pc()) ? Subnormals::Trap
                                              : Subnormals::Flush;
  Function *Step = M.getFunction(stepName(Decoded->Op, Mode));
  IRBuilder<> AtEntry(&F->getEntryBlock(), F->getEntryBlock().begin());
  llvm::Value *Result = AtEntry.CreateAlloca(
      ArrayType::get(B.getInt8Ty(), sizeof(StepResult)), nullptr, "result");
  cast<AllocaInst>(Result)->setAlignment(Align(alignof(StepResult)));
  SmallVector<llvm::Value *> Arguments = {Thread,
                                          Runner,
                                          B.CreateAdd(Cycle, B.getInt64(Now)),
                                          B.getInt32(Word),
                                          B.getInt32(Decoded->Immediate),
                                          B.getInt8(Decoded->SecondImmediate),
                                          B.getInt8(Decoded->Destination),
                                          B.getInt32(Subject.Results[Word])};
  for (uint8_t Source : Decoded->Source)
    Arguments.push_back(valueOf(Source));
  Arguments.push_back(Result);
  B.CreateCall(Step, Arguments);
  return Result;
}

llvm::Value *SegmentBuilder::field(llvm::Value *Result, size_t Offset,
                                   Type *Of) {
  return B.CreateLoad(
      Of, B.CreateConstInBoundsGEP1_64(B.getInt8Ty(), Result, Offset));
}

void SegmentBuilder::writeResult(llvm::Value *Result) {
  uint8_t Register = Decoded->Destination;
  if (Register == NoRegister)
    return;
  RegisterState &State = Registers[Register];
  State.Value = field(Result, offsetof(StepResult, Value), B.getInt32Ty());
  B.CreateStore(State.Value, registerAddress(Register));
  State.Producer = Decoded->Op;
  State.ReadyWord = nullptr;
  State.ReadyCycle = std::nullopt;
  if (isLoad(Decoded->Op)) {
    State.ReadyWord =
        field(Result, offsetof(StepResult, Ready), B.getInt32Ty());
    State.PassedCycle = std::nullopt;
    B.CreateStore(State.ReadyWord, readyAddress(Register));
    return;
  }
  State.ReadyCycle = Now + uint32_t(ready::cycleOf(Subject.Results[Word]));
  if (*State.ReadyCycle > Now + 1) {
    B.CreateStore(B.CreateAdd(ReadyNow, B.getInt32(ready::after(
                                            *State.ReadyCycle, Decoded->Op))),
                  readyAddress(Register));
    State.PassedCycle = State.ReadyCycle;
  } else if (!State.PassedCycle || *State.PassedCycle > Now + 1) {
    // Nothing can ask before it has passed: any word of the past will do.
    B.CreateStore(B.getInt32(0), readyAddress(Register));
    State.PassedCycle = 0;
  }
}

void SegmentBuilder::leaveBranch(const SegmentStep &Step, llvm::Value *Result,
                                 llvm::Value *Kind) {
  BasicBlock *TakenBlock = newBlock("taken");
  BasicBlock *NextBlock = newBlock("next");
  B.CreateCondBr(B.CreateICmpEQ(Kind, B.getInt8(StepBranch)), TakenBlock,
                 NextBlock);
  B.SetInsertPoint(TakenBlock);
  llvm::Value *Target = B.CreateZExt(
      field(Result, offsetof(StepResult, TargetWord), B.getInt32Ty()),
      B.getInt64Ty());
  llvm::Value *TargetSlot =
      B.CreateAdd(B.getInt64(reinterpret_cast<uintptr_t>(Subject.Slots)),
                  B.CreateMul(Target, B.getInt64(Subject.SlotBytes)));
  TargetSlot = B.CreateIntToPtr(TargetSlot, B.getPtrTy());
  if (Subject.Context->BranchLatency != 1) {
    countExit(Index + 1);
    B.CreateStore(B.getInt32(Word), inThread(offsetof(tp::Thread, LastWord)));
    leave(address(Subject.WaitForTarget), TargetSlot);
  } else if (!Step.FollowsTarget) {
    leaveTo(TargetSlot);
  } else {
    B.SetInsertPoint(NextBlock);
    leaveTo(slotAddress(Word + 1));
    NextBlock = TakenBlock;
  }
  B.SetInsertPoint(NextBlock);
}

void SegmentBuilder::buildStep(const SegmentStep &Step) {
  Word = Step.Word;
  Decoded = &Text[Word];
  Waited = Index;
  Stop = nullptr;
  checkStackPointer();
  waitForSources();
  takeResources();
  llvm::Value *Result = callStep();
  llvm::Value *Kind = field(Result, offsetof(StepResult, Kind), B.getInt8Ty());
  proceedIf(B.CreateICmpULE(Kind, B.getInt8(StepBranch)));
  static_assert(StepNext < StepBranch && StepBranch == 1);
  for (auto [Used, Address] : Taken)
    B.CreateAlignedStore(Used, Address, Align(8));
  writeResult(Result);
  if (takesTime(Decoded->Op))
    ++Now;
  Waited = Index + 1;
  if (flowOf(Decoded->Op) != Flow::Next)
    leaveBranch(Step, Result, Kind);
}

SegmentCounts SegmentBuilder::build() {
  for (const SegmentStep &Step : Steps) {
    Index = uint32_t(&Step - Steps.data());
    buildStep(Step);
  }
  uint32_t Next = Steps.back().FollowsTarget
                      ? *targetOf(*Decoded, Word, uint32_t(Text.size()))
                      : Word + 1;
  leaveTo(slotAddress(Next));
  return std::move(Counts);
}

SegmentCounts addSegment(Module &M, const std::string &Name,
                         const CodeSubject &Subject, const Segment &Steps,
                         size_t FirstCount) {
  return SegmentBuilder(M, Name, Subject, Steps, FirstCount).build();
}

/// The bytes of \p Context at \p Offset as a constant of type \p Of; null if
/// they may change in a run.
static Constant *constantAt(const ChipContext &Context, uint64_t Offset,
                            Type *Of, const DataLayout &Layout) {
  uint64_t Bytes = Layout.getTypeStoreSize(Of);
  constexpr size_t ObserverBegin = offsetof(ChipContext, Observer);
  constexpr size_t ObserverEnd = ObserverBegin + sizeof(Context.Observer);
  bool IsObserver = Offset + Bytes > ObserverBegin && Offset < ObserverEnd;
  if (IsObserver || Bytes > sizeof(uint64_t) ||
      Offset + Bytes > sizeof(ChipContext))
    return nullptr;
  uint64_t Value = 0;
  std::memcpy(&Value, reinterpret_cast<const char *>(&Context) + Offset, Bytes);
  auto *Integer =
      ConstantInt::get(IntegerType::get(Of->getContext(), Bytes * 8), Value);
  if (Of->isPointerTy())
    return ConstantExpr::getIntToPtr(Integer, Of);
  return Of == Integer->getType() ? Integer : nullptr;
}

void foldConstants(Function &Handler, const CodeSubject &Subject) {
  const DataLayout &Layout = Handler.getDataLayout();
  const Argument *Runner = Handler.getArg(4);
  for (llvm::Instruction &I : make_early_inc_range(instructions(Handler))) {
    auto *Load = dyn_cast<LoadInst>(&I);
    if (!Load)
      continue;
    APInt Offset(64, 0);
    const Value *Base =
        Load->getPointerOperand()->stripAndAccumulateConstantOffsets(
            Layout, Offset, /*AllowNonInbounds=*/true);
    if (Base != Runner)
      continue;
    uint64_t At = Offset.getZExtValue();
    if (At == offsetof(TmRunnerState, Memory) && !Subject.HasMemorySystem) {
      Load->replaceAllUsesWith(Constant::getNullValue(Load->getType()));
      Load->eraseFromParent();
      continue;
    }
    uint64_t InContext = At - offsetof(TmRunnerState, Chip);
    if (InContext >= sizeof(ChipContext))
      continue;
    if (Constant *Known =
            constantAt(*Subject.Context, InContext, Load->getType(), Layout)) {
      Load->replaceAllUsesWith(Known);
      Load->eraseFromParent();
    }
  }
}

} // namespace tp
