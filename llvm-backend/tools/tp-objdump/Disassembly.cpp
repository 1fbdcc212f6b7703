//===- Disassembly.cpp - Listing of a file's instructions -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/Disassembly.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

static void printLabels(const ObjectInput &Input, const Section &Section,
                        uint32_t Address, raw_ostream &OS) {
  auto [Begin, End] = Input.symbolsOf(Section).equal_range(Address);
  if (Begin != End)
    OS << '\n';
  for (const auto &[Value, Label] : make_range(Begin, End))
    OS << format_hex_no_prefix(Value, 8) << " <" << Label->Name << ">:\n";
}

static void printRelocations(const ObjectInput &Input, const Section &Section,
                             uint32_t Offset, raw_ostream &OS) {
  for (const Relocation &Relocation : Section.Relocations) {
    if (Relocation.Offset < Offset || Relocation.Offset >= Offset + 4)
      continue;
    OS << "\t\t\t"
       << format_hex_no_prefix(Section.Address + Relocation.Offset, 8) << ":  "
       << TPELF::getRelocationName(Relocation.Type) << '\t'
       << Input.targetOf(Relocation) << '\n';
  }
}

/// Prints the instruction or data at an offset; returns its bytes.
static uint32_t printWord(const ObjectInput &Input, InstructionText &Text,
                          const Section &Section, uint32_t Offset,
                          raw_ostream &OS) {
  uint32_t Address = Section.Address + Offset;
  ArrayRef<uint8_t> Rest = Section.Contents.drop_front(Offset);
  OS << format("%8x: ", Address);
  if (Rest.size() < 4) {
    OS << format_hex_no_prefix(Rest.front(), 2) << "      \t.byte\t"
       << format_hex(Rest.front(), 4) << '\n';
    return 1;
  }
  uint32_t Word = support::endian::read32le(Rest.data());
  OS << format_hex_no_prefix(Word, 8);
  std::optional<MCInst> Instruction = Text.decode(Section, Offset);
  if (!Instruction) {
    OS << "\t.4byte\t" << format_hex(Word, 10) << '\n';
    return 4;
  }
  OS << Text.print(*Instruction, Address);
  if (std::optional<uint32_t> Target = Text.targetOf(*Instruction, Address)) {
    const tp::Section *Place =
        Input.isRelocatable() ? &Section : Input.sectionAt(*Target);
    std::string Name = Place ? Input.nameOf(*Place, *Target) : "";
    if (!Name.empty())
      OS << ' ' << Name;
  }
  OS << '\n';
  return 4;
}

void printDisassembly(const ObjectInput &Input, InstructionText &Text,
                      const DisassemblyOptions &Options, raw_ostream &OS) {
  SourceLines Lines(Input, Options.LineNumbers, Options.Source);
  for (const Section &Section : Input.sections()) {
    if (!Section.isCode() || Section.Contents.empty())
      continue;
    OS << "\nDisassembly of section " << Section.Name << ":\n";
    if (Input.symbolsOf(Section).count(Section.Address) == 0)
      OS << '\n';
    uint32_t Size;
    for (uint32_t Offset = 0; Offset < Section.Contents.size();
         Offset += Size) {
      uint32_t Address = Section.Address + Offset;
      printLabels(Input, Section, Address, OS);
      Lines.print(Section, Address, OS);
      Size = printWord(Input, Text, Section, Offset, OS);
      if (Options.Relocations)
        printRelocations(Input, Section, Offset, OS);
    }
  }
}

} // namespace tp
