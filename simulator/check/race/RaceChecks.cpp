//===- RaceChecks.cpp - The check for data races --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/RaceChecks.h"

#include "simulator/functional/FunctionalText.h"
#include "simulator/loader/ElfProgram.h"

#include <tuple>

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
                                      /*WatchesStack=*/false);
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

CodePlace RaceChecks::place(const RacingAccess &Access) const {
  const AccessPlace Place = Sites.place(Access.Site);
  return {Access.Thread, Place.Pc, Place.Context};
}

ReportSide RaceChecks::side(const RacingAccess &Access) const {
  const CodePlace Place = place(Access);
  return {describe(Access.Kind), Access.Thread,
          Checked.Contexts.stackAt(Place.Pc, Place.Calls)};
}

static bool writes(const RacingAccess &Access) {
  return Access.Kind == AccessKind::Write ||
         Access.Kind == AccessKind::AtomicWrite;
}

std::string RaceChecks::causeOf(const Race &R) {
  // Which of the two comes first may differ from race to race.
  const bool LaterWrites =
      writes(R.Later) &&
      (!writes(R.Earlier) || place(R.Later).Pc <= place(R.Earlier).Pc);
  const auto &[Writer, Other] =
      LaterWrites ? std::tie(R.Later, R.Earlier) : std::tie(R.Earlier, R.Later);
  const std::vector<SourceFrame> &WriterFrames =
      Checked.Found.frames(place(Writer).Pc);
  const std::vector<SourceFrame> &OtherFrames =
      Checked.Found.frames(place(Other).Pc);
  if (WriterFrames.empty() || OtherFrames.empty())
    return "";
  return WriterFrames[0].File + ':' + std::to_string(WriterFrames[0].Line) +
         '|' + OtherFrames[0].Function;
}

void RaceChecks::report(const Race &R) {
  if (!Checked.Found.isNew(Kind, place(R.Later), place(R.Earlier)))
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
  Result.Cause = causeOf(R);
  Checked.Found.add(Result);
}

} // namespace tp
