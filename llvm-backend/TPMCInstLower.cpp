//===- TPMCInstLower.cpp - From machine instructions to MC ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPMCInstLower.h"
#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm/CodeGen/AsmPrinter.h"
#include "llvm/CodeGen/MachineBasicBlock.h"
#include "llvm/CodeGen/MachineInstr.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/MC/MCInst.h"

using namespace llvm;

static MCSymbol *getSymbol(const MachineOperand &Operand, AsmPrinter &Printer) {
  switch (Operand.getType()) {
  case MachineOperand::MO_MachineBasicBlock:
    return Operand.getMBB()->getSymbol();
  case MachineOperand::MO_GlobalAddress:
    return Printer.getSymbol(Operand.getGlobal());
  case MachineOperand::MO_ExternalSymbol:
    return Printer.GetExternalSymbolSymbol(Operand.getSymbolName());
  case MachineOperand::MO_ConstantPoolIndex:
    return Printer.GetCPISymbol(Operand.getIndex());
  case MachineOperand::MO_JumpTableIndex:
    return Printer.GetJTISymbol(Operand.getIndex());
  case MachineOperand::MO_BlockAddress:
    return Printer.GetBlockAddressSymbol(Operand.getBlockAddress());
  case MachineOperand::MO_MCSymbol:
    return Operand.getMCSymbol();
  default:
    llvm_unreachable("operand has no symbol");
  }
}

static int64_t getSymbolOffset(const MachineOperand &Operand) {
  return Operand.isMBB() || Operand.isJTI() || Operand.isMCSymbol()
             ? 0
             : Operand.getOffset();
}

bool TPMCInstLower::lowerOperand(const MachineOperand &Operand,
                                 MCOperand &Result) const {
  switch (Operand.getType()) {
  case MachineOperand::MO_RegisterMask:
    return false;
  case MachineOperand::MO_Register:
    if (Operand.isImplicit())
      return false;
    Result = MCOperand::createReg(Operand.getReg());
    return true;
  case MachineOperand::MO_Immediate:
    Result = MCOperand::createImm(Operand.getImm());
    return true;
  default:
    break;
  }
  MCContext &Context = Printer.OutContext;
  const MCExpr *Expr =
      MCSymbolRefExpr::create(getSymbol(Operand, Printer), Context);
  if (int64_t Offset = getSymbolOffset(Operand))
    Expr = MCBinaryExpr::createAdd(
        Expr, MCConstantExpr::create(Offset, Context), Context);
  if (unsigned Flags = Operand.getTargetFlags())
    Expr = MCSpecifierExpr::create(Expr, Flags, Context);
  Result = MCOperand::createExpr(Expr);
  return true;
}

static unsigned getMachineOpcode(unsigned Opcode) {
  switch (Opcode) {
  case TP::RET:
  case TP::TAIL_JR:
    return TP::JR;
  case TP::TAIL_J:
    return TP::J;
  case TP::HALT_CALL:
    return TP::HALT;
  case TP::MFSR_COUNTER:
    return TP::MFSR;
  default:
    return Opcode;
  }
}

void TPMCInstLower::lower(const MachineInstr &MI, MCInst &Inst) const {
  Inst.setOpcode(getMachineOpcode(MI.getOpcode()));
  if (MI.getOpcode() == TP::RET) {
    Inst.addOperand(MCOperand::createReg(TP::R31));
    return;
  }
  for (const MachineOperand &Operand : MI.operands()) {
    MCOperand Result;
    if (lowerOperand(Operand, Result))
      Inst.addOperand(Result);
  }
}
