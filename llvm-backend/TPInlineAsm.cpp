//===- TPInlineAsm.cpp - Constraints of inline assembly -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
//   r  integer register        I  signed 16-bit constant
//   f  float register          J  zero
//   m  memory: imm(register)   K  unsigned 16-bit constant
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPISelLowering.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/CodeGen/SelectionDAG.h"
#include "llvm/Support/ErrorHandling.h"

using namespace llvm;

TargetLowering::ConstraintType
TPTargetLowering::getConstraintType(StringRef Constraint) const {
  if (Constraint.size() == 1) {
    switch (Constraint[0]) {
    case 'f':
      return C_RegisterClass;
    case 'I':
    case 'J':
    case 'K':
      return C_Immediate;
    default:
      break;
    }
  }
  return TargetLowering::getConstraintType(Constraint);
}

/// The register of the assembler's name \p Name, or none.
static MCRegister getRegister(StringRef Name, const TargetRegisterInfo &TRI) {
  Name.consume_front("$");
  MCRegister Alternative = StringSwitch<MCRegister>(Name)
                               .Case("zero", TP::R0)
                               .Case("sp", TP::R29)
                               .Case("fp", TP::R30)
                               .Case("ra", TP::R31)
                               .Default(MCRegister());
  if (Alternative)
    return Alternative;
  for (const TargetRegisterClass *Class : {&TP::GPRRegClass, &TP::FPRRegClass})
    for (MCRegister Reg : *Class)
      if (Name.equals_insensitive(TRI.getRegAsmName(Reg)))
        return Reg;
  return MCRegister();
}

std::pair<unsigned, const TargetRegisterClass *>
TPTargetLowering::getRegForInlineAsmConstraint(const TargetRegisterInfo *TRI,
                                               StringRef Constraint,
                                               MVT VT) const {
  if (Constraint == "r")
    return {0, &TP::GPRRegClass};
  if (Constraint == "f")
    return {0, &TP::FPRRegClass};
  StringRef Name = Constraint;
  if (Name.consume_front("{") && Name.consume_back("}"))
    if (MCRegister Reg = getRegister(Name, *TRI))
      return {Reg.id(), TP::GPRRegClass.contains(Reg) ? &TP::GPRRegClass
                                                      : &TP::FPRRegClass};
  return TargetLowering::getRegForInlineAsmConstraint(TRI, Constraint, VT);
}

void TPTargetLowering::LowerAsmOperandForConstraint(SDValue Op,
                                                    StringRef Constraint,
                                                    std::vector<SDValue> &Ops,
                                                    SelectionDAG &DAG) const {
  if (Constraint.size() != 1 || !StringRef("IJK").contains(Constraint[0])) {
    TargetLowering::LowerAsmOperandForConstraint(Op, Constraint, Ops, DAG);
    return;
  }
  auto *Constant = dyn_cast<ConstantSDNode>(Op);
  if (!Constant)
    return;
  const int64_t Value = Constant->getSExtValue();
  const bool Fits = Constraint[0] == 'I'   ? isInt<16>(Value)
                    : Constraint[0] == 'J' ? Value == 0
                                           : isUInt<16>(Value);
  if (Fits)
    Ops.push_back(DAG.getSignedTargetConstant(Value, SDLoc(Op), MVT::i32));
}

Register TPTargetLowering::getRegisterByName(const char *RegName, LLT,
                                             const MachineFunction &MF) const {
  MCRegister Reg = getRegister(RegName, *STI.getRegisterInfo());
  if (Reg && STI.getRegisterInfo()->getReservedRegs(MF).test(Reg.id()))
    return Reg;
  reportFatalUsageError(Twine("register '") + RegName +
                        "' is not reserved, so it cannot be a global variable");
}
