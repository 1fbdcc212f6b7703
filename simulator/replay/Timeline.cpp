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

/// How long a state far from any point takes to come back to, at most; and what
/// part of the time points may cost.
static constexpr std::chrono::milliseconds PointInterval{300};
static constexpr int PointCostFactor = 8;

Timeline::Timeline(const ChipConfig &Chip, const Program &Text, Memory &Global,
                   ReplayOptions Request)
    : Chip(Chip), Request(std::move(Request)),
      Machine(Chip, Text, Global, makeMemorySystem(Chip)), History(Global) {
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
  Points.emplace_back().State = EngineSnapshot(Machine, /*IsPacked=*/true);
  History.open();
}

void Timeline::setControl(const std::atomic<bool> *Flag,
                          ProgressFunction Function) {
  UserFlag = Flag;
  Report = std::move(Function);
}

uint64_t Timeline::beginFor(uint64_t Cycle) const {
  uint64_t Begin = Cycle / Chip.ArbitrationWindow * Chip.ArbitrationWindow;
  const Point &Last = Points[pointFor(Cycle)];
  return std::max(Begin, Last.Cycle);
}

size_t Timeline::pointFor(uint64_t Cycle) const {
  size_t Number = Points.size() - 1;
  while (Points[Number].Cycle > Cycle)
    --Number;
  return Number;
}

uint64_t Timeline::pointBefore(uint64_t Cycle) const {
  for (size_t Number = Points.size(); Number-- != 0;)
    if (Points[Number].Cycle < Cycle)
      return Points[Number].Cycle;
  return 0;
}

void Timeline::restorePoint(size_t Number) {
  dropWindow();
  History.undo();
  for (; Anchor > Number; --Anchor)
    History.swap(Points[Anchor - 1].ToNext);
  for (; Anchor < Number; ++Anchor)
    History.swap(Points[Anchor].ToNext);
  Points[Number].State.restore(Machine);
  Written = Points[Number].Written;
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
  const size_t Number = pointFor(Begin);
  uint64_t Best = Points[Number].Cycle;
  const bool WindowServes = Window && Window->Cycle <= Begin &&
                            Window->Cycle >= Best && Anchor == Number;
  if (WindowServes)
    Best = Window->Cycle;
  if (!IsCut && cycle() <= Begin && cycle() >= Best && Anchor == Number)
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
    PointIsDue = Anchor + 1 == Points.size() && Since > PointInterval &&
                 Since > PointCost * PointCostFactor;
    if (PointIsDue || (UserFlag && *UserFlag))
      StopNow = true;
  };
  StopNow = false;
  PointIsDue = false;
  return Machine.run(Limits);
}

uint64_t Timeline::nextNewPoint() const {
  if (Request.CheckpointCycles == 0 || Anchor + 1 != Points.size())
    return NeverCycle;
  const uint64_t Next = Points.back().Cycle + Request.CheckpointCycles;
  return (Next / Chip.ArbitrationWindow + 1) * Chip.ArbitrationWindow;
}

RunResult Timeline::advance(uint64_t Target) {
  assert(!IsCut && "the engine cannot go on");
  while (true) {
    if (cycle() == Target)
      return {RunResult::Paused, 0, std::nullopt};
    const bool HasPoint =
        Anchor + 1 < Points.size() && Points[Anchor + 1].Cycle <= Target;
    uint64_t Next = HasPoint ? Points[Anchor + 1].Cycle : Target;
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
  if (Points[Anchor + 1].IsChange)
    return restorePoint(Anchor + 1);
  dropWindow();
  Points[Anchor].ToNext = History.close();
  History.open();
  ++Anchor;
}

void Timeline::addPoint(bool IsChange) {
  const Clock::time_point Start = Clock::now();
  dropWindow();
  Points[Anchor].ToNext = History.close();
  History.open();
  Point &New = Points.emplace_back();
  New.Cycle = cycle();
  New.State = EngineSnapshot(Machine, /*IsPacked=*/true);
  New.Written = Written;
  New.IsChange = IsChange;
  ++Anchor;
  thin();
  LastPoint = Clock::now();
  PointCost = LastPoint - Start;
}

void Timeline::change(const std::function<void()> &Function) {
  // What was known of later moments is not so any more.
  Points.resize(Anchor + 1);
  Function();
  Shown = Written;
  Point &Here = Points[Anchor];
  if (Here.IsChange && Here.Cycle == cycle()) {
    dropWindow();
    Points[Anchor - 1].ToNext.add(History.close());
    History.open();
    Here.State = EngineSnapshot(Machine, /*IsPacked=*/true);
  } else {
    addPoint(/*IsChange=*/true);
  }
  restorePoint(Anchor);
}

uint64_t Timeline::bytes() const {
  uint64_t Sum = History.bytes() + (Window ? Window->State.bytes() : 0);
  for (const Point &P : Points)
    Sum += P.State.bytes() + P.ToNext.bytes();
  return Sum;
}

void Timeline::thin() {
  while (bytes() > Request.CheckpointBytes) {
    // Near the moment points may lie close together, far from it not.
    size_t Worst = 0;
    double LeastGap = 0;
    const auto Now = double(cycle());
    for (size_t I = 1; I + 1 < Points.size(); ++I) {
      if (I == Anchor || Points[I].IsChange)
        continue;
      const auto Before = double(Points[I - 1].Cycle);
      const auto Behind = double(Points[I + 1].Cycle);
      const double Gap = (Behind - Before) / (std::abs(Now - Before) + 1);
      if (Worst == 0 || Gap < LeastGap) {
        Worst = I;
        LeastGap = Gap;
      }
    }
    if (Worst == 0)
      return;
    MemoryLayer &First = Points[Worst - 1].ToNext;
    MemoryLayer &Second = Points[Worst].ToNext;
    if (Worst > Anchor)
      std::swap(First, Second);
    First.add(std::move(Second));
    Points.erase(Points.begin() + ptrdiff_t(Worst));
    if (Worst < Anchor)
      --Anchor;
  }
}

CheckpointUse Timeline::use() const {
  return {Points.size(), bytes(), Request.CheckpointBytes};
}

} // namespace tp
