//===- ReplayMoves.cpp - What all replays do alike ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/ReplayMoves.h"
#include "simulator/isa/StreamAccess.h"
#include "simulator/replay/HostBytes.h"

#include <cstring>

namespace tp {

void ReplayMoves::change(const std::function<void()> &Function) {
  std::erase_if(UserWrites, [this](const UserWrite &Write) {
    return Write.Time > Now.Time;
  });
  changeMachine(Function);
}

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
  const auto Size = uint32_t(Bytes.size());
  change([&] {
    if (!Space.isLocal(Address))
      history().changing(Address, Size);
    std::memcpy(Target, Bytes.data(), Bytes.size());
  });
  UserWrites.push_back({Now.Time, Number, Address, Size});
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

std::optional<ReplayStop> ReplayMoves::moveBehind(FoundEvent &Found,
                                                  const AccessEvents &Event) {
  MemoryAccess &Access = Found.Access;
  if (Access.IsStream)
    history().keepWrites(Found.Thread);
  std::optional<ReplayStop> End = moveTo({Found.At.Time + 1, 0});
  if (!Access.IsStream)
    return End;
  Access.Reads = overlaps(Event, Access.Address, StreamDescriptorBytes);
  Access.Writes = false;
  for (const GlobalWrite &Write : history().takeWrites())
    Access.Writes |= Write.Cycle == Found.At.Time &&
                     overlaps(Event, Write.Address, Write.Bytes);
  return End;
}

std::optional<ReplayStop> ReplayMoves::stopAtAccess(ReplayStop Stop,
                                                    FoundEvent Found,
                                                    const AccessEvents &Event,
                                                    bool IsForward) {
  Stop.Old = watchedBytes(Event);
  const std::optional<ReplayStop> End = moveBehind(Found, Event);
  // Another thread may trap in the same cycle; New is then not to be had.
  const bool HasTrapped = End && End->Kind == ReplayStop::Trapped;
  if (HasTrapped && End->Thread == Found.Thread)
    return IsForward ? End : std::nullopt;
  const MemoryAccess &Access = Found.Access;
  if (!(Event.Reads && Access.Reads) && !(Event.Writes && Access.Writes))
    return std::nullopt;
  Stop.AccessAddress = Access.Address;
  Stop.AccessBytes = Access.Bytes;
  Stop.IsWrite = Access.Writes;
  if (HasTrapped)
    moveTo(Found.At);
  else
    Stop.New = watchedBytes(Event);
  if (Event.OnlyChanges && Stop.IsWrite && Stop.Old == Stop.New)
    return std::nullopt;
  Seen = Found.place();
  if (!IsForward) {
    moveTo(Found.At);
    Seen = {Found.At, false};
  }
  Stop.At = Now;
  return Stop;
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
  if (Found.Kind == ReplayStop::Access)
    return stopAtAccess(Stop, Found, Wanted.Accesses[Found.Event], IsForward);
  Stop.At = Now;
  return Stop;
}

ReplayStop ReplayMoves::forward(const Events &Wanted) {
  EventPlace After = Seen;
  while (true) {
    const EventMatcher Matcher(Chip, Text, Wanted, EventMatcher::First, After,
                               std::nullopt);
    const SearchResult Result = search(Matcher, nextTime(After), NoLimit);
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

void ReplayMoves::visit(Moment There, const std::function<void()> &Function) {
  const Moment Here = Now;
  const EventPlace SeenHere = Seen;
  goTo(There);
  Function();
  moveTo(Here);
  Seen = SeenHere;
}

std::optional<uint64_t> ReplayMoves::userWrite(uint32_t Number,
                                               uint32_t Address,
                                               uint32_t Bytes) const {
  std::optional<uint64_t> Last;
  for (const UserWrite &Write : UserWrites)
    if (Write.Time <= Now.Time &&
        (Write.Thread == Number || !Space.isLocal(Address)) &&
        Write.Address < uint64_t(Address) + Bytes &&
        Address < uint64_t(Write.Address) + Write.Bytes)
      Last = Write.Time;
  return Last;
}

std::optional<LastWrite> ReplayMoves::knownWrite(uint32_t Address,
                                                 uint32_t Bytes) {
  if (Space.isLocal(Address))
    return std::nullopt;
  const std::optional<std::vector<WordWriter>> Writers =
      history().lastWriters(Address, Bytes);
  if (!Writers)
    return std::nullopt;
  std::optional<WriteRecord> Last;
  for (const WordWriter &Writer : *Writers) {
    const Moment At = momentOf(Writer.Cycle, Writer.Thread);
    if (!Last || At > Last->At)
      Last = {At, Writer.Thread, Writer.Pc};
  }
  if (!Last)
    return AsLoaded();
  return *Last;
}

LastWrite ReplayMoves::searchWrite(uint32_t Number, uint32_t Address,
                                   uint32_t Bytes) {
  Events Writes;
  AccessEvents &Any = Writes.Accesses.emplace_back();
  Any.Address = Address;
  Any.Bytes = Bytes;
  if (Space.isLocal(Address))
    Any.Thread = Number;
  const Moment Here = Now;
  SearchResult Result = findLast(Writes, {{Now.Time, 0}, false});
  while (Result.Found && Result.Found->Access.IsStream &&
         Result.Run.End != RunResult::Stopped) {
    moveTo(Result.Found->At);
    moveBehind(*Result.Found, Any);
    if (Result.Found->Access.Writes)
      break;
    Result = findLast(Writes, Result.Found->place());
  }
  moveTo(Here);
  if (Result.Run.End == RunResult::Stopped)
    return SearchInterrupted();
  if (!Result.Found)
    return AsLoaded();
  return WriteRecord{Result.Found->At, Result.Found->Thread, Result.Found->Pc};
}

LastWrite ReplayMoves::lastWrite(uint32_t Number, uint32_t Address,
                                 uint32_t Bytes) {
  const std::optional<LastWrite> Known = knownWrite(Address, Bytes);
  const LastWrite Last = Known ? *Known : searchWrite(Number, Address, Bytes);
  const std::optional<uint64_t> User = userWrite(Number, Address, Bytes);
  if (!User || std::holds_alternative<SearchInterrupted>(Last))
    return Last;
  // What the program does at the same time, it does behind the change.
  const auto *Written = std::get_if<WriteRecord>(&Last);
  if (Written && Written->At.Time >= *User)
    return Last;
  return WrittenByUser{{*User, 0}};
}

} // namespace tp
