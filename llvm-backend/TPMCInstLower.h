//===- TPMCInstLower.h - From machine instructions to MC --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPMCINSTLOWER_H
#define TP_LLVM_BACKEND_TPMCINSTLOWER_H

namespace llvm {

class AsmPrinter;
class MCInst;
class MCOperand;
class MachineInstr;
class MachineOperand;

/// Turns the code generator's instructions into those of the assembler.
class TPMCInstLower {
  AsmPrinter &Printer;

public:
  explicit TPMCInstLower(AsmPrinter &Printer) : Printer(Printer) {}

  void lower(const MachineInstr &MI, MCInst &Inst) const;

  /// Returns false for an operand that has no counterpart (implicit registers,
  /// register masks).
  bool lowerOperand(const MachineOperand &Operand, MCOperand &Result) const;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPMCINSTLOWER_H
