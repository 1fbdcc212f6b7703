//===- RaceChecks.cpp - The check for data races --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/RaceChecks.h"

#include "simulator/functional/FunctionalText.h"
#include "simulator/loader/ElfProgram.h"

#include <algorithm>

namespace tp {

static constexpr const char Kind[] = "data-race";

RaceChecks::RaceChecks(CheckedProgram &Checked, const ChipConfig &Chip)
    : Checked(Checked), TextBegin(Checked.Elf.text().Address),
      Flags(Checked.Elf.text().Contents.size() / 4), Stacks(Chip.threadCount()),
      Sites(uint32_t(Flags.size())),
      Detector(Chip.threadCount(), Chip.MemoryBytes,
               [this](const Race &R) { report(R); }) {
  for (const AtomicAccess &A : Checked.Elf.atomicAccesses())
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
          Checked.Contexts.stackAt(Place.Pc, Place.Context)};
}

static bool writes(const RacingAccess &Access) {
  return Access.Kind == AccessKind::Write ||
         Access.Kind == AccessKind::AtomicWrite;
}

bool RaceChecks::isNews(const Race &R) {
  const uint32_t Earlier = Sites.place(R.Earlier.Site).Pc;
  const uint32_t Later = Sites.place(R.Later.Site).Pc;
  // Which of the two comes first may differ from race to race.
  auto [Low, High] = std::minmax(Earlier, Later);
  if (!Checked.Found.isNew(Kind, Low, High))
    return false;
  const bool LowWrites = writes(Low == Earlier ? R.Earlier : R.Later);
  const std::vector<SourceFrame> &Writer =
      Checked.Found.frames(LowWrites ? Low : High);
  const std::vector<SourceFrame> &Other =
      Checked.Found.frames(LowWrites ? High : Low);
  if (Writer.empty() || Other.empty())
    return true;
  return Causes.insert({Writer[0].File, Writer[0].Line, Other[0].Function})
      .second;
}

void RaceChecks::report(const Race &R) {
  if (!isNews(R))
    return;
  Report Result;
  Result.Check = "race";
  Result.Kind = Kind;
  Result.Title = std::string(describe(R.Later.Kind)) + " and " +
                 describe(R.Earlier.Kind) +
                 " by two threads that no barrier or atomic operation orders";
  Result.Address = R.Address;
  Result.Bytes = 1;
  Result.Object = Checked.Names.describe(R.Address).value_or("");
  Result.Sides = {side(R.Later), side(R.Earlier)};
  Checked.Found.add(Result);
}

} // namespace tp
