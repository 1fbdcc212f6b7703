//===- ElfWriter.cpp - Writes the executable ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/ElfWriter.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm-backend/clang/link/MemoryMap.h"
#include "llvm-backend/clang/link/Relocations.h"
#include "llvm/MC/StringTableBuilder.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;
using namespace llvm::ELF;

namespace tp {

namespace {

/// A loadable segment, as a range of the layout's sections.
struct Segment {
  uint32_t Flags = PF_R;
  uint32_t Begin = 0, FileEnd = 0, MemoryEnd = 0;
  uint32_t FileOffset = 0;
  bool IsEmpty = true;

  void add(const OutputSection &Section);
};

/// Builds the file in one buffer.
class ElfWriter {
public:
  ElfWriter(const Layout &Program, ArrayRef<std::unique_ptr<ElfObject>> Objects,
            const SymbolTable &Globals, LinkDiagnostics &Diags)
      : Program(Program), Objects(Objects), Globals(Globals), Diags(Diags) {}

  SmallVector<uint8_t, 0> write(uint32_t EntryAddress);

private:
  void formSegments();
  void placeInFile();
  void writeContents(const OutputSection &Section, uint32_t FileOffset);
  void collectSymbols();
  void addSymbol(const Symbol &Source);
  uint16_t sectionNumber(const Symbol &Source) const;
  void writeSymbolTable();
  void writeProgramHeaders();
  void writeSectionHeaders();
  void writeFileHeader(uint32_t EntryAddress);

  template <typename T> T *at(uint32_t Offset) {
    return reinterpret_cast<T *>(File.data() + Offset);
  }
  uint32_t append(size_t Bytes, uint32_t Alignment);

  const Layout &Program;
  ArrayRef<std::unique_ptr<ElfObject>> Objects;
  const SymbolTable &Globals;
  LinkDiagnostics &Diags;

  SmallVector<uint8_t, 0> File;
  Segment Text, Data;
  unsigned ProgramHeaders = 0;
  std::vector<uint32_t> SectionOffsets;
  DenseMap<const OutputSection *, uint16_t> SectionNumbers;
  StringTableBuilder SymbolNames{StringTableBuilder::ELF};
  StringTableBuilder SectionNames{StringTableBuilder::ELF};
  std::vector<std::pair<const Symbol *, ElfType::Sym>> SymbolEntries;
  uint32_t LocalSymbols = 0;
  uint32_t SymbolOffset = 0, SymbolNamesOffset = 0, SectionNamesOffset = 0;
  uint32_t SectionHeadersOffset = 0;
};

} // namespace

void Segment::add(const OutputSection &Section) {
  if (IsEmpty)
    Begin = FileEnd = MemoryEnd = Section.LoadAddress;
  IsEmpty = false;
  MemoryEnd = std::max(MemoryEnd, Section.LoadAddress + Section.Size);
  if (!Section.isZeroFilled())
    FileEnd = MemoryEnd;
  if (Section.Flags & SHF_EXECINSTR)
    Flags |= PF_X;
  if (Section.Flags & SHF_WRITE)
    Flags |= PF_W;
}

uint32_t ElfWriter::append(size_t Bytes, uint32_t Alignment) {
  File.resize(alignTo(File.size(), Alignment));
  uint32_t Offset = File.size();
  File.resize(Offset + Bytes);
  return Offset;
}

static bool isLoaded(const OutputSection &Section) {
  return Section.Class != SectionClass::NotLoaded &&
         Section.Class != SectionClass::ThreadLocalZeroFilled;
}

void ElfWriter::formSegments() {
  bool HasThreadLocals = false;
  for (const auto &Section : Program.Sections) {
    HasThreadLocals |= (Section->Flags & SHF_TLS) != 0;
    if (isLoaded(*Section))
      (Section->Class < SectionClass::InitArray ? Text : Data).add(*Section);
  }
  ProgramHeaders = !Text.IsEmpty + !Data.IsEmpty + HasThreadLocals;
}

void ElfWriter::placeInFile() {
  append(sizeof(ElfType::Ehdr) + ProgramHeaders * sizeof(ElfType::Phdr), 1);
  for (Segment *Loaded : {&Text, &Data}) {
    if (Loaded->IsEmpty)
      continue;
    // The offset in the file and the address agree modulo the page size.
    append(0, memorymap::SegmentAlignment);
    append(Loaded->Begin % memorymap::SegmentAlignment, 1);
    Loaded->FileOffset = append(Loaded->FileEnd - Loaded->Begin, 1);
  }
  for (const auto &Section : Program.Sections) {
    SectionNumbers[Section.get()] = SectionOffsets.size() + 1;
    uint32_t Offset = File.size();
    if (isLoaded(*Section)) {
      const Segment &Loaded =
          Section->Class < SectionClass::InitArray ? Text : Data;
      uint32_t Distance = std::min(Section->LoadAddress, Loaded.FileEnd);
      Offset = Loaded.FileOffset + (Distance - Loaded.Begin);
    } else if (Section->Class == SectionClass::NotLoaded &&
               !Section->isZeroFilled()) {
      Offset = append(Section->Size, Section->Alignment);
    }
    SectionOffsets.push_back(Offset);
    if (!Section->isZeroFilled())
      writeContents(*Section, Offset);
    SectionNames.add(Section->Name);
  }
}

void ElfWriter::writeContents(const OutputSection &Section,
                              uint32_t FileOffset) {
  for (const InputSection *Input : Section.Inputs) {
    MutableArrayRef<uint8_t> Bytes(
        File.data() + FileOffset + Input->OutputOffset, Input->Bytes.size());
    llvm::copy(Input->Bytes, Bytes.begin());
    relocate(*Input, Bytes, Diags);
  }
}

//===----------------------------------------------------------------------===//
// Symbols
//===----------------------------------------------------------------------===//

uint16_t ElfWriter::sectionNumber(const Symbol &Source) const {
  if (!Source.Section)
    return SHN_ABS;
  return SectionNumbers.lookup(Source.Section->Output);
}

void ElfWriter::addSymbol(const Symbol &Source) {
  ElfType::Sym Entry{};
  Entry.st_value = Source.address();
  Entry.st_size = Source.Size;
  // A thread_local object has one address, the same for each thread.
  uint8_t Type = Source.Type == STT_TLS ? uint8_t(STT_OBJECT) : Source.Type;
  bool IsHidden =
      Source.Visibility == STV_HIDDEN || Source.Visibility == STV_INTERNAL;
  Entry.setBindingAndType(IsHidden ? uint8_t(STB_LOCAL) : Source.Binding, Type);
  Entry.st_shndx = sectionNumber(Source);
  SymbolNames.add(Source.Name);
  SymbolEntries.push_back({&Source, Entry});
}

static bool isInProgram(const Symbol &Source) {
  return Source.Defined && (!Source.Section || Source.Section->Live);
}

void ElfWriter::collectSymbols() {
  for (const auto &Object : Objects)
    for (const Symbol &Local : Object->locals()) {
      bool IsFile = Local.Type == STT_FILE;
      if (Local.Type != STT_SECTION && !Local.Name.empty() &&
          (IsFile || isInProgram(Local)))
        addSymbol(Local);
    }
  for (const Symbol &Global : Globals.symbols())
    if (isInProgram(Global))
      addSymbol(Global);
  llvm::stable_sort(SymbolEntries, [](const auto &A, const auto &B) {
    return (A.second.getBinding() == STB_LOCAL) >
           (B.second.getBinding() == STB_LOCAL);
  });
  LocalSymbols = llvm::count_if(SymbolEntries, [](const auto &Entry) {
    return Entry.second.getBinding() == STB_LOCAL;
  });
  SymbolNames.finalize();
}

void ElfWriter::writeSymbolTable() {
  SymbolOffset = append((SymbolEntries.size() + 1) * sizeof(ElfType::Sym), 4);
  auto *Entries = at<ElfType::Sym>(SymbolOffset);
  for (auto &[Source, Entry] : SymbolEntries) {
    Entry.st_name = SymbolNames.getOffset(Source->Name);
    *++Entries = Entry;
  }
  SymbolNamesOffset = append(SymbolNames.getSize(), 1);
  SymbolNames.write(at<uint8_t>(SymbolNamesOffset));
}

//===----------------------------------------------------------------------===//
// Headers
//===----------------------------------------------------------------------===//

void ElfWriter::writeProgramHeaders() {
  auto *Header = at<ElfType::Phdr>(sizeof(ElfType::Ehdr));
  for (const Segment *Loaded : {&Text, &Data}) {
    if (Loaded->IsEmpty)
      continue;
    Header->p_type = PT_LOAD;
    Header->p_flags = Loaded->Flags;
    Header->p_offset = Loaded->FileOffset;
    Header->p_vaddr = Loaded->Begin;
    Header->p_paddr = Loaded->Begin;
    Header->p_filesz = Loaded->FileEnd - Loaded->Begin;
    Header->p_memsz = Loaded->MemoryEnd - Loaded->Begin;
    Header->p_align = memorymap::SegmentAlignment;
    ++Header;
  }
  uint32_t ThreadLocalSize =
      Program.ThreadLocalDataSize + Program.ThreadLocalZeroFilledSize;
  if (ProgramHeaders == unsigned(!Text.IsEmpty) + !Data.IsEmpty)
    return;
  Header->p_type = PT_TLS;
  Header->p_flags = PF_R;
  Header->p_vaddr = Program.ThreadLocalBegin;
  Header->p_paddr = Program.ThreadLocalDataImage;
  Header->p_filesz = Program.ThreadLocalDataSize;
  Header->p_memsz = ThreadLocalSize;
  Header->p_align = Program.ThreadLocalAlignment;
  if (Program.ThreadLocalDataImage)
    Header->p_offset =
        Data.FileOffset + (Program.ThreadLocalDataImage - Data.Begin);
}

void ElfWriter::writeSectionHeaders() {
  constexpr unsigned TablesAfterSections = 3;
  for (const char *Name : {".symtab", ".strtab", ".shstrtab"})
    SectionNames.add(Name);
  SectionNames.finalize();
  SectionNamesOffset = append(SectionNames.getSize(), 1);
  SectionNames.write(at<uint8_t>(SectionNamesOffset));

  SectionHeadersOffset =
      append((1 + Program.Sections.size() + TablesAfterSections) *
                 sizeof(ElfType::Shdr),
             4);
  auto *Header = at<ElfType::Shdr>(SectionHeadersOffset) + 1;
  for (auto [Section, Offset] : zip_equal(Program.Sections, SectionOffsets)) {
    Header->sh_name = SectionNames.getOffset(Section->Name);
    Header->sh_type = Section->Type;
    Header->sh_flags = Section->Flags;
    Header->sh_addr = Section->Address;
    Header->sh_offset = Offset;
    Header->sh_size = Section->Size;
    Header->sh_addralign = Section->Alignment;
    Header->sh_entsize = Section->Flags & SHF_STRINGS ? 1 : 0;
    ++Header;
  }
  auto WriteTable = [&](const char *Name, uint32_t Type, uint32_t Offset,
                        uint32_t Size) {
    Header->sh_name = SectionNames.getOffset(Name);
    Header->sh_type = Type;
    Header->sh_offset = Offset;
    Header->sh_size = Size;
    Header->sh_addralign = 1;
    return Header++;
  };
  ElfType::Shdr *Symbols =
      WriteTable(".symtab", SHT_SYMTAB, SymbolOffset,
                 (SymbolEntries.size() + 1) * sizeof(ElfType::Sym));
  Symbols->sh_addralign = 4;
  Symbols->sh_entsize = sizeof(ElfType::Sym);
  Symbols->sh_link = Program.Sections.size() + 2;
  Symbols->sh_info = LocalSymbols + 1;
  WriteTable(".strtab", SHT_STRTAB, SymbolNamesOffset, SymbolNames.getSize());
  WriteTable(".shstrtab", SHT_STRTAB, SectionNamesOffset,
             SectionNames.getSize());
}

void ElfWriter::writeFileHeader(uint32_t EntryAddress) {
  auto *Header = at<ElfType::Ehdr>(0);
  llvm::copy(ArrayRef(ElfMagic, 4), Header->e_ident);
  Header->e_ident[EI_CLASS] = ELFCLASS32;
  Header->e_ident[EI_DATA] = ELFDATA2LSB;
  Header->e_ident[EI_VERSION] = EV_CURRENT;
  Header->e_type = ET_EXEC;
  Header->e_machine = TPELF::EM_TP;
  Header->e_version = EV_CURRENT;
  Header->e_entry = EntryAddress;
  Header->e_phoff = ProgramHeaders ? sizeof(ElfType::Ehdr) : 0;
  Header->e_shoff = SectionHeadersOffset;
  Header->e_ehsize = sizeof(ElfType::Ehdr);
  Header->e_phentsize = sizeof(ElfType::Phdr);
  Header->e_phnum = ProgramHeaders;
  Header->e_shentsize = sizeof(ElfType::Shdr);
  Header->e_shnum = Program.Sections.size() + 4;
  Header->e_shstrndx = Program.Sections.size() + 3;
}

SmallVector<uint8_t, 0> ElfWriter::write(uint32_t EntryAddress) {
  formSegments();
  placeInFile();
  collectSymbols();
  writeSymbolTable();
  writeProgramHeaders();
  writeSectionHeaders();
  writeFileHeader(EntryAddress);
  return std::move(File);
}

SmallVector<uint8_t, 0> writeElf(const Layout &Program,
                                 ArrayRef<std::unique_ptr<ElfObject>> Objects,
                                 const SymbolTable &Globals,
                                 uint32_t EntryAddress,
                                 LinkDiagnostics &Diags) {
  return ElfWriter(Program, Objects, Globals, Diags).write(EntryAddress);
}

} // namespace tp
