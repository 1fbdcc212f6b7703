//===- TPAsmBackend.cpp - Resolves fixups ---------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm-backend/MCTargetDesc/TPFixupKinds.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/BinaryFormat/ELF.h"
#include "llvm/MC/MCAsmBackend.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCELFObjectWriter.h"
#include "llvm/MC/MCSectionELF.h"
#include "llvm/Support/EndianStream.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace {

class TPAsmBackend : public MCAsmBackend {
public:
  TPAsmBackend() : MCAsmBackend(endianness::little) {}

  std::unique_ptr<MCObjectTargetWriter>
  createObjectTargetWriter() const override {
    return createTPELFObjectWriter();
  }
  std::optional<MCFixupKind> getFixupKind(StringRef Name) const override;
  MCFixupKindInfo getFixupKindInfo(MCFixupKind Kind) const override;
  void applyFixup(const MCFragment &Fragment, const MCFixup &Fixup,
                  const MCValue &Target, uint8_t *Data, uint64_t Value,
                  bool IsResolved) override;
  unsigned getMinimumNopSize() const override { return 4; }
  bool writeNopData(raw_ostream &OS, uint64_t Count,
                    const MCSubtargetInfo *STI) const override;

private:
  /// Bytes of the place that a fixup writes to.
  unsigned sizeOf(MCFixupKind Kind) const {
    return Kind >= FirstTargetFixupKind
               ? 4
               : divideCeil(getFixupKindInfo(Kind).TargetSize, 8);
  }
  uint64_t encode(const MCFixup &Fixup, uint64_t Value) const;
  uint64_t encodeTarget(const MCFixup &Fixup, int64_t Distance,
                        unsigned Width) const;
};

} // namespace

// Names for the directive `.reloc`.
std::optional<MCFixupKind> TPAsmBackend::getFixupKind(StringRef Name) const {
  auto Type = StringSwitch<std::optional<unsigned>>(Name)
#define TP_RELOC(NAME, VALUE) .Case(#NAME, VALUE)
#include "llvm-backend/MCTargetDesc/TPRelocations.def"
                  .Case("BFD_RELOC_NONE", TPELF::R_TP_NONE)
                  .Case("BFD_RELOC_8", TPELF::R_TP_8)
                  .Case("BFD_RELOC_16", TPELF::R_TP_16)
                  .Case("BFD_RELOC_32", TPELF::R_TP_32)
                  .Default(std::nullopt);
  if (!Type)
    return std::nullopt;
  return MCFixupKind(FirstLiteralRelocationKind + *Type);
}

MCFixupKindInfo TPAsmBackend::getFixupKindInfo(MCFixupKind Kind) const {
  // In the order of TP::Fixups: name, first bit, bits, flags.
  static const MCFixupKindInfo Infos[TP::NumTargetFixupKinds] = {
      {"fixup_tp_hi16", 0, 16, 0},   {"fixup_tp_lo16", 0, 16, 0},
      {"fixup_tp_simm16", 0, 16, 0}, {"fixup_tp_uimm16", 0, 16, 0},
      {"fixup_tp_pc16", 0, 16, 0},   {"fixup_tp_pc26", 0, 26, 0},
  };
  if (mc::isRelocation(Kind))
    return {};
  if (Kind < FirstTargetFixupKind)
    return MCAsmBackend::getFixupKindInfo(Kind);
  return Infos[Kind - FirstTargetFixupKind];
}

uint64_t TPAsmBackend::encodeTarget(const MCFixup &Fixup, int64_t Distance,
                                    unsigned Width) const {
  if (Distance % 4 != 0)
    getContext().reportError(Fixup.getLoc(),
                             "branch target is not a multiple of 4 bytes away");
  else if (!isIntN(Width + 2, Distance))
    getContext().reportError(
        Fixup.getLoc(), "branch target out of range: it is " + Twine(Distance) +
                            " bytes away, the range is [" +
                            Twine(minIntN(Width) * 4) + ", " +
                            Twine(maxIntN(Width) * 4) + "]");
  return uint64_t(Distance >> 2) & maskTrailingOnes<uint64_t>(Width);
}

uint64_t TPAsmBackend::encode(const MCFixup &Fixup, uint64_t Value) const {
  auto Signed = static_cast<int64_t>(Value);
  auto OutOfRange = [&](int64_t Lowest, int64_t Highest) {
    getContext().reportError(
        Fixup.getLoc(), "value " + Twine(Signed) + " is out of the range [" +
                            Twine(Lowest) + ", " + Twine(Highest) + "]");
    return 0;
  };
  switch (unsigned Kind = Fixup.getKind()) {
  case TP::fixup_tp_hi16:
    return ((Value + 0x8000) >> 16) & 0xffff;
  case TP::fixup_tp_lo16:
    return Value & 0xffff;
  case TP::fixup_tp_simm16:
    return isInt<16>(Signed) ? Value & 0xffff : OutOfRange(-0x8000, 0x7fff);
  case TP::fixup_tp_uimm16:
    return isUInt<16>(Signed) ? Value : OutOfRange(0, 0xffff);
  case TP::fixup_tp_pc16:
    return encodeTarget(Fixup, Signed, 16);
  case TP::fixup_tp_pc26:
    return encodeTarget(Fixup, Signed, 26);
  default: {
    unsigned Bits = 8 * sizeOf(Kind);
    if (Bits < 64 && !isUIntN(Bits, Value) && !isIntN(Bits, Signed))
      return OutOfRange(minIntN(Bits), maxUIntN(Bits));
    return Value;
  }
  }
}

static bool isLoaded(const MCFragment &Fragment) {
  const auto *Section = static_cast<const MCSectionELF *>(Fragment.getParent());
  return Section->getFlags() & ELF::SHF_ALLOC;
}

void TPAsmBackend::applyFixup(const MCFragment &Fragment, const MCFixup &Fixup,
                              const MCValue &Target, uint8_t *Data,
                              uint64_t Value, bool IsResolved) {
  const uint64_t Unrelocated = Value;
  maybeAddReloc(Fragment, Fixup, Target, Value, IsResolved);
  if (mc::isRelocation(Fixup.getKind()))
    return;
  if (!IsResolved) {
    // Addends stand in the relocation. Tools that do not know the TP's
    // relocations can read debug data all the same.
    if (isLoaded(Fragment) || Fixup.getKind() >= FirstTargetFixupKind)
      return;
    Value = Unrelocated;
  }
  Value = encode(Fixup, Value);
  for (unsigned Byte = 0, Size = sizeOf(Fixup.getKind()); Byte != Size; ++Byte)
    Data[Byte] |= uint8_t(Value >> (8 * Byte));
}

bool TPAsmBackend::writeNopData(raw_ostream &OS, uint64_t Count,
                                const MCSubtargetInfo *STI) const {
  if (Count % 4 != 0)
    return false;
  constexpr uint32_t Nop = 8u << 26; // addi r0, r0, 0
  for (; Count; Count -= 4)
    support::endian::write<uint32_t>(OS, Nop, endianness::little);
  return true;
}

MCAsmBackend *llvm::createTPAsmBackend(const Target &T,
                                       const MCSubtargetInfo &STI,
                                       const MCRegisterInfo &MRI,
                                       const MCTargetOptions &Options) {
  return new TPAsmBackend();
}
