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
/// assumes of infinities.
void TPAsmPrinter::emitEndOfAsmFile(Module &M) {
  Frames.emit(*OutStreamer);
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

bool TPAsmPrinter::PrintAsmOperand(const MachineInstr *MI, unsigned OpNo,
                                   const char *ExtraCode, raw_ostream &OS) {
  if (!AsmPrinter::PrintAsmOperand(MI, OpNo, ExtraCode, OS))
    return false;
  const MachineOperand &Operand = MI->getOperand(OpNo);
  if (ExtraCode && ExtraCode[0]) {
    // `z` names the zero register for a constant 0.
    if (ExtraCode[0] != 'z' || ExtraCode[1])
      return true;
    if (Operand.isImm() && Operand.getImm() == 0) {
      OS << TPInstPrinter::getRegisterName(TP::R0);
      return false;
    }
  }
  printOperand(Operand, OS);
  return false;
}

bool TPAsmPrinter::PrintAsmMemoryOperand(const MachineInstr *MI, unsigned OpNo,
                                         const char *ExtraCode,
                                         raw_ostream &OS) {
  if (ExtraCode && ExtraCode[0])
    return true;
  printOperand(MI->getOperand(OpNo + 1), OS);
  OS << '(';
  printOperand(MI->getOperand(OpNo), OS);
  OS << ')';
  return false;
}
