//===- InstructionText.h - Decodes and prints instructions ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_INSTRUCTIONTEXT_H
#define TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_INSTRUCTIONTEXT_H

#include "llvm-backend/MachineCode/MachineCode.h"
#include "llvm-backend/tools/tp-objdump/ObjectInput.h"
#include "llvm/MC/MCInst.h"
#include <optional>
#include <string>

namespace tp {

/// Decodes the instructions of a file and makes text of them, with symbols in
/// the place of what relocations will fill.
class InstructionText {
public:
  InstructionText(const ObjectInput &Input, bool Aliases);

  /// The instruction at an offset of a section, if there is one. Its last
  /// operand is an expression where a relocation stands on it.
  std::optional<llvm::MCInst> decode(const Section &Section, uint32_t Offset);

  /// Address of a branch's target, if it is known before linking.
  std::optional<uint32_t> targetOf(const llvm::MCInst &Instruction,
                                   uint32_t Address) const;

  /// Makes a symbol the target of a branch.
  void setTarget(llvm::MCInst &Branch, llvm::StringRef Label);

  /// Tab, mnemonic, tab, operands. Targets without a symbol are addresses, or
  /// distances from the instruction where `Address` is nothing.
  std::string print(const llvm::MCInst &Instruction,
                    std::optional<uint32_t> Address);

private:
  const llvm::MCExpr *expressionOf(const Relocation &Relocation);

  const ObjectInput &Input;
  MachineCode Code;
  std::unique_ptr<llvm::MCDisassembler> Disassembler;
  std::unique_ptr<llvm::MCInstPrinter> Printer;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_INSTRUCTIONTEXT_H
