//===- TPInstPrinter.cpp - Instructions as text ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPInstPrinter.h"
#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm/MC/MCAsmInfo.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/MC/MCInst.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

#define DEBUG_TYPE "asm-printer"

#define PRINT_ALIAS_INSTR
#include "TPGenAsmWriter.inc"

bool TPInstPrinter::applyTargetSpecificCLOption(StringRef Option) {
  if (Option != "no-aliases")
    return false;
  PrintAliases = false;
  return true;
}

void TPInstPrinter::printInst(const MCInst *MI, uint64_t Address,
                              StringRef Annot, const MCSubtargetInfo &STI,
                              raw_ostream &O) {
  if (!PrintAliases || !printAliasInstr(MI, Address, O))
    printInstruction(MI, Address, O);
  printAnnotation(O, Annot);
}

void TPInstPrinter::printRegName(raw_ostream &O, MCRegister Reg) {
  markup(O, Markup::Register) << getRegisterName(Reg);
}

void TPInstPrinter::printOperand(const MCInst *MI, unsigned OpNo,
                                 raw_ostream &O) {
  const MCOperand &Op = MI->getOperand(OpNo);
  if (Op.isReg())
    printRegName(O, Op.getReg());
  else if (Op.isImm())
    markup(O, Markup::Immediate) << formatImm(Op.getImm());
  else
    MAI.printExpr(O, *Op.getExpr());
}

void TPInstPrinter::printPCRelativeTarget(const MCInst *MI, uint64_t Address,
                                          unsigned OpNo, raw_ostream &O) {
  const MCOperand &Op = MI->getOperand(OpNo);
  if (!Op.isImm() || !PrintBranchImmAsAddress)
    return printOperand(MI, OpNo, O);
  auto Target = static_cast<uint32_t>(Address + Op.getImm());
  markup(O, Markup::Target) << formatHex(uint64_t(Target));
}

void TPInstPrinter::printSpecialRegister(const MCInst *MI, unsigned OpNo,
                                         raw_ostream &O) {
  int64_t Encoding = MI->getOperand(OpNo).getImm();
  const auto *Register = TPSpecialRegister::lookupByEncoding(Encoding);
  if (Register)
    markup(O, Markup::Register) << Register->Name;
  else
    markup(O, Markup::Immediate) << formatImm(Encoding);
}
