//===- CycleReplay.cpp - A run with timing, forward and backward ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/CycleReplay.h"
#include "simulator/core/Accounting.h"
#include "simulator/core/ThreadRequests.h"
#include "simulator/replay/HostBytes.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace tp {

CycleReplay::CycleReplay(const ChipConfig &Chip, const Program &Text,
                         Memory &Global, ReplayOptions Request)
    : Chip(Chip), Text(Text), Space(Chip, Text, Global),
      MaxCycles(Request.MaxCycles),
      Time(this->Chip, Text, Global, std::move(Request)) {}

//===----------------------------------------------------------------------===//
// State
//===----------------------------------------------------------------------===//

ThreadTiming CycleReplay::timing(uint32_t Number) const {
  const Engine &Machine = Time.engine();
  const Thread &T = Machine.thread(Number);
  const ThreadPlace Place = Machine.placeOf(Number);
  const ThreadRequests *Requests = T.Requests;
  ThreadTiming Result;
  Result.Lost = T.Lost;
  if (Requests)
    Result.UnansweredStores = Requests->unansweredStores();
  for (uint8_t Register = 0; Register != NumRegisters - 1; ++Register) {
    const ReadyWord Ready = T.Ready[Register];
    const bool IsPending = ready::isPending(Ready);
    const uint64_t Cycle = Machine.epoch() + ready::cycleOf(Ready);
    if (!IsPending && Cycle <= Time.cycle())
      continue;
    RequestUnderWay &Request = Result.UnderWay.emplace_back();
    Request.Register = Register;
    Request.Producer = ready::producerOf(Ready);
    Request.FromGlobalMemory = (Ready & ready::FromGlobalMemory) != 0;
    if (!IsPending)
      Request.ReadyCycle = Cycle;
    Request.IsBeyondL1 =
        IsPending && Requests && Requests->request(Register).GoneOn;
  }
  if (T.State == ThreadState::AtBarrier)
    Result.Reason = Loss::Barrier;
  else if (T.State == ThreadState::Halted)
    Result.Reason = Loss::Finished;
  if (T.State != ThreadState::Running)
    return Result;

  const Awaited Waits = Requests ? Requests->waitsFor() : Awaited::Nothing;
  if (Waits == Awaited::StoreEntry)
    Result.Reason = Loss::StoreBuffer;
  else if (Waits == Awaited::AllStores)
    Result.Reason = Loss::Sync;
  else if (Waits == Awaited::Line)
    Result.Reason = Loss::IcacheMiss;
  if (Result.Reason || Place.Word >= Text.instructions().size())
    return Result;
  // The source that is ready last; of those still pending the farthest.
  for (const RequestUnderWay &Request : Result.UnderWay) {
    const auto &Sources = Text.instructions()[Place.Word].Source;
    if (Request.Register == 0 ||
        std::ranges::find(Sources, Request.Register) == std::end(Sources))
      continue;
    Result.Producer = Request.Producer;
    if (!Request.FromGlobalMemory)
      Result.Reason = Loss::Data;
    else if (!Requests)
      Result.Reason = Loss::Memory;
    else if (Request.IsBeyondL1)
      Result.Reason = Loss::L2;
    else
      Result.Reason = Loss::L1;
  }
  if (!Result.Reason && Place.Cycle > Time.cycle())
    Result.Reason = T.LastLoss;
  return Result;
}

ReplayThread CycleReplay::thread(uint32_t Number) const {
  const Thread &T = Time.engine().thread(Number);
  ReplayThread Result;
  Result.Registers = T.Registers;
  Result.Pc = Text.textBegin() + Time.engine().placeOf(Number).Word * 4;
  Result.State = T.State;
  Result.Status = T.Status;
  Result.Instructions = issuedBy(T, Time.engine().placeOf(Number).Cycle);
  Result.Timing = timing(Number);
  return Result;
}

uint8_t *CycleReplay::host(uint32_t Number, uint32_t Address,
                           uint64_t Bytes) const {
  return hostBytes(Space, Time.engine().thread(Number).LocalStoreBias, Address,
                   Bytes);
}

bool CycleReplay::read(uint32_t Number, uint32_t Address,
                       std::span<uint8_t> Bytes) const {
  const uint8_t *Source = host(Number, Address, Bytes.size());
  if (Source)
    std::memcpy(Bytes.data(), Source, Bytes.size());
  return Source != nullptr;
}

//===----------------------------------------------------------------------===//
// Changes
//===----------------------------------------------------------------------===//

bool CycleReplay::write(uint32_t Number, uint32_t Address,
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

void CycleReplay::setRegister(uint32_t Number, unsigned Register,
                              uint32_t Value) {
  Time.change([&] { Time.engine().setRegister(Number, Register, Value); });
}

bool CycleReplay::setPc(uint32_t Number, uint32_t Pc) {
  const uint32_t Offset = Pc - Text.textBegin();
  if (Offset % 4 != 0 || Offset / 4 >= Text.instructions().size())
    return false;
  Time.change([&] { Time.engine().setNextWord(Number, Offset / 4); });
  return true;
}

//===----------------------------------------------------------------------===//
// Moves
//===----------------------------------------------------------------------===//

ReplayStop CycleReplay::endOf(const RunResult &Result) {
  ReplayStop Stop;
  Stop.ExitStatus = Result.ExitStatus;
  Stop.TrapInfo = Result.TrapInfo;
  switch (Result.End) {
  case RunResult::Halted: {
    Stop.Kind = ReplayStop::Halted;
    const uint64_t End = Time.cycle();
    Time.goTo(End);
    Now = {End, 0};
    Seen = {Now, true};
    break;
  }
  case RunResult::Trapped: {
    Stop.Kind = ReplayStop::Trapped;
    Stop.Thread = Result.TrapInfo->Thread;
    Stop.Pc = Result.TrapInfo->Pc;
    const uint64_t Cycle = Result.TrapInfo->Cycle;
    Now = {Cycle, orderOf(Chip, Cycle, Stop.Thread)};
    Seen = {Now, false};
    Time.goTo(Cycle);
    break;
  }
  case RunResult::Stopped: {
    Stop.Kind = ReplayStop::Interrupted;
    const uint64_t Cycle = Time.cycle();
    Time.setControl(nullptr, Report);
    Time.goTo(Cycle);
    Now = {Cycle, 0};
    Seen = {Now, false};
    break;
  }
  case RunResult::CycleLimit:
  case RunResult::Paused:
    Stop.Kind = ReplayStop::CycleLimit;
    Now = {MaxCycles, 0};
    Seen = {Now, false};
    Time.goTo(MaxCycles);
    break;
  }
  Stop.At = Now;
  return Stop;
}

std::optional<ReplayStop> CycleReplay::moveTo(Moment Target,
                                              EventPlace Behind) {
  Time.setControl(nullptr, Report);
  const RunResult Result = Time.goTo(Target.Time);
  const bool EndsBefore =
      (Result.End == RunResult::Halted && Time.cycle() < Target.Time) ||
      Result.End == RunResult::Trapped ||
      (MaxCycles != 0 && MaxCycles < Target.Time);
  if (EndsBefore)
    return endOf(Result);
  Now = Target;
  Seen = Behind;
  return std::nullopt;
}

std::vector<uint8_t>
CycleReplay::watchedBytes(const AccessEvents &Event) const {
  std::vector<uint8_t> Bytes(Event.Bytes);
  if (!read(Event.Thread.value_or(0), Event.Address, Bytes))
    Bytes.clear();
  return Bytes;
}

std::optional<ReplayStop> CycleReplay::stopAt(const FoundEvent &Found,
                                              const Events &Wanted,
                                              bool IsForward) {
  ReplayStop Stop;
  Stop.Kind = Found.Kind;
  Stop.Thread = Found.Thread;
  Stop.Pc = Found.Pc;
  Stop.Event = Found.Event;
  const Moment Behind{Found.At.Time + 1, 0};
  if (Found.Kind == ReplayStop::Access) {
    const AccessEvents &Event = Wanted.Accesses[Found.Event];
    Stop.AccessAddress = Found.Access.Address;
    Stop.AccessBytes = Found.Access.Bytes;
    Stop.IsWrite = Found.Access.Writes;
    moveTo(Found.At, {Found.At, false});
    Stop.Old = watchedBytes(Event);
    moveTo(Behind, Found.place());
    Stop.New = watchedBytes(Event);
    if (Event.OnlyChanges && Stop.IsWrite && Stop.Old == Stop.New)
      return std::nullopt;
  }
  if (Found.Kind == ReplayStop::Instruction || !IsForward)
    moveTo(Found.At, {Found.At, false});
  Stop.At = Now;
  return Stop;
}

ReplayStop CycleReplay::forward(const Events &Wanted) {
  EventPlace After = Seen;
  while (true) {
    EventCollector Collector(Chip, Text, Wanted, EventCollector::First, After,
                             std::nullopt);
    Time.setControl(StopFlag, Report);
    const RunResult Result = Time.search(Collector, After.At.Time, 0);
    const std::optional<FoundEvent> Found = Collector.found();
    if (!Found)
      return endOf(Result);
    const bool TrapsBefore =
        Result.End == RunResult::Trapped &&
        Moment{Result.TrapInfo->Cycle,
               orderOf(Chip, Result.TrapInfo->Cycle, Result.TrapInfo->Thread)} <
            Found->At;
    if (TrapsBefore)
      return endOf(Result);
    if (std::optional<ReplayStop> Stop = stopAt(*Found, Wanted, true))
      return *Stop;
    After = Found->place();
  }
}

std::optional<FoundEvent> CycleReplay::findLast(const Events &Wanted,
                                                EventPlace Before,
                                                bool &WasStopped) {
  uint64_t End = Before.At.Time + 1;
  while (true) {
    const uint64_t Begin = Time.pointBefore(End);
    EventCollector Collector(Chip, Text, Wanted, EventCollector::Last,
                             std::nullopt, Before);
    Time.setControl(StopFlag, Report);
    const RunResult Result = Time.search(Collector, Begin, End);
    WasStopped = Result.End == RunResult::Stopped;
    if (std::optional<FoundEvent> Found = Collector.found();
        Found || Begin == 0 || WasStopped)
      return WasStopped ? std::nullopt : Found;
    End = Begin;
  }
}

ReplayStop CycleReplay::backward(const Events &Wanted) {
  const Moment From = Now;
  EventPlace Before{Now, false};
  while (true) {
    bool WasStopped = false;
    const std::optional<FoundEvent> Found =
        findLast(Wanted, Before, WasStopped);
    ReplayStop Stop;
    if (WasStopped) {
      moveTo(From, {From, false});
      Stop.Kind = ReplayStop::Interrupted;
      Stop.At = Now;
      return Stop;
    }
    if (!Found) {
      moveTo({}, {});
      return Stop;
    }
    if (std::optional<ReplayStop> Kept = stopAt(*Found, Wanted, false))
      return *Kept;
    Before = Found->place();
  }
}

ReplayStop CycleReplay::goTo(Moment Target) {
  if (std::optional<ReplayStop> End = moveTo(Target, {Target, false}))
    return *End;
  ReplayStop Stop;
  Stop.Kind =
      Target == Moment() ? ReplayStop::Beginning : ReplayStop::Instruction;
  Stop.At = Now;
  return Stop;
}

//===----------------------------------------------------------------------===//
// Who wrote
//===----------------------------------------------------------------------===//

LastWrite CycleReplay::lastWrite(uint32_t Number, uint32_t Address,
                                 uint32_t Bytes) {
  std::optional<WordWriter> Writer;
  if (!Space.isLocal(Address))
    Writer = Time.history().lastWriter(Address, Bytes);
  if (Writer && Writer->Thread == WordWriter::Nobody)
    return AsLoaded{};
  if (Writer && Writer->Thread == WordWriter::User)
    return WrittenByUser{{Writer->Cycle, 0}};
  if (Writer)
    return WriteRecord{
        {Writer->Cycle, orderOf(Chip, Writer->Cycle, Writer->Thread)},
        Writer->Thread,
        Writer->Pc};

  const Moment Here = Now;
  const EventPlace SeenHere = Seen;
  Events Writes;
  AccessEvents &Any = Writes.Accesses.emplace_back();
  Any.Address = Address;
  Any.Bytes = Bytes;
  if (Space.isLocal(Address))
    Any.Thread = Number;
  const ReplayStop Stop = backward(Writes);
  moveTo(Here, SeenHere);
  if (Stop.Kind != ReplayStop::Access)
    return AsLoaded{};
  return WriteRecord{Stop.At, Stop.Thread, Stop.Pc};
}

std::unique_ptr<Replay> makeCycleReplay(const ChipConfig &Chip,
                                        const Program &Text, Memory &Global,
                                        ReplayOptions Request,
                                        std::string &Error) {
  auto Result =
      std::make_unique<CycleReplay>(Chip, Text, Global, std::move(Request));
  Error = Result->error();
  if (!Error.empty())
    return nullptr;
  return Result;
}

} // namespace tp
