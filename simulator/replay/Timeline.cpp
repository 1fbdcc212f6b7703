//===- Timeline.cpp - An engine at any cycle of its run -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/Timeline.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tp {

Timeline::Timeline(const ChipConfig &Chip, const Program &Text, Memory &Global,
                   ReplayOptions Request)
    : Chip(Chip), Request(std::move(Request)),
      Machine(Chip, Text, Global, makeMemorySystem(Chip)), History(Global),
      Points(History, this->Request.CheckpointBytes) {
  if (!error().empty())
    return;
  Machine.setHostThreads(this->Request.HostThreads);
  Machine.setCommitObserver(&History);
  Machine.setOutput([this](int Fd, std::string_view Bytes) {
    const uint64_t Begin = std::exchange(Written, Written + Bytes.size());
    if (Written <= Shown)
      return;
    if (Begin < Shown)
      Bytes.remove_prefix(Shown - Begin);
    Shown = Written;
    if (this->Request.Output)
      this->Request.Output(Fd, Bytes);
  });
  Points.begin(save(/*IsChange=*/false));
}

void Timeline::setControl(const std::atomic<bool> *Flag,
                          ProgressFunction Function) {
  UserFlag = Flag;
  Report = std::move(Function);
}

uint64_t Timeline::beginFor(uint64_t Cycle) const {
  uint64_t Begin = Cycle / Chip.ArbitrationWindow * Chip.ArbitrationWindow;
  return std::max(Begin, Points.timeOf(Points.lastUpTo(Cycle)));
}

SavedPoint Timeline::save(bool IsChange) {
  SavedPoint Result;
  Result.Time = cycle();
  Result.State = EngineSnapshot(Machine, /*IsPacked=*/true);
  Result.Written = Written;
  Result.IsChange = IsChange;
  return Result;
}

uint64_t Timeline::pointBefore(uint64_t Cycle) const {
  return Cycle == 0 ? 0 : Points.timeOf(Points.lastUpTo(Cycle - 1));
}

void Timeline::restorePoint(size_t Number) {
  dropWindow();
  const SavedPoint &Begin = Points.restore(Number);
  Begin.State.restore(Machine);
  Written = Begin.Written;
  IsCut = false;
}

void Timeline::restoreWindow() {
  History.undo();
  Window->State.restore(Machine);
  Written = Window->Written;
  IsCut = false;
}

void Timeline::keepWindow() {
  if (Window && Window->Cycle == cycle())
    return;
  dropWindow();
  Window = {cycle(), EngineSnapshot(Machine, /*IsPacked=*/false), Written};
  History.open();
}

void Timeline::dropWindow() {
  Window.reset();
  while (History.numOpen() > 1)
    History.merge();
}

void Timeline::restoreFor(uint64_t Begin) {
  const size_t Number = Points.lastUpTo(Begin);
  const bool IsAnchor = Number == Points.anchorNumber();
  uint64_t Best = Points.timeOf(Number);
  const bool WindowServes =
      Window && Window->Cycle <= Begin && Window->Cycle >= Best && IsAnchor;
  if (WindowServes)
    Best = Window->Cycle;
  if (!IsCut && cycle() <= Begin && cycle() >= Best && IsAnchor)
    return;
  if (WindowServes)
    restoreWindow();
  else
    restorePoint(Number);
}

RunResult Timeline::goTo(uint64_t Cycle) {
  if (Request.MaxCycles != 0)
    Cycle = std::min(Cycle, Request.MaxCycles);
  const uint64_t Begin = beginFor(Cycle);
  restoreFor(Begin);
  RunResult Result = advance(Begin);
  if (Result.End != RunResult::Paused)
    return Result;
  keepWindow();
  if (Cycle == Begin)
    return Result;
  Result = advance(Cycle);
  IsCut = true;
  if (Result.End == RunResult::CycleLimit)
    Result.End = RunResult::Paused;
  return Result;
}

RunResult Timeline::search(EventCollector &Wanted, uint64_t From,
                           uint64_t Limit) {
  if (Request.MaxCycles != 0)
    Limit = Limit ? std::min(Limit, Request.MaxCycles) : Request.MaxCycles;
  restoreFor(beginFor(From));
  Machine.setIssueObserver(&Wanted, Wanted.words());
  Collector = &Wanted;
  Wanted.setFlag(&StopNow);
  RunResult Result = advance(Limit ? Limit : NeverCycle);
  IsCut = true;
  Collector = nullptr;
  Machine.setIssueObserver(nullptr, {});
  return Result;
}

RunResult Timeline::runTo(uint64_t Target) {
  RunLimits Limits;
  if (isBoundary(Target))
    Limits.PauseCycle = Target;
  else if (Target != NeverCycle)
    Limits.MaxCycles = Target;
  Limits.Stop = &StopNow;
  Limits.Report = [this](const Progress &Now) {
    if (Report)
      Report(Now);
    const Clock::duration Since = Clock::now() - LastPoint;
    PointIsDue = !Points.next() && Since > PointInterval &&
                 Since > PointCost * PointCostFactor;
    if (PointIsDue || (UserFlag && *UserFlag))
      StopNow = true;
  };
  StopNow = false;
  PointIsDue = false;
  return Machine.run(Limits);
}

uint64_t Timeline::nextNewPoint() const {
  if (Request.CheckpointCycles == 0 || Points.next())
    return NeverCycle;
  const uint64_t Next = Points.anchor().Time + Request.CheckpointCycles;
  return (Next / Chip.ArbitrationWindow + 1) * Chip.ArbitrationWindow;
}

RunResult Timeline::advance(uint64_t Target) {
  assert(!IsCut && "the engine cannot go on");
  while (true) {
    if (cycle() == Target)
      return {RunResult::Paused, 0, std::nullopt};
    const SavedPoint *Known = Points.next();
    const bool HasPoint = Known && Known->Time <= Target;
    uint64_t Next = HasPoint ? Known->Time : Target;
    const uint64_t NewPoint = HasPoint ? NeverCycle : nextNewPoint();
    Next = std::min(Next, NewPoint);
    RunResult Result = runTo(Next);
    switch (Result.End) {
    case RunResult::Halted:
    case RunResult::Trapped:
      IsCut = true;
      return Result;
    case RunResult::Stopped:
      if (!PointIsDue || (UserFlag && *UserFlag))
        return Result;
      addPoint(/*IsChange=*/false);
      if (Collector && Collector->mayHaveFound())
        return Result;
      break;
    case RunResult::Paused:
    case RunResult::CycleLimit:
      if (HasPoint)
        joinPoint();
      else if (Next == NewPoint)
        addPoint(/*IsChange=*/false);
      else
        return Result;
      break;
    }
  }
}

void Timeline::joinPoint() {
  if (Points.next()->IsChange)
    return restorePoint(Points.anchorNumber() + 1);
  dropWindow();
  Points.join();
}

void Timeline::addPoint(bool IsChange) {
  const Clock::time_point Start = Clock::now();
  dropWindow();
  Points.add(save(IsChange));
  LastPoint = Clock::now();
  PointCost = LastPoint - Start;
}

void Timeline::change(const std::function<void()> &Function) {
  Points.forgetLater();
  Function();
  Shown = Written;
  const SavedPoint &Here = Points.anchor();
  if (Here.IsChange && Here.Time == cycle()) {
    dropWindow();
    Points.replaceAnchor(save(/*IsChange=*/true));
  } else {
    addPoint(/*IsChange=*/true);
  }
  restorePoint(Points.anchorNumber());
}

CheckpointUse Timeline::use() const {
  CheckpointUse Result = Points.use();
  if (Window)
    Result.Bytes += Window->State.bytes();
  return Result;
}

} // namespace tp
