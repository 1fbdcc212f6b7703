//===- EventCollector.cpp - Finds events while an engine runs -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/EventCollector.h"
#include "simulator/core/WindowLog.h"

namespace tp {

uint32_t orderOf(const ChipConfig &Chip, uint64_t Cycle, uint32_t Thread) {
  const uint32_t Tm = Thread / Chip.TpsPerTm;
  const uint32_t Tp = Thread % Chip.TpsPerTm;
  const auto First = uint32_t(Cycle / Chip.ArbitrationWindow % Chip.TpsPerTm);
  const uint32_t Priority =
      Tp >= First ? Tp - First : Tp + Chip.TpsPerTm - First;
  return uint32_t(orderKey(0, Priority, Tm));
}

void EventCollector::issuing(const Thread &T, uint32_t Word, uint64_t Cycle,
                             const TmRunnerState &Runner) {
  const std::lock_guard Guard(Lock);
  std::optional<FoundEvent> &Own = Tentative[T.Number];
  if (Own)
    keep(Best, *Own);
  Own.reset();
  const Moment At{Cycle, orderOf(Chip, Cycle, T.Number)};
  if (!Matcher.mayMatch(At))
    return;
  std::function<bool(uint32_t, std::span<uint8_t>)> Read =
      [&](uint32_t Address, std::span<uint8_t> Bytes) {
        return readAsThread(T, Runner, Address, Bytes);
      };
  Probe Place{T.Number, Text.textBegin() + Word * 4, At, T.Registers, Read};
  Own = Matcher.match(Place);
  if (Own && Matcher.kept() == EventMatcher::First && StopFlag)
    *StopFlag = true;
}

void EventCollector::postponed(const Thread &T) {
  const std::lock_guard Guard(Lock);
  Tentative[T.Number].reset();
}

void EventCollector::keep(std::optional<FoundEvent> &Kept,
                          const FoundEvent &Candidate) const {
  if (!Kept || (Matcher.kept() == EventMatcher::First
                    ? Candidate.place() < Kept->place()
                    : Candidate.place() > Kept->place()))
    Kept = Candidate;
}

std::optional<FoundEvent> EventCollector::found() const {
  std::optional<FoundEvent> Result = Best;
  for (const std::optional<FoundEvent> &Own : Tentative)
    if (Own)
      keep(Result, *Own);
  return Result;
}

} // namespace tp
