//===- ObjectInput.cpp - A TP object or executable ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/ObjectInput.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/MemoryBuffer.h"
#include <tuple>

using namespace llvm;
using namespace llvm::object;

namespace tp {

bool Section::isCode() const {
  return (Flags & ELF::SHF_EXECINSTR) && Type != ELF::SHT_NOBITS;
}

Expected<ObjectInput> ObjectInput::open(StringRef Path) {
  ErrorOr<std::unique_ptr<MemoryBuffer>> Buffer =
      MemoryBuffer::getFileOrSTDIN(Path);
  if (std::error_code Code = Buffer.getError())
    return createStringError(Code, Code.message());
  ObjectInput Input;
  Input.Buffer = std::move(*Buffer);
  MemoryBufferRef Bytes = Input.Buffer->getMemBufferRef();
  if (!Bytes.getBuffer().starts_with(ELF::ElfMagic))
    return createStringError("not an ELF file");
  auto [Class, Encoding] = getElfArchType(Bytes.getBuffer());
  if (Class != ELF::ELFCLASS32 || Encoding != ELF::ELFDATA2LSB)
    return createStringError(
        "not a TP file: it is not 32-bit little-endian ELF");
  auto File = ELF32LEObjectFile::create(Bytes);
  if (!File)
    return File.takeError();
  unsigned Machine = File->getELFFile().getHeader().e_machine;
  if (Machine != TPELF::EM_TP)
    return createStringError("not a TP file: its machine is " +
                             utostr(Machine) + ", the TP is " +
                             utostr(TPELF::EM_TP));
  Input.File = std::make_unique<ELF32LEObjectFile>(std::move(*File));
  if (Error Failure = Input.readSymbols())
    return Failure;
  if (Error Failure = Input.readSections())
    return Failure;
  return Input;
}

bool ObjectInput::isRelocatable() const { return File->isRelocatableObject(); }

Error ObjectInput::readSymbols() {
  const auto &Elf = File->getELFFile();
  auto Headers = Elf.sections();
  if (!Headers)
    return Headers.takeError();
  const auto *Table = find_if(*Headers, [](const auto &Header) {
    return Header.sh_type == ELF::SHT_SYMTAB;
  });
  if (Table == Headers->end())
    return Error::success();
  auto Entries = Elf.symbols(Table);
  if (!Entries)
    return Entries.takeError();
  auto Names = Elf.getStringTableForSymtab(*Table);
  if (!Names)
    return Names.takeError();
  for (const auto &Entry : *Entries) {
    auto Name = Entry.getName(*Names);
    if (!Name)
      return Name.takeError();
    if (Entry.getType() == ELF::STT_SECTION && Entry.st_shndx < Headers->size())
      Name = Elf.getSectionName((*Headers)[Entry.st_shndx]);
    if (!Name)
      return Name.takeError();
    Symbols.push_back({*Name, Entry.st_value, Entry.st_size, Entry.getType(),
                       Entry.getBinding(), Entry.st_shndx});
  }

  std::vector<const Symbol *> Labels;
  for (const Symbol &Symbol : Symbols)
    if (Symbol.Type != ELF::STT_SECTION && Symbol.Type != ELF::STT_FILE &&
        !Symbol.Name.empty())
      Labels.push_back(&Symbol);
  auto Rank = [](const Symbol *Symbol) {
    return std::tuple(Symbol->Type != ELF::STT_FUNC,
                      Symbol->Binding == ELF::STB_LOCAL, Symbol);
  };
  llvm::sort(Labels, [&](const Symbol *Left, const Symbol *Right) {
    return Rank(Left) < Rank(Right);
  });
  for (const Symbol *Label : Labels)
    SymbolsBySection[Label->Section].emplace(Label->Value, Label);
  return Error::success();
}

Error ObjectInput::readSections() {
  const auto &Elf = File->getELFFile();
  auto Headers = Elf.sections();
  if (!Headers)
    return Headers.takeError();
  for (const auto &[Index, Header] : enumerate(*Headers)) {
    auto Name = Elf.getSectionName(Header);
    if (!Name)
      return Name.takeError();
    Section Section{*Name,
                    uint32_t(Index),
                    Header.sh_addr,
                    Header.sh_size,
                    Header.sh_type,
                    Header.sh_flags,
                    {},
                    {}};
    if (Header.sh_type != ELF::SHT_NOBITS && Header.sh_type != ELF::SHT_NULL) {
      auto Contents = Elf.getSectionContents(Header);
      if (!Contents)
        return Contents.takeError();
      Section.Contents = *Contents;
    }
    Sections.push_back(std::move(Section));
  }

  for (const auto &Header : *Headers) {
    if (Header.sh_type != ELF::SHT_RELA)
      continue;
    if (Header.sh_info >= Sections.size())
      return createStringError("a relocation section names a section that does "
                               "not exist");
    auto Entries = Elf.relas(Header);
    if (!Entries)
      return Entries.takeError();
    std::vector<Relocation> &List = Sections[Header.sh_info].Relocations;
    for (const auto &Entry : *Entries) {
      uint32_t SymbolIndex = Entry.getSymbol(/*isMips64EL=*/false);
      if (SymbolIndex >= Symbols.size() && SymbolIndex != 0)
        return createStringError("a relocation names a symbol that does not "
                                 "exist");
      List.push_back(
          {Entry.r_offset, Entry.getType(/*isMips64EL=*/false), Entry.r_addend,
           SymbolIndex ? std::optional<size_t>(SymbolIndex) : std::nullopt});
    }
    llvm::sort(List, [](const Relocation &Left, const Relocation &Right) {
      return std::tie(Left.Offset, Left.Type) <
             std::tie(Right.Offset, Right.Type);
    });
  }
  return Error::success();
}

const ObjectInput::SymbolsByAddress &
ObjectInput::symbolsOf(const Section &Section) const {
  static const SymbolsByAddress None;
  auto Found = SymbolsBySection.find(Section.Index);
  return Found == SymbolsBySection.end() ? None : Found->second;
}

static std::string withOffset(StringRef Name, int64_t Offset) {
  if (Offset == 0)
    return Name.str();
  return (Name + (Offset < 0 ? "-0x" : "+0x") +
          utohexstr(Offset < 0 ? -Offset : Offset, /*LowerCase=*/true))
      .str();
}

std::string ObjectInput::nameOf(const Section &Section,
                                uint32_t Address) const {
  const SymbolsByAddress &Labels = symbolsOf(Section);
  auto Next = Labels.upper_bound(Address);
  if (Next == Labels.begin())
    return "";
  // The best of the symbols that stand at the same address.
  auto Best = Labels.find(std::prev(Next)->first);
  return "<" + withOffset(Best->second->Name, int64_t(Address) - Best->first) +
         ">";
}

const Section *ObjectInput::sectionAt(uint32_t Address) const {
  auto Found = find_if(Sections, [&](const Section &Section) {
    return (Section.Flags & ELF::SHF_ALLOC) && Address >= Section.Address &&
           Address - Section.Address < Section.Size;
  });
  return Found == Sections.end() ? nullptr : &*Found;
}

std::string ObjectInput::targetOf(const Relocation &Relocation) const {
  StringRef Name = Relocation.SymbolIndex
                       ? Symbols[*Relocation.SymbolIndex].Name
                       : StringRef("*ABS*");
  return withOffset(Name, Relocation.Addend);
}

} // namespace tp
