//===- InstructionText.cpp - Decodes and prints instructions --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/InstructionText.h"
#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/Support/raw_ostream.h"
#include <algorithm>

using namespace llvm;

namespace tp {

InstructionText::InstructionText(const ObjectInput &Input, bool Aliases)
    : Input(Input), Disassembler(Code.createDisassembler()),
      Printer(Code.createPrinter()) {
  if (!Aliases)
    Printer->applyTargetSpecificCLOption("no-aliases");
}

const MCExpr *InstructionText::expressionOf(const Relocation &Relocation) {
  MCContext &Context = Code.Context;
  const MCExpr *Value;
  if (Relocation.SymbolIndex) {
    StringRef Name = Input.symbols()[*Relocation.SymbolIndex].Name;
    Value = MCSymbolRefExpr::create(Context.getOrCreateSymbol(Name), Context);
    if (Relocation.Addend != 0)
      Value = MCBinaryExpr::createAdd(
          Value, MCConstantExpr::create(Relocation.Addend, Context), Context);
  } else {
    Value = MCConstantExpr::create(Relocation.Addend, Context);
  }
  switch (Relocation.Type) {
  case TPELF::R_TP_HI16:
    return MCSpecifierExpr::create(Value, TPII::MO_HI, Context);
  case TPELF::R_TP_LO16:
    return MCSpecifierExpr::create(Value, TPII::MO_LO, Context);
  case TPELF::R_TP_PC16:
  case TPELF::R_TP_PC26:
    return Value;
  default:
    return nullptr;
  }
}

std::optional<MCInst> InstructionText::decode(const Section &Section,
                                              uint32_t Offset) {
  MCInst Instruction;
  uint64_t Size;
  if (Disassembler->getInstruction(
          Instruction, Size, Section.Contents.drop_front(Offset),
          Section.Address + Offset, nulls()) != MCDisassembler::Success)
    return std::nullopt;
  auto Relocation =
      std::lower_bound(Section.Relocations.begin(), Section.Relocations.end(),
                       Offset, [](const tp::Relocation &Entry, uint32_t Place) {
                         return Entry.Offset < Place;
                       });
  unsigned NumOperands = Instruction.getNumOperands();
  if (Relocation != Section.Relocations.end() && Relocation->Offset == Offset &&
      NumOperands != 0 && Instruction.getOperand(NumOperands - 1).isImm())
    if (const MCExpr *Expression = expressionOf(*Relocation))
      Instruction.getOperand(NumOperands - 1) =
          MCOperand::createExpr(Expression);
  return Instruction;
}

std::optional<uint32_t> InstructionText::targetOf(const MCInst &Instruction,
                                                  uint32_t Address) const {
  uint64_t Target;
  if (!Code.Analysis->evaluateBranch(Instruction, Address, 4, Target))
    return std::nullopt;
  return Target;
}

void InstructionText::setTarget(MCInst &Branch, StringRef Label) {
  Branch.getOperand(Branch.getNumOperands() - 1) =
      MCOperand::createExpr(MCSymbolRefExpr::create(
          Code.Context.getOrCreateSymbol(Label), Code.Context));
}

std::string InstructionText::print(const MCInst &Instruction,
                                   std::optional<uint32_t> Address) {
  std::string Text;
  raw_string_ostream Stream(Text);
  Printer->setPrintBranchImmAsAddress(Address.has_value());
  Printer->printInst(&Instruction, Address.value_or(0), "", *Code.Subtarget,
                     Stream);
  return Text;
}

} // namespace tp
