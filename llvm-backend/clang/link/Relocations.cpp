//===- Relocations.cpp - Puts addresses into a program's bytes ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/Relocations.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm/ADT/MapVector.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;
using namespace llvm::support::endian;

namespace tp {

//===----------------------------------------------------------------------===//
// Undefined symbols
//===----------------------------------------------------------------------===//

static constexpr size_t ReferencesShown = 3;

void reportUndefinedSymbols(ArrayRef<std::unique_ptr<ElfObject>> Objects,
                            const ReferenceHint &Hint, LinkDiagnostics &Diags) {
  MapVector<StringRef, std::vector<std::string>> References;
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections()) {
      if (!Section || !Section->Live || !Section->isAllocated())
        continue;
      for (const ElfType::Rela &Relocation : Section->Relocations) {
        const Symbol *Target = Object->symbol(Relocation.getSymbol(false));
        if (!Target || Target->Defined || Target->WeaklyReferenced)
          continue;
        std::vector<std::string> &Places = References[Target->Name];
        const Symbol *Function =
            Object->enclosingSymbol(*Section, Relocation.r_offset);
        std::string Place =
            Hint(Target->Name, Function ? Function->Name : StringRef());
        if (Place.empty())
          Place = Object->describePlace(*Section, Relocation.r_offset);
        if (!is_contained(Places, Place))
          Places.push_back(std::move(Place));
      }
    }
  for (const auto &[Name, Places] : References) {
    std::string Message = "undefined symbol: " + demangle(Name);
    for (const std::string &Place :
         ArrayRef(Places).take_front(ReferencesShown))
      Message += "\n  referenced by " + Place;
    if (Places.size() > ReferencesShown)
      Message += "\n  and " + std::to_string(Places.size() - ReferencesShown) +
                 " more";
    Diags.error(Message);
  }
}

//===----------------------------------------------------------------------===//
// Values
//===----------------------------------------------------------------------===//

// What debug data says of code and data that are not in the program. Readers of
// DWARF know the all-ones address as "nowhere"; in the lists of DWARF 4 it has
// a meaning of its own.
static uint32_t deadAddress(const InputSection &Section) {
  return Section.Name == ".debug_loc" || Section.Name == ".debug_ranges"
             ? 1
             : TPELF::DeadAddress;
}

namespace {
/// One relocation and what it amounts to.
struct Place {
  const InputSection &Section;
  const Symbol *Target;
  uint32_t Offset;
  uint32_t Type;
  /// S + A modulo 2^32.
  uint32_t Value;
  LinkDiagnostics &Diags;

  void reportRange(int64_t Got, const Twine &Range, const Twine &Cure) const {
    Diags.error(Section.File->describePlace(Section, Offset) + ": relocation " +
                TPELF::getRelocationName(Type) +
                (Target && !Target->Name.empty() ? " to '" + Target->Name + "'"
                                                 : Twine("")) +
                " is out of range: " + Twine(Got) + " is not in " + Range +
                Cure);
  }

  /// The signed distance in words from the place, to be stored in \p Bits.
  uint32_t wordDistance(unsigned Bits) const {
    int32_t Distance = static_cast<int32_t>(Value - Section.address(Offset));
    if (Distance % 4)
      Diags.error(Section.File->describePlace(Section, Offset) +
                  ": the target of a jump is not a multiple of 4");
    if (!isIntN(Bits + 2, Distance))
      reportRange(Distance,
                  "[" + Twine(minIntN(Bits + 2)) + ", " +
                      Twine(maxIntN(Bits + 2)) + "]",
                  "; jump with `la` and `jr`, or move the code nearer");
    return static_cast<uint32_t>(Distance >> 2) &
           maskTrailingOnes<uint32_t>(Bits);
  }

  /// The value as \p Bits bits, signed or unsigned.
  uint32_t narrow(unsigned Bits) const {
    int32_t Signed = static_cast<int32_t>(Value);
    if (!isIntN(Bits, Signed) && !isUIntN(Bits, Value))
      reportRange(Signed,
                  "[" + Twine(minIntN(Bits)) + ", " + Twine(maxUIntN(Bits)) +
                      "]",
                  "; use a wider datum");
    return Value;
  }
};
} // namespace

static unsigned widthOf(uint32_t Type) {
  switch (Type) {
  case TPELF::R_TP_NONE:
    return 0;
  case TPELF::R_TP_8:
    return 1;
  case TPELF::R_TP_16:
    return 2;
  default:
    return 4;
  }
}

static void writeField(uint8_t *Word, unsigned Bits, uint32_t Value) {
  uint32_t Mask = maskTrailingOnes<uint32_t>(Bits);
  write32le(Word, (read32le(Word) & ~Mask) | (Value & Mask));
}

static void apply(const Place &At, uint8_t *Bytes) {
  switch (At.Type) {
  case TPELF::R_TP_NONE:
    return;
  case TPELF::R_TP_32:
    return write32le(Bytes, At.Value);
  case TPELF::R_TP_HI16:
    return writeField(Bytes, 16, (At.Value + 0x8000) >> 16);
  case TPELF::R_TP_LO16:
    return writeField(Bytes, 16, At.Value);
  case TPELF::R_TP_PC16:
    return writeField(Bytes, 16, At.wordDistance(16));
  case TPELF::R_TP_PC26:
    return writeField(Bytes, 26, At.wordDistance(26));
  case TPELF::R_TP_PC32:
    return write32le(Bytes, At.Value - At.Section.address(At.Offset));
  case TPELF::R_TP_16:
    return write16le(Bytes, At.narrow(16));
  case TPELF::R_TP_8:
    *Bytes = static_cast<uint8_t>(At.narrow(8));
    return;
  }
}

void relocate(const InputSection &Section, MutableArrayRef<uint8_t> Bytes,
              LinkDiagnostics &Diags) {
  for (const ElfType::Rela &Relocation : Section.Relocations) {
    uint32_t Type = Relocation.getType(false);
    uint32_t Offset = Relocation.r_offset;
    if (TPELF::getRelocationName(Type).empty()) {
      Diags.error(Section.File->describePlace(Section, Offset) +
                  ": unknown relocation type " + Twine(Type) +
                  "; assemble the file again with this toolchain");
      continue;
    }
    if (uint64_t(Offset) + widthOf(Type) > Bytes.size()) {
      Diags.error(Section.File->describePlace(Section, Offset) +
                  ": relocation lies beyond the end of the section");
      continue;
    }
    const Symbol *Target = Section.File->symbol(Relocation.getSymbol(false));
    uint32_t Value = Relocation.r_addend;
    if (Target)
      Value += Target->address();
    bool IsDead =
        Target && (Target->Section ? !Target->Section->Live : !Target->Defined);
    if (IsDead && !Section.isAllocated())
      Value = deadAddress(Section);
    apply({Section, Target, Offset, Type, Value, Diags}, &Bytes[Offset]);
  }
}

} // namespace tp
