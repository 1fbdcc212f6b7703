//===- Layout.cpp - Addresses of a program's sections ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/Layout.h"
#include "llvm-backend/clang/link/MemoryMap.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;
using namespace llvm::ELF;

namespace tp {

const OutputSection *Layout::find(StringRef Name) const {
  for (const auto &Section : Sections)
    if (Section->Name == Name)
      return Section.get();
  return nullptr;
}

static SectionClass classOf(const InputSection &Section) {
  if (!Section.isAllocated())
    return SectionClass::NotLoaded;
  if (Section.isThreadLocal())
    return Section.isZeroFilled() ? SectionClass::ThreadLocalZeroFilled
                                  : SectionClass::ThreadLocalData;
  if (Section.isCode())
    return SectionClass::Code;
  if (Section.Name.starts_with(".init_array") ||
      Section.Name.starts_with(".preinit_array"))
    return SectionClass::InitArray;
  if (Section.Name.starts_with(".fini_array"))
    return SectionClass::FiniArray;
  if (Section.isZeroFilled())
    return SectionClass::ZeroFilled;
  return Section.Flags & SHF_WRITE ? SectionClass::Data
                                   : SectionClass::ReadOnly;
}

// `.text.main` and `.text` go into one section, as with other linkers.
static StringRef outputName(const InputSection &Section) {
  static constexpr StringLiteral Merged[] = {
      ".text",  ".rodata", ".data",       ".bss",
      ".tdata", ".tbss",   ".init_array", ".fini_array"};
  for (StringRef Name : Merged)
    if (Section.Name == Name ||
        (Section.Name.starts_with(Name) && Section.Name[Name.size()] == '.'))
      return Name;
  return Section.Name;
}

// Constructors run in the order of their priority: .init_array.00101 before
// .init_array.00200 before .init_array, .preinit_array before all.
static uint32_t constructorPriority(const InputSection *Section) {
  if (Section->Name.starts_with(".preinit_array"))
    return 0;
  uint32_t Priority;
  if (Section->Name.rsplit('.').second.getAsInteger(10, Priority))
    return 65536;
  return Priority + 1;
}

static OutputSection &outputFor(Layout &Program, const InputSection &Input) {
  StringRef Name = outputName(Input);
  SectionClass Class = classOf(Input);
  for (const auto &Section : Program.Sections)
    if (Section->Name == Name && Section->Class == Class)
      return *Section;
  auto Section = std::make_unique<OutputSection>();
  Section->Name = Name.str();
  Section->Class = Class;
  Section->Type = Input.Type;
  Program.Sections.push_back(std::move(Section));
  return *Program.Sections.back();
}

static void gather(Layout &Program,
                   ArrayRef<std::unique_ptr<ElfObject>> Objects) {
  static constexpr uint32_t KeptFlags =
      SHF_ALLOC | SHF_WRITE | SHF_EXECINSTR | SHF_TLS | SHF_MERGE | SHF_STRINGS;
  for (const auto &Object : Objects)
    for (const auto &Input : Object->sections())
      if (Input && Input->Live) {
        OutputSection &Section = outputFor(Program, *Input);
        Section.Flags |= Input->Flags & KeptFlags;
        Section.Inputs.push_back(Input.get());
      }
  for (const auto &Section : Program.Sections) {
    // The inputs were not merged, and their parts may have different sizes.
    if (Section->Class != SectionClass::NotLoaded)
      Section->Flags &= ~(SHF_MERGE | SHF_STRINGS);
    if (Section->Class == SectionClass::InitArray ||
        Section->Class == SectionClass::FiniArray)
      llvm::stable_sort(
          Section->Inputs, [](const InputSection *A, const InputSection *B) {
            return constructorPriority(A) < constructorPriority(B);
          });
  }
  llvm::stable_sort(Program.Sections, [](const auto &A, const auto &B) {
    return A->Class < B->Class;
  });
}

// Sets the offsets of the inputs. Sizes are 64-bit here, because their sum may
// pass the address space.
static uint64_t placeInputs(OutputSection &Section) {
  uint64_t Size = 0;
  for (InputSection *Input : Section.Inputs) {
    Size = alignTo(Size, Input->Alignment);
    Input->Output = &Section;
    Input->OutputOffset = static_cast<uint32_t>(Size);
    Size += Input->Size;
    Section.Alignment = std::max(Section.Alignment, Input->Alignment);
  }
  return Size;
}

static bool isThreadLocal(SectionClass Class) {
  return Class == SectionClass::ThreadLocalData ||
         Class == SectionClass::ThreadLocalZeroFilled;
}

static void placeThreadLocals(Layout &Program, LinkDiagnostics &Diags) {
  // The start-up code copies whole words.
  Program.ThreadLocalAlignment = 4;
  uint64_t Size = 0, DataSize = 0;
  for (const auto &Section : Program.Sections) {
    if (!isThreadLocal(Section->Class))
      continue;
    Program.ThreadLocalAlignment =
        std::max(Program.ThreadLocalAlignment, Section->Alignment);
    Size = alignTo(Size, Section->Alignment);
    Section->Address = static_cast<uint32_t>(Size);
    Size += Section->Size;
    if (Section->Class == SectionClass::ThreadLocalData)
      DataSize = Size;
  }
  if (Size > memorymap::ThreadLocalBytesMax) {
    Diags.error("thread_local objects take " + Twine(Size) +
                " bytes, more than the largest local store has (" +
                Twine(memorymap::ThreadLocalBytesMax) +
                "); make some of them ordinary globals");
    return;
  }
  Program.ThreadLocalBegin = static_cast<uint32_t>(alignDown(
      memorymap::ThreadLocalEnd - Size, Program.ThreadLocalAlignment));
  Program.ThreadLocalDataSize = static_cast<uint32_t>(DataSize);
  Program.ThreadLocalZeroFilledSize = static_cast<uint32_t>(Size - DataSize);
  for (const auto &Section : Program.Sections)
    if (isThreadLocal(Section->Class))
      Section->Address += Program.ThreadLocalBegin;
}

static void placeGlobals(Layout &Program, LinkDiagnostics &Diags) {
  uint64_t Address = memorymap::GlobalBegin;
  bool IsWritable = false;
  for (const auto &Section : Program.Sections) {
    if (Section->Class == SectionClass::NotLoaded ||
        Section->Class == SectionClass::ThreadLocalZeroFilled)
      continue;
    if (!IsWritable && Section->Class >= SectionClass::InitArray) {
      Address = alignTo(Address, memorymap::SegmentAlignment);
      IsWritable = true;
    }
    Address = alignTo(Address, Section->Alignment);
    if (Section->Class == SectionClass::ThreadLocalData) {
      // The sections of the initial values keep their distances.
      uint32_t Offset = Section->Address - Program.ThreadLocalBegin;
      if (!Program.ThreadLocalDataImage) {
        Address = alignTo(Address, Program.ThreadLocalAlignment);
        Program.ThreadLocalDataImage = static_cast<uint32_t>(Address);
      }
      Section->LoadAddress = Program.ThreadLocalDataImage + Offset;
      Address = alignTo(uint64_t(Section->LoadAddress) + Section->Size, 4);
      continue;
    }
    Section->Address = Section->LoadAddress = static_cast<uint32_t>(Address);
    Address += Section->Size;
  }
  Address = alignTo(Address, memorymap::ImageAlignment);
  if (Address > memorymap::GlobalEnd) {
    Diags.error("the program ends at address 0x" + utohexstr(Address, true) +
                ", beyond the end of global memory (0x" +
                utohexstr(memorymap::GlobalEnd, true) +
                "); make its arrays smaller");
    return;
  }
  Program.ImageEnd = static_cast<uint32_t>(Address);
}

Layout layOut(ArrayRef<std::unique_ptr<ElfObject>> Objects,
              LinkDiagnostics &Diags) {
  Layout Program;
  gather(Program, Objects);
  for (const auto &Section : Program.Sections) {
    uint64_t Size = placeInputs(*Section);
    if (!isUInt<32>(Size)) {
      Diags.error("section " + Section->Name + " has " + Twine(Size) +
                  " bytes, more than the address space; make its objects "
                  "smaller");
      return Program;
    }
    Section->Size = static_cast<uint32_t>(Size);
  }
  placeThreadLocals(Program, Diags);
  placeGlobals(Program, Diags);
  return Program;
}

} // namespace tp
