//===- DebugImage.cpp - An object laid out for its debug info -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/DebugImage.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/MathExtras.h"
#include "llvm/Support/MemoryBuffer.h"
#include <cstring>

using namespace llvm;
using namespace llvm::object;

namespace tp {

DebugImage::DebugImage(const ObjectInput &Input) : Input(Input) {
  if (!Input.isRelocatable())
    return;
  StringRef Bytes = Input.file().getData();
  Copy = WritableMemoryBuffer::getNewUninitMemBuffer(Bytes.size());
  std::memcpy(Copy->getBufferStart(), Bytes.data(), Bytes.size());
  layOut();
  for (const Section &Section : Input.sections())
    if (!(Section.Flags & ELF::SHF_ALLOC) && !Section.Contents.empty())
      relocate(Section);
  // The copy differs only in values that are not checked when it is opened.
  CopiedFile = std::make_unique<ELF32LEObjectFile>(
      cantFail(ELF32LEObjectFile::create(Copy->getMemBufferRef())));
}

const ObjectFile &DebugImage::file() const {
  return CopiedFile ? *CopiedFile : Input.file();
}

uint32_t DebugImage::addressOf(const Section &Section, uint32_t Address) const {
  return CopiedFile ? Bases[Section.Index] + Address : Address;
}

void DebugImage::layOut() {
  char *Start = Copy->getBufferStart();
  auto *Header = reinterpret_cast<ELF32LE::Ehdr *>(Start);
  Header->e_type = ELF::ET_EXEC;
  auto *SectionHeaders =
      reinterpret_cast<ELF32LE::Shdr *>(Start + Header->e_shoff);
  uint32_t Next = 0;
  for (const Section &Section : Input.sections()) {
    ELF32LE::Shdr &SectionHeader = SectionHeaders[Section.Index];
    if (Section.Flags & ELF::SHF_ALLOC) {
      SectionHeader.sh_addr = Next;
      Next = alignTo(Next + Section.Size, 16);
    }
    // Nobody shall apply the relocations again.
    if (Section.Type == ELF::SHT_RELA)
      SectionHeader.sh_type = ELF::SHT_PROGBITS;
    Bases.push_back(SectionHeader.sh_addr);
  }
}

void DebugImage::relocate(const Section &Section) {
  auto Offset = reinterpret_cast<const char *>(Section.Contents.data()) -
                Input.file().getData().data();
  for (const Relocation &Relocation : Section.Relocations) {
    if (Relocation.Type != TPELF::R_TP_32 || Section.Contents.size() < 4 ||
        Relocation.Offset > Section.Contents.size() - 4)
      continue;
    uint32_t Value = Relocation.Addend;
    if (Relocation.SymbolIndex) {
      const Symbol &Symbol = Input.symbols()[*Relocation.SymbolIndex];
      Value += Symbol.Value;
      if (Symbol.Section < Bases.size())
        Value += Bases[Symbol.Section];
    }
    support::endian::write32le(
        Copy->getBufferStart() + Offset + Relocation.Offset, Value);
  }
}

} // namespace tp
