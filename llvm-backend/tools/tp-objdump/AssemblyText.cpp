//===- AssemblyText.cpp - A file's code for the assembler -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/AssemblyText.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/Format.h"
#include <map>

using namespace llvm;

namespace tp {

namespace {

/// Prints one section.
class SectionPrinter {
public:
  SectionPrinter(const ObjectInput &Input, InstructionText &Text,
                 const Section &Section, raw_ostream &OS)
      : Input(Input), Text(Text), Section(Section), OS(OS) {}

  void print();

private:
  void nameTargets();
  void printLabels(uint32_t Address);
  void printWord(uint32_t Offset);

  const ObjectInput &Input;
  InstructionText &Text;
  const tp::Section &Section;
  raw_ostream &OS;
  /// Labels that branches need where no symbol stands.
  std::map<uint32_t, std::string> LocalLabels;
};

} // namespace

void SectionPrinter::nameTargets() {
  for (uint32_t Offset = 0; Offset + 4 <= Section.Contents.size();
       Offset += 4) {
    std::optional<MCInst> Instruction = Text.decode(Section, Offset);
    if (!Instruction)
      continue;
    auto Target = Text.targetOf(*Instruction, Section.Address + Offset);
    if (!Target || *Target < Section.Address ||
        *Target - Section.Address > Section.Contents.size())
      continue;
    LocalLabels[*Target] = ".Lat_" + utohexstr(*Target, /*LowerCase=*/true);
  }
}

void SectionPrinter::printLabels(uint32_t Address) {
  auto [Begin, End] = Input.symbolsOf(Section).equal_range(Address);
  for (const auto &[Value, Label] : make_range(Begin, End)) {
    if (Label->Binding == ELF::STB_GLOBAL)
      OS << "\t.globl\t" << Label->Name << '\n';
    if (Label->Binding == ELF::STB_WEAK)
      OS << "\t.weak\t" << Label->Name << '\n';
    if (Label->Type == ELF::STT_FUNC)
      OS << "\t.type\t" << Label->Name << ",@function\n";
    if (Label->Size != 0)
      OS << "\t.size\t" << Label->Name << ", " << Label->Size << '\n';
    OS << Label->Name << ":\n";
  }
  auto Local = LocalLabels.find(Address);
  if (Local != LocalLabels.end())
    OS << Local->second << ":\n";
}

void SectionPrinter::printWord(uint32_t Offset) {
  uint32_t Address = Section.Address + Offset;
  if (std::optional<MCInst> Instruction = Text.decode(Section, Offset)) {
    auto Target = Text.targetOf(*Instruction, Address);
    if (Target && LocalLabels.count(*Target))
      Text.setTarget(*Instruction, LocalLabels[*Target]);
    OS << Text.print(*Instruction, std::nullopt) << '\n';
    return;
  }
  auto Relocation = find_if(Section.Relocations, [&](const auto &Entry) {
    return Entry.Offset == Offset;
  });
  OS << "\t.4byte\t";
  if (Relocation != Section.Relocations.end())
    OS << Input.targetOf(*Relocation);
  else
    OS << format_hex(support::endian::read32le(&Section.Contents[Offset]), 10);
  OS << '\n';
}

void SectionPrinter::print() {
  nameTargets();
  OS << "\t.section\t" << Section.Name << ",\"ax\",@progbits\n";
  uint32_t End = Section.Contents.size(), Offset = 0;
  for (; Offset + 4 <= End; Offset += 4) {
    printLabels(Section.Address + Offset);
    printWord(Offset);
  }
  printLabels(Section.Address + Offset);
  for (; Offset < End; ++Offset)
    OS << "\t.byte\t" << format_hex(Section.Contents[Offset], 4) << '\n';
}

void printAssembly(const ObjectInput &Input, InstructionText &Text,
                   raw_ostream &OS) {
  for (const Section &Section : Input.sections())
    if (Section.isCode())
      SectionPrinter(Input, Text, Section, OS).print();
}

} // namespace tp
