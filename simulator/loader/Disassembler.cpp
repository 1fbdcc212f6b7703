//===- Disassembler.cpp - Instructions as text ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/loader/Disassembler.h"

#include "llvm-backend/MachineCode/MachineCode.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/MC/MCDisassembler/MCDisassembler.h"
#include "llvm/MC/MCInst.h"
#include "llvm/Support/Endian.h"

#include <algorithm>

using namespace llvm;

namespace tp {

struct Disassembler::Backend {
  MachineCode Code;
  std::unique_ptr<MCDisassembler> Decoder = Code.createDisassembler();
  std::unique_ptr<MCInstPrinter> Printer = Code.createPrinter();
};

Disassembler::Disassembler() : Implementation(std::make_unique<Backend>()) {
  Implementation->Printer->setPrintBranchImmAsAddress(true);
}

Disassembler::~Disassembler() = default;

std::string Disassembler::print(uint32_t Word, uint32_t Pc) {
  uint8_t Bytes[4];
  support::endian::write32le(Bytes, Word);
  MCInst Instruction;
  uint64_t Size;
  if (Implementation->Decoder->getInstruction(
          Instruction, Size, Bytes, Pc, nulls()) != MCDisassembler::Success)
    return ".word 0x" + utohexstr(Word, /*LowerCase=*/true, 8);
  std::string Text;
  raw_string_ostream Stream(Text);
  Implementation->Printer->printInst(&Instruction, Pc, "",
                                     *Implementation->Code.Subtarget, Stream);
  std::ranges::replace(Text, '\t', ' ');
  return StringRef(Text).trim().str();
}

} // namespace tp
