//===- TPAsmPrinter.cpp - From machine functions to assembly --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckPass.h"
#include "llvm-backend/FloatingPoint/FloatingPointUnits.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm-backend/MCTargetDesc/TPInstPrinter.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TP.h"
#include "llvm-backend/TPAtomicAccesses.h"
#include "llvm-backend/TPFrameRecords.h"
#include "llvm-backend/TPMCInstLower.h"
#include "llvm-backend/TargetInfo/TPTargetInfo.h"
#include "llvm/BinaryFormat/ELF.h"
#include "llvm/CodeGen/AsmPrinter.h"
#include "llvm/CodeGen/MachineFunction.h"
#include "llvm/CodeGen/MachineInstr.h"
#include "llvm/InitializePasses.h"
#include "llvm/MC/MCAsmInfo.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/MC/MCInst.h"
#include "llvm/MC/MCSectionELF.h"
#include "llvm/MC/MCStreamer.h"
#include "llvm/MC/TargetRegistry.h"

using namespace llvm;

#define DEBUG_TYPE "tp-asm-printer"

namespace {

class TPAsmPrinter : public AsmPrinter {
  TPMCInstLower Lowering;
  TPFrameRecords Frames;
  TPAtomicAccesses Atomics;

public:
  static char ID;

  TPAsmPrinter(TargetMachine &TM, std::unique_ptr<MCStreamer> Streamer)
      : AsmPrinter(TM, std::move(Streamer), ID), Lowering(*this) {}

  StringRef getPassName() const override { return "TP Assembly Printer"; }

  void emitInstruction(const MachineInstr *MI) override;
  void emitFunctionBodyEnd() override;
  void emitEndOfAsmFile(Module &M) override;
  bool PrintAsmOperand(const MachineInstr *MI, unsigned OpNo,
                       const char *ExtraCode, raw_ostream &OS) override;
  bool PrintAsmMemoryOperand(const MachineInstr *MI, unsigned OpNo,
                             const char *ExtraCode, raw_ostream &OS) override;

private:
  void printOperand(const MachineOperand &Operand, raw_ostream &OS);
};

} // namespace

char TPAsmPrinter::ID = 0;

INITIALIZE_PASS(TPAsmPrinter, DEBUG_TYPE, "TP Assembly Printer", false, false)

void llvm::registerTPAsmPrinter() {
  RegisterAsmPrinter<TPAsmPrinter> X(getTheTPTarget());
}

void TPAsmPrinter::emitInstruction(const MachineInstr *MI) {
  Atomics.add(*MI, *OutStreamer);
  MCInst Inst;
  Lowering.lower(*MI, Inst);
  EmitToStreamer(*OutStreamer, Inst);
}

/// Notes the function's frame for the linker, and lists a checked function for
/// the simulator, which traps there what a chip that flushes subnormals would
/// lose.
void TPAsmPrinter::emitFunctionBodyEnd() {
  Frames.add(*MF, CurrentFnSym);
  if (!MF->getFunction().hasFnAttribute(CheckedFunctionAttribute))
    return;
  MCSymbol *End = createTempSymbol("checked_end");
  OutStreamer->emitLabel(End);
  OutStreamer->pushSection();
  OutStreamer->switchSection(OutContext.getELFSection(
      TPELF::CheckedFunctionsSection, ELF::SHT_PROGBITS, /*Flags=*/0));
  OutStreamer->emitSymbolValue(CurrentFnSym, 4);
  OutStreamer->emitAbsoluteSymbolDiff(End, CurrentFnSym, 4);
  OutStreamer->popSection();
}

/// Tells the linker what the functions take from the stack, and what the unit
/// assumes of infinities; the simulator, which accesses are atomic.
void TPAsmPrinter::emitEndOfAsmFile(Module &M) {
  Frames.emit(*OutStreamer);
  Atomics.emit(*OutStreamer);
  SmallVector<FloatingPointUnit> Units = floatingPointUnits(M);
  if (Units.empty())
    return;
  OutStreamer->switchSection(OutContext.getELFSection(
      FloatingPointUnitsSection, ELF::SHT_PROGBITS, ELF::SHF_EXCLUDE));
  OutStreamer->emitBytes(encodeFloatingPointUnits(Units));
}

void TPAsmPrinter::printOperand(const MachineOperand &Operand,
                                raw_ostream &OS) {
  // A register that the source names is an implicit operand.
  if (Operand.isReg()) {
    OS << TPInstPrinter::getRegisterName(Operand.getReg());
    return;
  }
  MCOperand Result;
  if (!Lowering.lowerOperand(Operand, Result))
    return;
  if (Result.isImm())
    OS << Result.getImm();
  else
    MAI->printExpr(OS, *Result.getExpr());
}

/// The operand that holds word \p Word of the 64-bit value whose first register
/// is operand \p OpNo; null if the value has one register.
static const MachineOperand *getWord(const MachineInstr &MI, unsigned OpNo,
                                     unsigned Word) {
  const MachineOperand &Flags = MI.getOperand(OpNo - 1);
  if (!Flags.isImm() || !MI.getOperand(OpNo).isReg() ||
      InlineAsm::Flag(Flags.getImm()).getNumOperandRegisters() != 2)
    return nullptr;
  return &MI.getOperand(OpNo + Word);
}

bool TPAsmPrinter::PrintAsmOperand(const MachineInstr *MI, unsigned OpNo,
                                   const char *ExtraCode, raw_ostream &OS) {
  const MachineOperand *Operand = &MI->getOperand(OpNo);
  // The memory that a register points to.
  if (ExtraCode && StringRef(ExtraCode) == "a" && Operand->isReg()) {
    OS << "0(";
    printOperand(*Operand, OS);
    OS << ')';
    return false;
  }
  if (!AsmPrinter::PrintAsmOperand(MI, OpNo, ExtraCode, OS))
    return false;
  if (ExtraCode && ExtraCode[0]) {
    if (ExtraCode[1])
      return true;
    switch (ExtraCode[0]) {
    case 'z': // The zero register for a constant 0.
      if (Operand->isImm() && Operand->getImm() == 0) {
        OS << TPInstPrinter::getRegisterName(TP::R0);
        return false;
      }
      break;
    case 'L': // The low word of 64 bits.
      Operand = getWord(*MI, OpNo, 0);
      break;
    case 'D': // The second word of 64 bits.
    case 'M': // The high word.
      Operand = getWord(*MI, OpNo, 1);
      break;
    default:
      return true;
    }
    if (!Operand)
      return true;
  }
  printOperand(*Operand, OS);
  return false;
}

bool TPAsmPrinter::PrintAsmMemoryOperand(const MachineInstr *MI, unsigned OpNo,
                                         const char *ExtraCode,
                                         raw_ostream &OS) {
  const MachineOperand &Offset = MI->getOperand(OpNo + 1);
  bool IsSecondWord = ExtraCode && ExtraCode[0] == 'D' && !ExtraCode[1];
  if (ExtraCode && ExtraCode[0] && !IsSecondWord)
    return true;
  if (IsSecondWord && Offset.isImm())
    OS << Offset.getImm() + 4;
  else
    printOperand(Offset, OS);
  if (IsSecondWord && !Offset.isImm())
    OS << "+4";
  OS << '(';
  printOperand(MI->getOperand(OpNo), OS);
  OS << ')';
  return false;
}
