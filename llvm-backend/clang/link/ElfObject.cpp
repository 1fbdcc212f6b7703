//===- ElfObject.cpp - Reads one relocatable object -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm-backend/MCTargetDesc/TPFrameRecord.h"
#include "llvm-backend/clang/link/ElfInput.h"
#include "llvm-backend/clang/link/Layout.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Object/Decompressor.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;
using namespace llvm::ELF;

namespace tp {

uint32_t InputSection::address(uint32_t Offset) const {
  return (Output ? Output->Address : 0) + OutputOffset + Offset;
}

uint32_t Symbol::address() const {
  return Section ? Section->address(Value) : Value;
}

static Error makeError(const Twine &Message) {
  return createStringError(inconvertibleErrorCode(), Message);
}

std::unique_ptr<ElfObject> ElfObject::read(MemoryBufferRef Buffer,
                                           StringRef DisplayName,
                                           SymbolTable &Globals,
                                           StringSet<> &ComdatGroups,
                                           LinkDiagnostics &Diags) {
  std::unique_ptr<ElfObject> Object(new ElfObject(DisplayName));
  auto ReadElf = [&]() -> Error {
    StringRef Text = Buffer.getBuffer();
    if (Text.size() < sizeof(ElfType::Ehdr) ||
        uint8_t(Text[EI_CLASS]) != ELFCLASS32 ||
        uint8_t(Text[EI_DATA]) != ELFDATA2LSB)
      return makeError("is not a 32-bit little-endian ELF object; compile it "
                       "with tpcc");
    Expected<File> Elf = File::create(Text);
    if (!Elf)
      return Elf.takeError();
    const ElfType::Ehdr &Header = Elf->getHeader();
    if (Header.e_machine != TPELF::EM_TP)
      return makeError("is for another machine (e_machine " +
                       Twine(Header.e_machine) + "); compile it with tpcc");
    if (Header.e_type != ET_REL)
      return makeError("is not a relocatable object");
    return Object->readAll(*Elf, Globals, ComdatGroups, Diags);
  };
  if (Error Failure = ReadElf()) {
    Diags.error(DisplayName + ": " + toString(std::move(Failure)));
    return nullptr;
  }
  return Object;
}

Error ElfObject::readAll(const File &Elf, SymbolTable &Globals,
                         StringSet<> &ComdatGroups, LinkDiagnostics &Diags) {
  if (Error Failure = readSections(Elf, ComdatGroups))
    return Failure;
  return readSymbols(Elf, Globals, Diags);
}

// A group that an earlier object has brought is dropped whole.
Error ElfObject::readGroup(const File &Elf, const ElfType::Shdr &Header,
                           StringSet<> &ComdatGroups,
                           std::vector<bool> &Dropped) {
  auto Members = Elf.getSectionContentsAsArray<ElfType::Word>(Header);
  if (!Members)
    return Members.takeError();
  auto SymbolTableHeader = Elf.getSection(Header.sh_link);
  if (!SymbolTableHeader)
    return SymbolTableHeader.takeError();
  auto Signature =
      Elf.getEntry<ElfType::Sym>(**SymbolTableHeader, Header.sh_info);
  if (!Signature)
    return Signature.takeError();
  auto Strings = Elf.getStringTableForSymtab(**SymbolTableHeader);
  if (!Strings)
    return Strings.takeError();
  auto SignatureName = (*Signature)->getName(*Strings);
  if (!SignatureName)
    return SignatureName.takeError();
  if (Members->empty() || !((*Members)[0] & GRP_COMDAT) ||
      ComdatGroups.insert(*SignatureName).second)
    return Error::success();
  for (uint32_t Member : Members->drop_front()) {
    if (Member >= Dropped.size())
      return makeError("section group names section " + Twine(Member) +
                       ", which does not exist");
    Dropped[Member] = true;
  }
  return Error::success();
}

// Sections that the linker takes into the program's image or debug data, or
// reads itself.
static bool isContent(const ElfType::Shdr &Header, StringRef Name) {
  if ((Header.sh_flags & SHF_EXCLUDE) && Name != TPFrameRecord::SectionName)
    return false;
  switch (Header.sh_type) {
  case SHT_PROGBITS:
  case SHT_NOBITS:
  case SHT_INIT_ARRAY:
  case SHT_FINI_ARRAY:
  case SHT_PREINIT_ARRAY:
  case SHT_NOTE:
    return true;
  default:
    return false;
  }
}

Error ElfObject::decompress(InputSection &Section) {
  auto Reader = object::Decompressor::create(
      Section.Name, toStringRef(Section.Bytes), /*IsLE=*/true,
      /*Is64Bit=*/false);
  if (!Reader)
    return Reader.takeError();
  const auto *Header =
      reinterpret_cast<const ElfType::Chdr *>(Section.Bytes.data());
  Section.Alignment = std::max<uint32_t>(1, Header->ch_addralign);
  SmallVector<uint8_t, 0> &Content = Decompressed.emplace_back();
  Content.resize(Reader->getDecompressedSize());
  if (Error Failure = Reader->decompress(Content))
    return Failure;
  Section.Bytes = Content;
  Section.Size = Content.size();
  Section.Flags &= ~SHF_COMPRESSED;
  return Error::success();
}

Error ElfObject::readSections(const File &Elf, StringSet<> &ComdatGroups) {
  auto Headers = Elf.sections();
  if (!Headers)
    return Headers.takeError();
  std::vector<bool> Dropped(Headers->size());
  for (const ElfType::Shdr &Header : *Headers)
    if (Header.sh_type == SHT_GROUP)
      if (Error Failure = readGroup(Elf, Header, ComdatGroups, Dropped))
        return Failure;

  Sections.resize(Headers->size());
  for (auto [Number, Header] : enumerate(*Headers)) {
    auto SectionName = Elf.getSectionName(Header);
    if (!SectionName)
      return SectionName.takeError();
    if (Dropped[Number] || !isContent(Header, *SectionName) ||
        *SectionName == ".note.GNU-stack")
      continue;
    auto Section = std::make_unique<InputSection>();
    Section->File = this;
    Section->Name = *SectionName;
    Section->Type = Header.sh_type;
    Section->Flags = Header.sh_flags;
    Section->Size = Header.sh_size;
    Section->Alignment = std::max<uint32_t>(1, Header.sh_addralign);
    if (!Section->isZeroFilled()) {
      auto Bytes = Elf.getSectionContents(Header);
      if (!Bytes)
        return Bytes.takeError();
      Section->Bytes = *Bytes;
    }
    if (Header.sh_flags & SHF_COMPRESSED)
      if (Error Failure = decompress(*Section))
        return Failure;
    if (!isPowerOf2_32(Section->Alignment))
      return makeError("section " + *SectionName + " has alignment " +
                       Twine(Section->Alignment) + ", not a power of two");
    Sections[Number] = std::move(Section);
  }

  for (const ElfType::Shdr &Header : *Headers) {
    if (Header.sh_type == SHT_REL)
      return makeError("has relocations without addends (SHT_REL)");
    if (Header.sh_type != SHT_RELA)
      continue;
    if (Header.sh_info >= Sections.size())
      return makeError("has relocations for section " + Twine(Header.sh_info) +
                       ", which does not exist");
    auto Relocations = Elf.relas(Header);
    if (!Relocations)
      return Relocations.takeError();
    if (InputSection *Section = Sections[Header.sh_info].get())
      Section->Relocations = *Relocations;
  }
  return Error::success();
}

Error ElfObject::readSymbols(const File &Elf, SymbolTable &Globals,
                             LinkDiagnostics &Diags) {
  const ElfType::Shdr *TableHeader = nullptr;
  auto Headers = Elf.sections();
  if (!Headers)
    return Headers.takeError();
  for (const ElfType::Shdr &Header : *Headers)
    if (Header.sh_type == SHT_SYMTAB)
      TableHeader = &Header;
  if (!TableHeader)
    return Error::success();
  auto Entries = Elf.symbols(TableHeader);
  if (!Entries)
    return Entries.takeError();
  auto Strings = Elf.getStringTableForSymtab(*TableHeader);
  if (!Strings)
    return Strings.takeError();

  Symbols.resize(Entries->size());
  for (auto [Number, Entry] : enumerate(*Entries)) {
    if (Number == 0)
      continue;
    auto SymbolName = Entry.getName(*Strings);
    if (!SymbolName)
      return SymbolName.takeError();
    Symbol Read;
    Read.Name = *SymbolName;
    Read.Type = Entry.getType();
    Read.Binding = Entry.getBinding();
    Read.Visibility = Entry.getVisibility();
    Read.Value = Entry.st_value;
    Read.Size = Entry.st_size;
    Read.File = this;
    uint32_t SectionNumber = Entry.st_shndx;
    if (SectionNumber == SHN_COMMON) {
      Read.Common = Read.Defined = true;
    } else if (SectionNumber == SHN_ABS) {
      Read.Defined = true;
    } else if (SectionNumber != SHN_UNDEF) {
      if (SectionNumber >= Sections.size())
        return makeError("symbol " + *SymbolName + " is in section " +
                         Twine(SectionNumber) + ", which does not exist");
      Read.Section = Sections[SectionNumber].get();
      // A symbol of a dropped group's section is the one of the kept group.
      Read.Defined = Read.Section != nullptr;
    }

    if (Read.Binding == STB_LOCAL) {
      Locals.push_back(Read);
      Symbols[Number] = &Locals.back();
      continue;
    }
    Symbol &Global = Globals.get(*SymbolName);
    Symbols[Number] = &Global;
    if (Read.Defined)
      Globals.define(Read, Diags);
    if (!Read.isWeak())
      Global.WeaklyReferenced = false;
  }
  return Error::success();
}

const Symbol *ElfObject::enclosingSymbol(const InputSection &Section,
                                         uint32_t Offset) const {
  for (const Symbol *Candidate : Symbols)
    if (Candidate && Candidate->Section == &Section &&
        Candidate->Type != STT_SECTION && Offset >= Candidate->Value &&
        Offset - Candidate->Value < std::max(1u, Candidate->Size))
      return Candidate;
  return nullptr;
}

std::string ElfObject::describePlace(const InputSection &Section,
                                     uint32_t Offset) const {
  StringRef Container = Section.Name;
  if (const Symbol *Function = enclosingSymbol(Section, Offset)) {
    Container = Function->Name;
    Offset -= Function->Value;
  }
  return (Twine(Name) + ":(" + Container + "+0x" +
          utohexstr(Offset, /*LowerCase=*/true) + ")")
      .str();
}

InputSection *ElfObject::addCommonSection(Symbol &Definition) {
  auto Section = std::make_unique<InputSection>();
  Section->File = this;
  Section->Name = Definition.Type == STT_TLS ? ".tbss" : ".bss";
  Section->Type = SHT_NOBITS;
  Section->Flags = SHF_ALLOC | SHF_WRITE;
  if (Definition.Type == STT_TLS)
    Section->Flags |= SHF_TLS;
  Section->Alignment = std::max(1u, Definition.Value);
  Section->Size = Definition.Size;
  Sections.push_back(std::move(Section));
  return Sections.back().get();
}

} // namespace tp
