//===- TPAtomicAccesses.cpp - Lists atomic loads and stores ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPAtomicAccesses.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm-backend/TPInstrInfo.h"
#include "llvm/BinaryFormat/ELF.h"
#include "llvm/CodeGen/MachineFunction.h"
#include "llvm/CodeGen/MachineInstr.h"
#include "llvm/CodeGen/MachineMemOperand.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/MC/MCSectionELF.h"
#include "llvm/MC/MCStreamer.h"
#include "llvm/Support/AtomicOrdering.h"

using namespace llvm;

void TPAtomicAccesses::add(const MachineInstr &MI, MCStreamer &Streamer) {
  // Outlined code has none, and no memory operands that are its own.
  if (MI.isInlineAsm() || MI.getMF()->isOutlined())
    return;
  bool IsAtomic = false;
  uint32_t Flags = 0;
  for (const MachineMemOperand *Operand : MI.memoperands()) {
    IsAtomic |= Operand->isAtomic();
    if (Operand->getFlags() & TPII::MOPartOfWord)
      Flags |= TPELF::PartOfWordFlag;
    if (MI.mayLoad() && !MI.mayStore() &&
        isAcquireOrStronger(Operand->getSuccessOrdering()))
      Flags |= TPELF::AcquiresFlag;
  }
  const bool SaysSo = MI.mayLoad() && MI.mayStore();
  if (!IsAtomic || (SaysSo && !Flags))
    return;
  MCSymbol *Address = Streamer.getContext().createTempSymbol("atomic");
  Streamer.emitLabel(Address);
  Accesses.push_back({Address, Flags});
}

void TPAtomicAccesses::emit(MCStreamer &Streamer) {
  if (Accesses.empty())
    return;
  constexpr unsigned WordBytes = 4;
  MCContext &Context = Streamer.getContext();
  Streamer.switchSection(Context.getELFSection(TPELF::AtomicAccessesSection,
                                               ELF::SHT_PROGBITS, /*Flags=*/0));
  for (const Access &A : Accesses) {
    const MCExpr *Value = MCSymbolRefExpr::create(A.Address, Context);
    if (A.Flags)
      Value = MCBinaryExpr::createAdd(
          Value, MCConstantExpr::create(A.Flags, Context), Context);
    Streamer.emitValue(Value, WordBytes);
  }
  Accesses.clear();
}
