//===- ReplayMoves.cpp - What all replays do alike ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/ReplayMoves.h"
#include "simulator/replay/HostBytes.h"

#include <cstring>

namespace tp {

uint8_t *ReplayMoves::host(uint32_t Number, uint32_t Address,
                           uint64_t Bytes) const {
  return hostBytes(Space, localStoreBias(Number), Address, Bytes);
}

bool ReplayMoves::read(uint32_t Number, uint32_t Address,
                       std::span<uint8_t> Bytes) const {
  const uint8_t *Source = host(Number, Address, Bytes.size());
  if (Source)
    std::memcpy(Bytes.data(), Source, Bytes.size());
  return Source != nullptr;
}

bool ReplayMoves::write(uint32_t Number, uint32_t Address,
                        std::span<const uint8_t> Bytes) {
  uint8_t *Target = host(Number, Address, Bytes.size());
  if (!Target || hasText(Space, Address, Bytes.size()))
    return false;
  change([&] {
    if (!Space.isLocal(Address))
      history().writing(
          {Now.Time, WordWriter::User, 0, Address, uint32_t(Bytes.size())});
    std::memcpy(Target, Bytes.data(), Bytes.size());
  });
  return true;
}

bool ReplayMoves::setPc(uint32_t Number, uint32_t Pc) {
  const uint32_t Offset = Pc - Text.textBegin();
  if (Offset % 4 != 0 || Offset / 4 >= Text.instructions().size())
    return false;
  change([&] { setNextWord(Number, Offset / 4); });
  return true;
}

std::vector<uint8_t>
ReplayMoves::watchedBytes(const AccessEvents &Event) const {
  std::vector<uint8_t> Bytes(Event.Bytes);
  if (!read(Event.Thread.value_or(0), Event.Address, Bytes))
    Bytes.clear();
  return Bytes;
}

std::optional<ReplayStop> ReplayMoves::stopAt(const FoundEvent &Found,
                                              const Events &Wanted,
                                              bool IsForward) {
  ReplayStop Stop;
  Stop.Kind = Found.Kind;
  Stop.Thread = Found.Thread;
  Stop.Pc = Found.Pc;
  Stop.Event = Found.Event;
  moveTo(Found.At);
  Seen = {Found.At, false};
  if (Found.Kind == ReplayStop::Access) {
    const AccessEvents &Event = Wanted.Accesses[Found.Event];
    Stop.AccessAddress = Found.Access.Address;
    Stop.AccessBytes = Found.Access.Bytes;
    Stop.IsWrite = Found.Access.Writes;
    Stop.Old = watchedBytes(Event);
    if (std::optional<ReplayStop> End = moveTo({Found.At.Time + 1, 0});
        End && End->Kind == ReplayStop::Trapped)
      return IsForward ? End : std::nullopt;
    Stop.New = watchedBytes(Event);
    if (Event.OnlyChanges && Stop.IsWrite && Stop.Old == Stop.New)
      return std::nullopt;
    Seen = Found.place();
    if (!IsForward) {
      moveTo(Found.At);
      Seen = {Found.At, false};
    }
  }
  Stop.At = Now;
  return Stop;
}

ReplayStop ReplayMoves::forward(const Events &Wanted) {
  EventPlace After = Seen;
  while (true) {
    const EventMatcher Matcher(Chip, Text, Wanted, EventMatcher::First, After,
                               std::nullopt);
    const SearchResult Result = search(Matcher, After.At.Time, NoLimit);
    if (!Result.Found)
      return endOf(Result.Run);
    if (std::optional<ReplayStop> Stop =
            stopAt(*Result.Found, Wanted, /*IsForward=*/true))
      return *Stop;
    After = Result.Found->place();
  }
}

ReplayMoves::SearchResult ReplayMoves::findLast(const Events &Wanted,
                                                EventPlace Before) {
  uint64_t End = Before.At.Time + 1;
  while (true) {
    const uint64_t Begin = pointBefore(End);
    const EventMatcher Matcher(Chip, Text, Wanted, EventMatcher::Last,
                               std::nullopt, Before);
    SearchResult Result = search(Matcher, Begin, End);
    if (Result.Found || Begin == 0 || Result.Run.End == RunResult::Stopped)
      return Result;
    End = Begin;
  }
}

ReplayStop ReplayMoves::backward(const Events &Wanted) {
  const Moment From = Now;
  EventPlace Before{Now, false};
  while (true) {
    const SearchResult Result = findLast(Wanted, Before);
    const bool WasStopped = Result.Run.End == RunResult::Stopped;
    if (WasStopped || !Result.Found) {
      ReplayStop Stop;
      moveTo(WasStopped ? From : Moment());
      Seen = {Now, false};
      if (WasStopped)
        Stop.Kind = ReplayStop::Interrupted;
      Stop.At = Now;
      return Stop;
    }
    if (std::optional<ReplayStop> Kept =
            stopAt(*Result.Found, Wanted, /*IsForward=*/false))
      return *Kept;
    Before = Result.Found->place();
  }
}

ReplayStop ReplayMoves::goTo(Moment Target) {
  if (std::optional<ReplayStop> End = moveTo(Target))
    return *End;
  Seen = {Now, false};
  ReplayStop Stop;
  Stop.Kind =
      Target == Moment() ? ReplayStop::Beginning : ReplayStop::Instruction;
  Stop.At = Now;
  return Stop;
}

std::optional<LastWrite> ReplayMoves::knownWrite(uint32_t Address,
                                                 uint32_t Bytes) {
  if (Space.isLocal(Address))
    return std::nullopt;
  const std::optional<WordWriter> Writer = history().lastWriter(Address, Bytes);
  if (!Writer)
    return std::nullopt;
  if (Writer->Thread == WordWriter::Nobody)
    return AsLoaded{};
  if (Writer->Thread == WordWriter::User)
    return WrittenByUser{{Writer->Cycle, 0}};
  return WriteRecord{momentOf(Writer->Cycle, Writer->Thread), Writer->Thread,
                     Writer->Pc};
}

LastWrite ReplayMoves::lastWrite(uint32_t Number, uint32_t Address,
                                 uint32_t Bytes) {
  if (std::optional<LastWrite> Known = knownWrite(Address, Bytes))
    return *Known;
  const Moment Here = Now;
  const EventPlace SeenHere = Seen;
  Events Writes;
  AccessEvents &Any = Writes.Accesses.emplace_back();
  Any.Address = Address;
  Any.Bytes = Bytes;
  if (Space.isLocal(Address))
    Any.Thread = Number;
  const ReplayStop Stop = backward(Writes);
  moveTo(Here);
  Seen = SeenHere;
  if (Stop.Kind != ReplayStop::Access)
    return AsLoaded{};
  return WriteRecord{Stop.At, Stop.Thread, Stop.Pc};
}

} // namespace tp
