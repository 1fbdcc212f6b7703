//===- FrameRecords.cpp - What the functions need of the stack ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/FrameRecords.h"
#include "llvm-backend/MCTargetDesc/TPFrameRecord.h"
#include "llvm/Support/Endian.h"

using namespace llvm;
using namespace llvm::support::endian;

namespace tp {

static constexpr uint32_t WordBytes = 4;

namespace {
/// Reads the records of one section.
class Reader {
public:
  Reader(const InputSection &Section, std::vector<FrameRecord> &Records,
         LinkDiagnostics &Diags);
  void read();

private:
  uint32_t wordAt(uint32_t Offset, TPFrameRecord::Word Word) const {
    return read32le(&Section.Bytes[Offset + Word * WordBytes]);
  }
  void report(uint32_t Offset, const Twine &Fault) {
    Diags.error(Section.File->describePlace(Section, Offset) + ": " + Fault +
                "; compile or assemble the file again");
  }
  void addRecord(uint32_t Offset, const Symbol &Function, uint32_t Addend,
                 uint32_t TypeCount);

  const InputSection &Section;
  std::vector<FrameRecord> &Records;
  LinkDiagnostics &Diags;
  DenseMap<uint32_t, const ElfType::Rela *> RelocationAt;
};
} // namespace

Reader::Reader(const InputSection &Section, std::vector<FrameRecord> &Records,
               LinkDiagnostics &Diags)
    : Section(Section), Records(Records), Diags(Diags) {
  for (const ElfType::Rela &Relocation : Section.Relocations)
    RelocationAt[Relocation.r_offset] = &Relocation;
}

void Reader::addRecord(uint32_t Offset, const Symbol &Function, uint32_t Addend,
                       uint32_t TypeCount) {
  // Another object's function has taken this one's place, or nobody needs it.
  if (Function.File != Section.File || !Function.Section ||
      !Function.Section->Live)
    return;
  FrameRecord Record;
  Record.Section = Function.Section;
  Record.Offset = Function.Value + Addend;
  Record.FrameBytes = wordAt(Offset, TPFrameRecord::FrameBytes);
  Record.OwnType = wordAt(Offset, TPFrameRecord::OwnType);
  Record.RegisterCallCount = wordAt(Offset, TPFrameRecord::RegisterCallCount);
  const uint32_t Types = Offset + TPFrameRecord::HeaderWords * WordBytes;
  for (uint32_t I = 0; I != TypeCount; ++I)
    Record.CalleeTypes.push_back(
        read32le(&Section.Bytes[Types + I * WordBytes]));
  Records.push_back(std::move(Record));
}

void Reader::read() {
  constexpr uint32_t HeaderBytes = TPFrameRecord::HeaderWords * WordBytes;
  const uint32_t End = Section.Bytes.size();
  for (uint32_t Offset = 0; Offset != End;) {
    if (End - Offset < HeaderBytes)
      return report(Offset, "the record of a stack frame is cut off");
    const uint32_t TypeCount = wordAt(Offset, TPFrameRecord::CalleeTypeCount);
    if ((End - Offset - HeaderBytes) / WordBytes < TypeCount)
      return report(Offset, "the record of a stack frame is cut off");
    const ElfType::Rela *Relocation = RelocationAt.lookup(Offset);
    const Symbol *Function =
        Relocation ? Section.File->symbol(Relocation->getSymbol(false))
                   : nullptr;
    if (!Function)
      return report(Offset, "the record of a stack frame names no function");
    addRecord(Offset, *Function, Relocation->r_addend, TypeCount);
    Offset += HeaderBytes + TypeCount * WordBytes;
  }
}

std::vector<FrameRecord>
readFrameRecords(ArrayRef<std::unique_ptr<ElfObject>> Objects,
                 LinkDiagnostics &Diags) {
  std::vector<FrameRecord> Records;
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections())
      if (Section && Section->Name == TPFrameRecord::SectionName)
        Reader(*Section, Records, Diags).read();
  return Records;
}

} // namespace tp
