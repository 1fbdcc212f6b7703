//===- FunctionalTimeline.cpp - A run without timing, anywhere ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/FunctionalTimeline.h"

#include <algorithm>
#include <utility>

namespace tp {

FunctionalTimeline::FunctionalTimeline(const ChipConfig &Chip,
                                       const Program &Text, Memory &Global,
                                       ReplayOptions Options)
    : Request(std::move(Options)), Machine(Chip, Text, Global), History(Global),
      Stores(History), Points(History, Request.CheckpointBytes),
      Output(Request.Output) {
  if (!error().empty())
    return;
  Machine.setChecks(Stores);
  Machine.setOutput(
      [this](int Fd, std::string_view Bytes) { Output.write(Fd, Bytes); });
  Points.begin(save(/*IsChange=*/false));
  advance(0);
}

SavedPoint FunctionalTimeline::save(bool IsChange) {
  SavedPoint Result;
  Result.Time = time();
  Result.State = EngineSnapshot(Machine, /*IsPacked=*/true);
  Result.Written = Output.written();
  Result.IsChange = IsChange;
  return Result;
}

uint64_t FunctionalTimeline::pointBefore(uint64_t Time) const {
  return Time == 0 ? 0 : Points.timeOf(Points.lastUpTo(Time - 1));
}

void FunctionalTimeline::restored(const SavedPoint &From) {
  From.State.restore(Machine);
  Output.restore(From.Written);
  IsSettled = false;
  HasTrapped = false;
}

void FunctionalTimeline::restoreFor(uint64_t Time) {
  const size_t Number = Points.lastUpTo(Time);
  const bool CanStay =
      !HasTrapped && time() <= Time && Number == Points.anchorNumber();
  if (!CanStay)
    restored(Points.restore(Number));
}

RunResult FunctionalTimeline::goTo(uint64_t Time) {
  if (Request.MaxCycles != 0)
    Time = std::min(Time, Request.MaxCycles);
  restoreFor(Time);
  return advance(Time);
}

RunResult FunctionalTimeline::search(FunctionalCollector &Wanted, uint64_t From,
                                     uint64_t Limit) {
  if (Request.MaxCycles != 0)
    Limit = std::min(Limit, Request.MaxCycles);
  restoreFor(From);
  Machine.setInstructionObserver(&Wanted, Wanted.words());
  Collector = &Wanted;
  RunResult Result = advance(Limit);
  Collector = nullptr;
  Machine.setInstructionObserver(nullptr, {});
  return Result;
}

RunResult FunctionalTimeline::runTo(uint64_t Target) {
  FunctionalLimits Limits;
  Limits.PauseBefore = Target;
  Limits.Stop = Control.flag();
  Limits.Report = [this](const Progress &Now) { Control.report(Now); };
  Control.begin(/*MayMakePoints=*/!Points.next());
  RunResult Result = Machine.run(Limits);
  IsSettled = Result.End == RunResult::Paused;
  HasTrapped = Result.End == RunResult::Trapped;
  return Result;
}

uint64_t FunctionalTimeline::nextNewPoint() const {
  if (Request.CheckpointCycles == 0 || Points.next())
    return InstructionStops::Never;
  return Points.anchor().Time + Request.CheckpointCycles;
}

RunResult FunctionalTimeline::advance(uint64_t Target) {
  while (true) {
    const SavedPoint *Known = Points.next();
    const uint64_t KnownTime = Known ? Known->Time : InstructionStops::Never;
    const uint64_t NewTime = nextNewPoint();
    const uint64_t Next = std::min({Target, KnownTime, NewTime});
    RunResult Result{RunResult::Paused, 0, std::nullopt};
    if (!IsSettled || time() != Next)
      Result = runTo(Next);
    if (Result.End == RunResult::Halted || Result.End == RunResult::Trapped ||
        hasFound())
      return Result;
    const bool IsInterrupted = Result.End == RunResult::Stopped;
    if (IsInterrupted && !Control.isPointDue())
      return Result;
    if (!IsInterrupted && Known && KnownTime == Next) {
      if (Known->IsChange)
        restored(Points.restoreNext());
      else
        Points.join();
    } else if (IsInterrupted || NewTime == Next) {
      Control.savePoint([&] { Points.add(save(/*IsChange=*/false)); });
    } else {
      return Result;
    }
  }
}

void FunctionalTimeline::change(const std::function<void()> &Function) {
  Points.forgetLater();
  Function();
  Output.forgetLater();
  const SavedPoint &Here = Points.anchor();
  if (Here.IsChange && Here.Time == time())
    Points.replaceAnchor(save(/*IsChange=*/true));
  else
    Points.add(save(/*IsChange=*/true));
  IsSettled = false;
}

} // namespace tp
