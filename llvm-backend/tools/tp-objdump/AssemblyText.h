//===- AssemblyText.h - A file's code for the assembler ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_ASSEMBLYTEXT_H
#define TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_ASSEMBLYTEXT_H

#include "llvm-backend/tools/tp-objdump/InstructionText.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Prints the sections of instructions so that tp-mc makes the same bytes,
/// relocations and symbols of them. Other sections are left out.
void printAssembly(const ObjectInput &Input, InstructionText &Text,
                   llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_ASSEMBLYTEXT_H
