//===- ElfProgram.cpp - A TP program as an ELF file -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/loader/ElfProgram.h"

#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "simulator/core/Memory.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/Twine.h"
#include "llvm/Object/ELFObjectFile.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/FileSystem.h"

#include <algorithm>

using namespace llvm;
using object::ELF32LE;
using object::ELF32LEObjectFile;

namespace tp {

static std::string hex(uint64_t Value) {
  return "0x" + utohexstr(Value, /*LowerCase=*/true, /*Width=*/8);
}

llvm::Error ElfProgram::error(const Twine &What) const {
  return createStringError(Path + ": " + What);
}

Expected<ElfProgram> ElfProgram::load(StringRef Path) {
  ElfProgram Program;
  Program.Path = Path.str();
  if (sys::fs::is_directory(Path))
    return Program.error("is a directory, not a program");
  auto Buffer = MemoryBuffer::getFile(Path, /*IsText=*/false,
                                      /*RequiresNullTerminator=*/false);
  if (!Buffer)
    return Program.error("cannot read the program: " +
                         Buffer.getError().message());
  Program.Buffer = std::move(*Buffer);
  if (llvm::Error E = Program.readHeader())
    return E;
  if (llvm::Error E = Program.readSegments())
    return E;
  if (llvm::Error E = Program.readSymbols())
    return E;
  if (llvm::Error E = Program.readFloatChecked())
    return E;
  if (llvm::Error E = Program.readAtomicAccesses())
    return E;
  return Program;
}

llvm::Error ElfProgram::readHeader() {
  StringRef Bytes = Buffer->getBuffer();
  if (!Bytes.starts_with(StringRef(ELF::ElfMagic, 4)))
    return error("is not an ELF file; give the output of tpcc");
  if (Bytes.size() < sizeof(ELF32LE::Ehdr))
    return error("is cut off: it has " + Twine(Bytes.size()) +
                 " bytes, fewer than an ELF header");
  if (Bytes[ELF::EI_CLASS] != ELF::ELFCLASS32 ||
      Bytes[ELF::EI_DATA] != ELF::ELFDATA2LSB)
    return error("is for another machine, not for the TP (a 64-bit or "
                 "big-endian ELF file); compile it with tpcc");
  ELF32LE::Ehdr Header;
  memcpy(&Header, Bytes.data(), sizeof(Header));
  if (Header.e_machine != TPELF::EM_TP)
    return error("is for another machine (e_machine " +
                 Twine(unsigned(Header.e_machine)) + "), not for the TP (" +
                 Twine(TPELF::EM_TP) + "); compile it with tpcc");
  if (Header.e_type == ELF::ET_REL)
    return error("is an object file that is not linked; link it with tpcc: "
                 "tpcc " +
                 Path + " -o program.elf");
  if (Header.e_type != ELF::ET_EXEC)
    return error("is not an executable; link it with tpcc");
  Entry = Header.e_entry;

  auto File =
      object::ObjectFile::createELFObjectFile(Buffer->getMemBufferRef());
  if (!File)
    return error("is cut off or damaged: " + toString(File.takeError()));
  Object = std::move(*File);
  return llvm::Error::success();
}

llvm::Error ElfProgram::readSegments() {
  const object::ELFFile<ELF32LE> &File =
      cast<ELF32LEObjectFile>(*Object).getELFFile();
  auto Headers = File.program_headers();
  if (!Headers)
    return error("is cut off or damaged: " + toString(Headers.takeError()));
  size_t TextCount = 0;
  for (const ELF32LE::Phdr &Header : *Headers) {
    if (Header.p_type != ELF::PT_LOAD || Header.p_memsz == 0)
      continue;
    Segment S;
    S.Address = Header.p_vaddr;
    S.Size = Header.p_memsz;
    S.Executable = Header.p_flags & ELF::PF_X;
    std::string Name = "segment at " + hex(S.Address);
    uint64_t FileEnd = uint64_t(Header.p_offset) + Header.p_filesz;
    if (FileEnd > Buffer->getBufferSize())
      return error("is cut off: the " + Name + " ends at byte " +
                   Twine(FileEnd) + ", the file has " +
                   Twine(Buffer->getBufferSize()));
    if (Header.p_filesz > Header.p_memsz)
      return error("is damaged: the " + Name +
                   " is larger in the file than in memory");
    if (S.Address < kGlobalMemoryBegin)
      return error("the " + Name +
                   " lies in the first 64 KiB, where every "
                   "access traps; link it with tpcc");
    const uint8_t *Begin =
        reinterpret_cast<const uint8_t *>(Buffer->getBufferStart());
    S.Contents = ArrayRef(Begin + Header.p_offset, Header.p_filesz);
    if (S.Executable) {
      TextIndex = Segments.size();
      ++TextCount;
      if (S.Address % 4 != 0)
        return error("is damaged: the executable " + Name +
                     " does not begin at a multiple of 4");
    }
    Segments.push_back(S);
  }
  if (TextCount != 1)
    return error("has " + Twine(TextCount) +
                 " executable segments, where tpcc makes one");
  for (const Segment &A : Segments)
    for (const Segment &B : Segments)
      if (&A < &B && A.Address < B.end() && B.Address < A.end())
        return error("is damaged: the segments at " + hex(A.Address) + " and " +
                     hex(B.Address) + " overlap");
  const Segment &Text = text();
  if (Entry % 4 != 0 || Entry < Text.Address ||
      Entry - Text.Address + 4 > Text.Contents.size())
    return error("the entry point " + hex(Entry) +
                 " is not an address of the code, which is [" +
                 hex(Text.Address) + ", " +
                 hex(Text.Address + Text.Contents.size()) + ")");
  return llvm::Error::success();
}

llvm::Error ElfProgram::readSymbols() {
  for (const object::SymbolRef &Symbol : Object->symbols()) {
    Expected<StringRef> Name = Symbol.getName();
    Expected<uint64_t> Address = Symbol.getAddress();
    if (!Name || !Address) {
      llvm::Error E =
          joinErrors(Name ? llvm::Error::success() : Name.takeError(),
                     Address ? llvm::Error::success() : Address.takeError());
      return error("the symbol table is damaged: " + toString(std::move(E)));
    }
    Expected<uint32_t> Flags = Symbol.getFlags();
    if (!Flags)
      return error("the symbol table is damaged: " +
                   toString(Flags.takeError()));
    bool IsDefined = !(*Flags & object::SymbolRef::SF_Undefined);
    if (IsDefined && !Name->empty())
      Symbols.try_emplace(*Name, uint32_t(*Address));
  }
  return llvm::Error::success();
}

Expected<ArrayRef<support::ulittle32_t>>
ElfProgram::readWords(StringRef SectionName, size_t EntryWords) const {
  for (const object::SectionRef &Section : Object->sections()) {
    Expected<StringRef> Name = Section.getName();
    if (!Name)
      return error("the section table is damaged: " +
                   toString(Name.takeError()));
    if (*Name != SectionName)
      continue;
    Expected<StringRef> Contents = Section.getContents();
    if (!Contents)
      return error("the section " + SectionName +
                   " is damaged: " + toString(Contents.takeError()));
    const size_t EntryBytes = EntryWords * sizeof(uint32_t);
    if (Contents->size() % EntryBytes != 0)
      return error("is damaged: the section " + SectionName + " has " +
                   Twine(Contents->size()) + " bytes, no multiple of " +
                   Twine(EntryBytes));
    return ArrayRef(
        reinterpret_cast<const support::ulittle32_t *>(Contents->data()),
        Contents->size() / sizeof(uint32_t));
  }
  return ArrayRef<support::ulittle32_t>();
}

llvm::Error ElfProgram::readFloatChecked() {
  auto Words = readWords(TPELF::CheckedFunctionsSection, 2);
  if (!Words)
    return Words.takeError();
  for (; !Words->empty(); *Words = Words->drop_front(2)) {
    const uint32_t Begin = Words->front();
    if (Begin == TPELF::DeadAddress)
      continue;
    const uint64_t End = uint64_t(Begin) + (*Words)[1];
    if (Begin % 4 != 0 || Begin < text().Address ||
        End > text().Address + text().Contents.size())
      return error(
          "is damaged: the section " + Twine(TPELF::CheckedFunctionsSection) +
          " lists a function at " + hex(Begin) + " that is not in the code");
    FloatChecked.push_back({Begin, uint32_t(End)});
  }
  return llvm::Error::success();
}

llvm::Error ElfProgram::readAtomicAccesses() {
  auto Words = readWords(TPELF::AtomicAccessesSection, 1);
  if (!Words)
    return Words.takeError();
  for (const uint32_t Entry : *Words) {
    if (Entry >= (TPELF::DeadAddress & ~3u))
      continue;
    const uint32_t Address = Entry & ~3u;
    if (Address < text().Address ||
        Address >= text().Address + text().Contents.size())
      return error(
          "is damaged: the section " + Twine(TPELF::AtomicAccessesSection) +
          " lists an access at " + hex(Address) + " that is not in the code");
    AtomicAccesses.push_back({Address, (Entry & TPELF::AcquiresFlag) != 0,
                              (Entry & TPELF::PartOfWordFlag) != 0});
  }
  return llvm::Error::success();
}

uint64_t ElfProgram::imageEnd() const {
  uint64_t End = 0;
  for (const Segment &S : Segments)
    End = std::max(End, S.end());
  return End;
}

llvm::Error ElfProgram::checkFits(uint64_t MemoryBytes,
                                  uint32_t LocalStoreBytes) const {
  if (std::optional<uint32_t> Limit = stackLimit()) {
    // The local store is the end of the address space.
    uint32_t Needed = 0u - *Limit;
    if (Needed > LocalStoreBytes)
      return error(
          "the program needs " + Twine(Needed) +
          " bytes of local store for its stack and thread_local "
          "objects, the chip has " +
          Twine(LocalStoreBytes) +
          "; choose a chip with more local_store.bytes (--chip, --set)");
  }
  uint64_t End = imageEnd();
  if (End <= MemoryBytes)
    return llvm::Error::success();
  return error("the program is larger than the chip's memory: it needs " +
               Twine(End) + " bytes, the chip has " + Twine(MemoryBytes) +
               "; choose a chip with more memory.bytes (--chip)");
}

std::optional<uint32_t> ElfProgram::stackLimit() const {
  return symbol("__tp_stack_limit");
}

std::optional<uint32_t> ElfProgram::symbol(StringRef Name) const {
  auto Found = Symbols.find(Name);
  if (Found == Symbols.end())
    return std::nullopt;
  return Found->second;
}

} // namespace tp
