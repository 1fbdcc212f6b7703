//===- RaceChecks.cpp - The check for data races --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/RaceChecks.h"

#include "simulator/functional/FunctionalText.h"
#include "simulator/loader/ElfProgram.h"

namespace tp {

RaceChecks::RaceChecks(const ElfProgram &Program, const ChipConfig &Chip,
                       Reports &Found)
    : TextBegin(Program.text().Address),
      Flags(Program.text().Contents.size() / 4), Found(Found),
      Stacks(Chip.threadCount()), Sites(uint32_t(Flags.size())),
      Detector(Chip.threadCount(), Chip.MemoryBytes,
               [this](const Race &R) { report(R); }) {
  for (const AtomicAccess &A : Program.atomicAccesses())
    Flags[(A.Address - TextBegin) / 4] =
        uint8_t(Atomic | (A.Acquires ? Acquires : 0) |
                (A.IsPartOfWord ? PartOfWord : 0));
}

std::string RaceChecks::error() const {
  return Detector.isMapped()
             ? ""
             : "the host has no room for what --check=race knows of the chip's "
               "memory; give the chip less (--set memory.bytes=)";
}

std::vector<FunctionalSlot> RaceChecks::decode(const Program &Text,
                                               bool FlushToZero) {
  return decodeWithChecks<RaceChecks>(Text, FlushToZero,
                                      Text.stackLimit() != 0);
}

void RaceChecks::output(FunctionalThread &T, uint32_t Pc, uint32_t Address,
                        uint32_t Bytes) {
  if (Space->isLocal(Address))
    return;
  for (uint32_t At = Address; At != Address + Bytes; ++At)
    if (!Space->isReadOnly(At))
      Detector.read(T.Number, At, 1, [&] { return site(T, Pc); });
}

void RaceChecks::notePartOfWord(const FunctionalThread &T, uint32_t Pc,
                                uint32_t Address, uint32_t Changed) {
  for (unsigned Byte = 0; Byte != 4; ++Byte)
    if (Changed >> 8 * Byte & 0xFF)
      Detector.atomicWrite(T.Number, Address + Byte, 1, site(T, Pc));
}

static const char *describe(AccessKind Kind) {
  switch (Kind) {
  case AccessKind::Read:
    return "load";
  case AccessKind::Write:
    return "store";
  case AccessKind::AtomicRead:
    return "atomic load";
  case AccessKind::AtomicWrite:
    return "atomic store or operation";
  }
  __builtin_unreachable();
}

ReportSide RaceChecks::side(const RacingAccess &Access) const {
  const AccessPlace Place = Sites.place(Access.Site);
  return {describe(Access.Kind), Access.Thread,
          Contexts.stackAt(Place.Pc, Place.Context)};
}

void RaceChecks::report(const Race &R) {
  static constexpr const char Kind[] = "data-race";
  const uint32_t Earlier = Sites.place(R.Earlier.Site).Pc;
  const uint32_t Later = Sites.place(R.Later.Site).Pc;
  // Which of the two comes first may differ from race to race.
  if (!Found.isNew(Kind, std::min(Earlier, Later), std::max(Earlier, Later)))
    return;
  Report Result;
  Result.Check = "race";
  Result.Kind = Kind;
  Result.Title = std::string("data race: ") + describe(R.Later.Kind) + " and " +
                 describe(R.Earlier.Kind) +
                 " by two threads that no barrier or atomic operation orders";
  Result.Address = R.Address;
  Result.Bytes = 1;
  Result.Sides = {side(R.Later), side(R.Earlier)};
  Found.add(Result);
}

} // namespace tp
