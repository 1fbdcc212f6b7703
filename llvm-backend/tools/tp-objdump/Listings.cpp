//===- Listings.cpp - Tables of sections and symbols ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/Listings.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/FormatVariadic.h"

using namespace llvm;

namespace tp {

static StringRef kindOf(const Section &Section) {
  if (Section.Flags & ELF::SHF_EXECINSTR)
    return "TEXT";
  if (!(Section.Flags & ELF::SHF_ALLOC))
    return Section.Name.starts_with(".debug") ? "DEBUG" : "";
  if (Section.Type == ELF::SHT_NOBITS)
    return "BSS";
  return "DATA";
}

void printSections(const ObjectInput &Input, raw_ostream &OS) {
  OS << "\nSections:\nIdx Name               Size     Address  Type\n";
  for (const Section &Section : Input.sections())
    OS << formatv("{0,3} {1,-18} {2:x-8} {3:x-8} {4}\n", Section.Index,
                  Section.Name, Section.Size, Section.Address, kindOf(Section));
}

static char bindingOf(const Symbol &Symbol) {
  switch (Symbol.Binding) {
  case ELF::STB_LOCAL:
    return 'l';
  case ELF::STB_GLOBAL:
    return 'g';
  case ELF::STB_WEAK:
    return 'w';
  default:
    return ' ';
  }
}

static StringRef typeOf(const Symbol &Symbol) {
  switch (Symbol.Type) {
  case ELF::STT_FUNC:
    return "function";
  case ELF::STT_OBJECT:
    return "object";
  case ELF::STT_TLS:
    return "tls";
  case ELF::STT_SECTION:
    return "section";
  case ELF::STT_FILE:
    return "file";
  default:
    return "";
  }
}

static StringRef placeOf(const ObjectInput &Input, const Symbol &Symbol) {
  if (Symbol.Section == ELF::SHN_UNDEF)
    return "*UND*";
  if (Symbol.Section == ELF::SHN_ABS)
    return "*ABS*";
  if (Symbol.Section == ELF::SHN_COMMON)
    return "*COM*";
  if (Symbol.Section < Input.sections().size())
    return Input.sections()[Symbol.Section].Name;
  return "*???*";
}

void printSymbols(const ObjectInput &Input, raw_ostream &OS) {
  OS << "\nSymbols:\n";
  for (const Symbol &Symbol :
       Input.symbols().drop_front(Input.symbols().empty() ? 0 : 1))
    OS << formatv("{0:x-8} {1} {2,-8} {3,-12} {4:x-8} {5}\n", Symbol.Value,
                  bindingOf(Symbol), typeOf(Symbol), placeOf(Input, Symbol),
                  Symbol.Size, Symbol.Name);
}

void printRelocations(const ObjectInput &Input, raw_ostream &OS) {
  for (const Section &Section : Input.sections()) {
    if (Section.Relocations.empty())
      continue;
    OS << "\nRelocations of " << Section.Name << ":\n";
    for (const Relocation &Relocation : Section.Relocations) {
      StringRef Name = TPELF::getRelocationName(Relocation.Type);
      OS << format_hex_no_prefix(Relocation.Offset, 8) << ' '
         << left_justify(Name.empty() ? "unknown" : Name, 11) << ' '
         << Input.targetOf(Relocation) << '\n';
    }
  }
}

} // namespace tp
