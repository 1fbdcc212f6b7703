//===- Disassembly.h - Listing of a file's instructions ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_DISASSEMBLY_H
#define TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_DISASSEMBLY_H

#include "llvm-backend/tools/tp-objdump/InstructionText.h"
#include "llvm-backend/tools/tp-objdump/SourceLines.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

struct DisassemblyOptions {
  bool Relocations = false;
  bool LineNumbers = false;
  bool Source = false;
};

/// Prints every section of instructions: address, word, text, and the symbol
/// that a branch goes to.
void printDisassembly(const ObjectInput &Input, InstructionText &Text,
                      const DisassemblyOptions &Options, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_DISASSEMBLY_H
