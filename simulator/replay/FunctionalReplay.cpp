//===- FunctionalReplay.cpp - Without timing, forward and backward --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/FunctionalReplay.h"

#include <cstring>

namespace tp {

FunctionalReplay::FunctionalReplay(const ChipConfig &Chip, const Program &Text,
                                   Memory &Global, ReplayOptions Request)
    : Chip(Chip), Text(Text), Space(Chip, Text, Global),
      Time(this->Chip, Text, Global, std::move(Request)) {}

//===----------------------------------------------------------------------===//
// State
//===----------------------------------------------------------------------===//

ReplayThread FunctionalReplay::thread(uint32_t Number) const {
  const FunctionalThread &T = Time.machine().thread(Number);
  ReplayThread Result;
  Result.Registers = T.Registers;
  Result.Pc = Text.textBegin() + T.NextWord * 4;
  Result.State = T.State;
  Result.Status = T.Status;
  Result.Instructions = T.TurnEnd;
  return Result;
}

bool FunctionalReplay::read(uint32_t Number, uint32_t Address,
                            std::span<uint8_t> Bytes) const {
  const uint8_t *Source = host(Number, Address, Bytes.size());
  if (Source)
    std::memcpy(Bytes.data(), Source, Bytes.size());
  return Source != nullptr;
}

//===----------------------------------------------------------------------===//
// Changes
//===----------------------------------------------------------------------===//

bool FunctionalReplay::write(uint32_t Number, uint32_t Address,
                             std::span<const uint8_t> Bytes) {
  uint8_t *Target = host(Number, Address, Bytes.size());
  if (!Target || hasText(Space, Address, Bytes.size()))
    return false;
  Time.change([&] {
    if (!Space.isLocal(Address))
      Time.history().writing(
          {Now.Time, WordWriter::User, 0, Address, uint32_t(Bytes.size())});
    std::memcpy(Target, Bytes.data(), Bytes.size());
  });
  return true;
}

void FunctionalReplay::setRegister(uint32_t Number, unsigned Register,
                                   uint32_t Value) {
  Time.change([&] { Time.machine().setRegister(Number, Register, Value); });
}

bool FunctionalReplay::setPc(uint32_t Number, uint32_t Pc) {
  const uint32_t Offset = Pc - Text.textBegin();
  if (Offset % 4 != 0 || Offset / 4 >= Text.instructions().size())
    return false;
  Time.change([&] { Time.machine().setNextWord(Number, Offset / 4); });
  return true;
}

//===----------------------------------------------------------------------===//
// Moves
//===----------------------------------------------------------------------===//

ReplayStop FunctionalReplay::endOf(const RunResult &Result) {
  ReplayStop Stop;
  Stop.ExitStatus = Result.ExitStatus;
  Stop.TrapInfo = Result.TrapInfo;
  Now = {Time.time(), 0};
  Seen = {Now, Result.End == RunResult::Halted};
  switch (Result.End) {
  case RunResult::Halted:
    Stop.Kind = ReplayStop::Halted;
    break;
  case RunResult::Trapped:
    Stop.Kind = ReplayStop::Trapped;
    Stop.Thread = Result.TrapInfo->Thread;
    Stop.Pc = Result.TrapInfo->Pc;
    break;
  case RunResult::Stopped:
    Stop.Kind = ReplayStop::Interrupted;
    break;
  case RunResult::CycleLimit:
  case RunResult::Paused:
    Stop.Kind = ReplayStop::CycleLimit;
    break;
  }
  // A machine that trapped is shown as it was before.
  Time.setControl(nullptr, Report);
  Time.goTo(Now.Time);
  Stop.At = Now;
  return Stop;
}

std::optional<ReplayStop> FunctionalReplay::moveTo(uint64_t Target) {
  Time.setControl(nullptr, Report);
  const RunResult Result = Time.goTo(Target);
  if (Result.End == RunResult::Trapped || Time.time() != Target)
    return endOf(Result);
  Now = {Target, 0};
  return std::nullopt;
}

std::vector<uint8_t>
FunctionalReplay::watchedBytes(const AccessEvents &Event) const {
  std::vector<uint8_t> Bytes(Event.Bytes);
  if (!read(Event.Thread.value_or(0), Event.Address, Bytes))
    Bytes.clear();
  return Bytes;
}

std::optional<ReplayStop> FunctionalReplay::stopAt(const FoundEvent &Found,
                                                   const Events &Wanted,
                                                   bool IsForward) {
  ReplayStop Stop;
  Stop.Kind = Found.Kind;
  Stop.Thread = Found.Thread;
  Stop.Pc = Found.Pc;
  Stop.Event = Found.Event;
  moveTo(Found.At.Time);
  Seen = {Found.At, false};
  if (Found.Kind == ReplayStop::Access) {
    const AccessEvents &Event = Wanted.Accesses[Found.Event];
    Stop.AccessAddress = Found.Access.Address;
    Stop.AccessBytes = Found.Access.Bytes;
    Stop.IsWrite = Found.Access.Writes;
    Stop.Old = watchedBytes(Event);
    if (std::optional<ReplayStop> End = moveTo(Found.At.Time + 1);
        End && End->Kind == ReplayStop::Trapped)
      return IsForward ? End : std::nullopt;
    Stop.New = watchedBytes(Event);
    if (Event.OnlyChanges && Stop.IsWrite && Stop.Old == Stop.New)
      return std::nullopt;
    Seen = Found.place();
    if (!IsForward) {
      moveTo(Found.At.Time);
      Seen = {Found.At, false};
    }
  }
  Stop.At = Now;
  return Stop;
}

ReplayStop FunctionalReplay::forward(const Events &Wanted) {
  EventPlace After = Seen;
  while (true) {
    const EventMatcher Matcher(Chip, Text, Wanted, EventMatcher::First, After,
                               std::nullopt);
    FunctionalCollector Collector(Matcher, Space);
    Time.setControl(StopFlag, Report);
    const RunResult Result =
        Time.search(Collector, After.At.Time, InstructionStops::Never);
    if (!Collector.found())
      return endOf(Result);
    if (std::optional<ReplayStop> Stop =
            stopAt(*Collector.found(), Wanted, /*IsForward=*/true))
      return *Stop;
    After = Collector.found()->place();
  }
}

std::optional<FoundEvent> FunctionalReplay::findLast(const Events &Wanted,
                                                     EventPlace Before,
                                                     bool &WasStopped) {
  uint64_t End = Before.At.Time + (Before.IsAccess ? 1 : 0);
  while (true) {
    const uint64_t Begin = Time.pointBefore(End);
    const EventMatcher Matcher(Chip, Text, Wanted, EventMatcher::Last,
                               std::nullopt, Before);
    FunctionalCollector Collector(Matcher, Space);
    Time.setControl(StopFlag, Report);
    const RunResult Result = Time.search(Collector, Begin, End);
    WasStopped = Result.End == RunResult::Stopped;
    if (WasStopped)
      return std::nullopt;
    if (Collector.found() || Begin == 0)
      return Collector.found();
    End = Begin;
  }
}

ReplayStop FunctionalReplay::backward(const Events &Wanted) {
  const Moment From = Now;
  EventPlace Before{Now, false};
  while (true) {
    bool WasStopped = false;
    const std::optional<FoundEvent> Found =
        findLast(Wanted, Before, WasStopped);
    ReplayStop Stop;
    if (!Found) {
      moveTo(WasStopped ? From.Time : 0);
      Seen = {Now, false};
      if (WasStopped)
        Stop.Kind = ReplayStop::Interrupted;
      Stop.At = Now;
      return Stop;
    }
    if (std::optional<ReplayStop> Kept =
            stopAt(*Found, Wanted, /*IsForward=*/false))
      return *Kept;
    Before = Found->place();
  }
}

ReplayStop FunctionalReplay::goTo(Moment Target) {
  if (std::optional<ReplayStop> End = moveTo(Target.Time))
    return *End;
  Seen = {Now, false};
  ReplayStop Stop;
  Stop.Kind =
      Target.Time == 0 ? ReplayStop::Beginning : ReplayStop::Instruction;
  Stop.At = Now;
  return Stop;
}

//===----------------------------------------------------------------------===//
// Who wrote
//===----------------------------------------------------------------------===//

std::optional<LastWrite> FunctionalReplay::knownWrite(uint32_t Address,
                                                      uint32_t Bytes) {
  if (Space.isLocal(Address))
    return std::nullopt;
  const std::optional<WordWriter> Writer =
      Time.history().lastWriter(Address, Bytes);
  if (!Writer)
    return std::nullopt;
  if (Writer->Thread == WordWriter::Nobody)
    return AsLoaded{};
  if (Writer->Thread == WordWriter::User)
    return WrittenByUser{{Writer->Cycle, 0}};
  return WriteRecord{{Writer->Cycle, 0}, Writer->Thread, Writer->Pc};
}

LastWrite FunctionalReplay::lastWrite(uint32_t Number, uint32_t Address,
                                      uint32_t Bytes) {
  if (std::optional<LastWrite> Known = knownWrite(Address, Bytes))
    return *Known;
  const EventPlace SeenHere = Seen;
  const uint64_t Here = Now.Time;
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

std::unique_ptr<Replay> makeFunctionalReplay(const ChipConfig &Chip,
                                             const Program &Text,
                                             Memory &Global,
                                             ReplayOptions Request,
                                             std::string &Error) {
  auto Result = std::make_unique<FunctionalReplay>(Chip, Text, Global,
                                                   std::move(Request));
  Error = Result->error();
  if (!Error.empty())
    return nullptr;
  return Result;
}

} // namespace tp
