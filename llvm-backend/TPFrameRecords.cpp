//===- TPFrameRecords.cpp - Writes what functions need of the stack -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPFrameRecords.h"
#include "llvm-backend/MCTargetDesc/TPFrameRecord.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/BinaryFormat/ELF.h"
#include "llvm/CodeGen/MachineFrameInfo.h"
#include "llvm/CodeGen/MachineFunction.h"
#include "llvm/CodeGen/TargetFrameLowering.h"
#include "llvm/CodeGen/TargetRegisterInfo.h"
#include "llvm/CodeGen/TargetSubtargetInfo.h"
#include "llvm/IR/DerivedTypes.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/InstrTypes.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCSectionELF.h"
#include "llvm/MC/MCStreamer.h"
#include "llvm/Support/raw_ostream.h"
#include "llvm/Support/xxhash.h"

using namespace llvm;

// Structures by their members: their names differ from unit to unit.
static void describe(const Type *T, raw_ostream &OS) {
  if (!T->isSized() && !T->isVoidTy() && !T->isFunctionTy()) {
    OS << '?';
    return;
  }
  if (const auto *Structure = dyn_cast<StructType>(T)) {
    OS << '{';
    for (const Type *Member : Structure->elements())
      describe(Member, OS);
    OS << '}';
    return;
  }
  if (const auto *Function = dyn_cast<FunctionType>(T)) {
    for (const Type *Parameter : Function->params())
      describe(Parameter, OS);
    OS << (Function->isVarArg() ? "...>" : ">");
    describe(Function->getReturnType(), OS);
    return;
  }
  if (T->isArrayTy()) {
    OS << '[' << T->getArrayNumElements();
    describe(T->getArrayElementType(), OS);
    OS << ']';
    return;
  }
  T->print(OS, /*IsForDebug=*/false, /*NoDetails=*/true);
  OS << ',';
}

static uint32_t typeNumber(const FunctionType *T) {
  std::string Text;
  raw_string_ostream OS(Text);
  describe(T, OS);
  constexpr uint32_t Flag = TPFrameRecord::TailCallFlag;
  const uint32_t Number = static_cast<uint32_t>(xxh3_64bits(Text)) & ~Flag;
  return Number == TPFrameRecord::AnyType ? 2 : Number;
}

static uint32_t frameBytes(const MachineFunction &MF) {
  const MachineFrameInfo &MFI = MF.getFrameInfo();
  if (MFI.hasVarSizedObjects())
    return TPFrameRecord::DynamicSize;
  uint64_t Bytes = MFI.getStackSize();
  const TargetSubtargetInfo &STI = MF.getSubtarget();
  // Where the caller's stack pointer is aligned to less, up to the difference
  // is lost.
  if (STI.getRegisterInfo()->hasStackRealignment(MF))
    Bytes += MFI.getMaxAlign().value() -
             STI.getFrameLowering()->getStackAlign().value();
  return static_cast<uint32_t>(
      std::min<uint64_t>(Bytes, TPFrameRecord::DynamicSize - 1));
}

void TPFrameRecords::add(const MachineFunction &MF, const MCSymbol *Function) {
  Record New{Function,
             frameBytes(MF),
             typeNumber(MF.getFunction().getFunctionType()),
             0,
             {}};
  uint32_t RegisterTailCalls = 0;
  for (const MachineBasicBlock &MBB : MF)
    for (const MachineInstr &MI : MBB) {
      New.RegisterCallCount += MI.getOpcode() == TP::JALR;
      RegisterTailCalls += MI.getOpcode() == TP::TAIL_JR;
    }
  if (New.RegisterCallCount + RegisterTailCalls != 0) {
    // The instructions do not say which of the calls they are.
    const uint32_t Flag =
        New.RegisterCallCount == 0 ? TPFrameRecord::TailCallFlag : 0;
    for (const Instruction &I : instructions(MF.getFunction()))
      if (const auto *Call = dyn_cast<CallBase>(&I);
          Call && Call->isIndirectCall())
        New.CalleeTypes.push_back(typeNumber(Call->getFunctionType()) | Flag);
    if (New.CalleeTypes.empty())
      New.CalleeTypes.push_back(TPFrameRecord::AnyType | Flag);
    llvm::sort(New.CalleeTypes);
    New.CalleeTypes.erase(llvm::unique(New.CalleeTypes), New.CalleeTypes.end());
  }
  Records.push_back(std::move(New));
}

void TPFrameRecords::emit(MCStreamer &Streamer) {
  if (Records.empty())
    return;
  constexpr unsigned WordBytes = 4;
  Streamer.switchSection(Streamer.getContext().getELFSection(
      TPFrameRecord::SectionName, ELF::SHT_PROGBITS, ELF::SHF_EXCLUDE));
  for (const Record &R : Records) {
    Streamer.emitSymbolValue(R.Function, WordBytes);
    for (uint32_t Word : {R.FrameBytes, R.OwnType, R.RegisterCallCount,
                          static_cast<uint32_t>(R.CalleeTypes.size())})
      Streamer.emitIntValue(Word, WordBytes);
    for (uint32_t Type : R.CalleeTypes)
      Streamer.emitIntValue(Type, WordBytes);
  }
  Records.clear();
}
