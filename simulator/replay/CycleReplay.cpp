//===- CycleReplay.cpp - A run with timing, forward and backward ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/CycleReplay.h"
#include "simulator/core/Accounting.h"
#include "simulator/core/ThreadRequests.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

namespace tp {

CycleReplay::CycleReplay(const ChipConfig &Chip, const Program &Text,
                         Memory &Global, ReplayOptions Request)
    : ReplayMoves(Chip, Text, Global), MaxCycles(Request.MaxCycles),
      Time(this->Chip, Text, Global, std::move(Request)) {}

//===----------------------------------------------------------------------===//
// State
//===----------------------------------------------------------------------===//

std::vector<RequestUnderWay> CycleReplay::underWay(const Thread &T) const {
  std::vector<RequestUnderWay> Result;
  for (uint8_t Register = 0; Register != NumRegisters - 1; ++Register) {
    const ReadyWord Ready = T.Ready[Register];
    const bool IsPending = ready::isPending(Ready);
    const uint64_t Cycle = Time.engine().epoch() + ready::cycleOf(Ready);
    if (!IsPending && Cycle <= Time.cycle())
      continue;
    RequestUnderWay &Request = Result.emplace_back();
    Request.Register = Register;
    Request.Producer = ready::producerOf(Ready);
    Request.FromGlobalMemory = (Ready & ready::FromGlobalMemory) != 0;
    if (!IsPending)
      Request.ReadyCycle = Cycle;
    Request.IsBeyondL1 =
        IsPending && T.Requests && T.Requests->request(Register).GoneOn;
  }
  return Result;
}

/// Of those whose time is not known, which has gone less far.
static bool isReadyBefore(const RequestUnderWay &A, const RequestUnderWay &B) {
  const auto Rank = [](const RequestUnderWay &Request) {
    return std::tuple(!Request.ReadyCycle, Request.IsBeyondL1,
                      Request.ReadyCycle.value_or(0));
  };
  return Rank(A) < Rank(B);
}

/// Why one that waits for a source does not.
static Loss lossOf(const RequestUnderWay &Source, bool HasMemorySystem) {
  if (!Source.FromGlobalMemory)
    return Loss::Data;
  if (!HasMemorySystem)
    return Loss::Memory;
  return Source.IsBeyondL1 ? Loss::L2 : Loss::L1;
}

ThreadTiming CycleReplay::timing(uint32_t Number) const {
  const Thread &T = Time.engine().thread(Number);
  const ThreadPlace Place = Time.engine().placeOf(Number);
  ThreadTiming Result;
  Result.Lost = T.Lost;
  if (T.Requests)
    Result.UnansweredStores = T.Requests->unansweredStores();
  Result.UnderWay = underWay(T);
  Result.Reason = lossWithoutData(T);
  const uint32_t Word = nextTimedWord(Text, Place.Word);
  if (Result.Reason || T.State != ThreadState::Running ||
      Word >= Text.instructions().size())
    return Result;
  const RequestUnderWay *Last = nullptr;
  for (const RequestUnderWay &Request : Result.UnderWay) {
    const auto &Sources = Text.instructions()[Word].Source;
    if (Request.Register != 0 &&
        std::ranges::find(Sources, Request.Register) != std::end(Sources) &&
        (!Last || isReadyBefore(*Last, Request)))
      Last = &Request;
  }
  if (Last) {
    Result.Producer = Last->Producer;
    Result.Reason = lossOf(*Last, T.Requests != nullptr);
  }
  if (!Result.Reason && Place.Cycle > Time.cycle())
    Result.Reason = T.LastLoss;
  return Result;
}

ReplayThread CycleReplay::thread(uint32_t Number) const {
  const Thread &T = Time.engine().thread(Number);
  ReplayThread Result;
  Result.Registers = T.Registers;
  const ThreadPlace Place = Time.engine().placeOf(Number);
  Result.Pc = Text.textBegin() + nextTimedWord(Text, Place.Word) * 4;
  Result.State = T.State;
  Result.Status = T.Status;
  Result.Instructions = issuedBy(T, Place.Cycle);
  Result.Timing = timing(Number);
  return Result;
}

void CycleReplay::setRegister(uint32_t Number, unsigned Register,
                              uint32_t Value) {
  change([&] { Time.engine().setRegister(Number, Register, Value); });
}

//===----------------------------------------------------------------------===//
// Moves
//===----------------------------------------------------------------------===//

CycleReplay::SearchResult CycleReplay::search(const EventMatcher &Matcher,
                                              uint64_t From, uint64_t Limit) {
  EventCollector Collector(Chip, Text, Matcher);
  Time.setControl(StopFlag, Report);
  const RunResult Run =
      Time.search(Collector, From, Limit == NoLimit ? 0 : Limit);
  std::optional<FoundEvent> Found = Collector.found();
  // The rest of a window is run in which an event was found.
  if (Found && Matcher.kept() == EventMatcher::First && Run.TrapInfo &&
      momentOf(Run.TrapInfo->Cycle, Run.TrapInfo->Thread) < Found->At)
    Found.reset();
  return {Found, Run};
}

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
    assert(Result.TrapInfo && "a trap says what it is");
    Stop.Kind = ReplayStop::Trapped;
    Stop.Thread = Result.TrapInfo->Thread;
    Stop.Pc = Result.TrapInfo->Pc;
    const uint64_t Cycle = Result.TrapInfo->Cycle;
    Now = momentOf(Cycle, Stop.Thread);
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

std::optional<ReplayStop> CycleReplay::moveTo(Moment Target) {
  Time.setControl(nullptr, Report);
  const RunResult Result = Time.goTo(Target.Time);
  const bool EndsBefore =
      (Result.End == RunResult::Halted && Time.cycle() < Target.Time) ||
      Result.End == RunResult::Trapped ||
      (MaxCycles != 0 && MaxCycles < Target.Time);
  if (EndsBefore)
    return endOf(Result);
  Now = Target;
  return std::nullopt;
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
