//===- TPInstPrinter.h - Instructions as text -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MCTARGETDESC_TPINSTPRINTER_H
#define TP_LLVM_BACKEND_MCTARGETDESC_TPINSTPRINTER_H

#include "llvm/MC/MCInstPrinter.h"

namespace llvm {

class TPInstPrinter : public MCInstPrinter {
public:
  using MCInstPrinter::MCInstPrinter;

  /// Knows "no-aliases": instructions under their own names.
  bool applyTargetSpecificCLOption(StringRef Option) override;
  void printInst(const MCInst *MI, uint64_t Address, StringRef Annot,
                 const MCSubtargetInfo &STI, raw_ostream &O) override;
  void printRegName(raw_ostream &O, MCRegister Reg) override;

  // Made by TableGen.
  std::pair<const char *, uint64_t>
  getMnemonic(const MCInst &MI) const override;
  void printInstruction(const MCInst *MI, uint64_t Address, raw_ostream &O);
  bool printAliasInstr(const MCInst *MI, uint64_t Address, raw_ostream &O);
  void printCustomAliasOperand(const MCInst *MI, uint64_t Address,
                               unsigned OpIdx, unsigned PrintMethodIdx,
                               raw_ostream &O);
  static const char *getRegisterName(MCRegister Reg);

private:
  void printOperand(const MCInst *MI, unsigned OpNo, raw_ostream &O);
  /// Prints the distance in bytes, or the address where the printer is told to
  /// (setPrintBranchImmAsAddress).
  void printPCRelativeTarget(const MCInst *MI, uint64_t Address, unsigned OpNo,
                             raw_ostream &O);
  void printSpecialRegister(const MCInst *MI, unsigned OpNo, raw_ostream &O);
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_MCTARGETDESC_TPINSTPRINTER_H
