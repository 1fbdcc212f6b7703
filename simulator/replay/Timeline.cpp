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
      Points(History, this->Request.CheckpointBytes),
      Output(this->Request.Output) {
  if (!error().empty())
    return;
  Machine.setHostThreads(this->Request.HostThreads);
  Machine.setCommitObserver(&History);
  Machine.setOutput(
      [this](int Fd, std::string_view Bytes) { Output.write(Fd, Bytes); });
  Points.begin(save(/*IsChange=*/false));
}

uint64_t Timeline::beginFor(uint64_t Cycle) const {
  uint64_t Begin = Cycle / Chip.ArbitrationWindow * Chip.ArbitrationWindow;
  return std::max(Begin, Points.timeOf(Points.lastUpTo(Cycle)));
}

SavedPoint Timeline::save(bool IsChange) {
  SavedPoint Result;
  Result.Time = cycle();
  Result.State = EngineSnapshot(Machine, /*IsPacked=*/true);
  Result.Written = Output.written();
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
  Output.restore(Begin.Written);
  IsCut = false;
}

void Timeline::restoreWindow(const WindowBegin &Begin) {
  History.undo();
  Begin.State.restore(Machine);
  Output.restore(Begin.Written);
  IsCut = false;
}

void Timeline::keepWindow() {
  if (Window && Window->Cycle == cycle())
    return;
  dropWindow();
  Window = {cycle(), EngineSnapshot(Machine, /*IsPacked=*/false),
            Output.written()};
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
    restoreWindow(*Window);
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
  Wanted.setFlag(Control.flag());
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
  Limits.Stop = Control.flag();
  Limits.Report = [this](const Progress &Now) { Control.report(Now); };
  Control.begin(/*MayMakePoints=*/!Points.next());
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
      if (Control.isPointDue())
        addPoint(/*IsChange=*/false);
      else if (!Collector || Control.userStops())
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
    if (Collector && Collector->hasStopped())
      return Result;
  }
}

void Timeline::joinPoint() {
  if (Points.next()->IsChange)
    return restorePoint(Points.anchorNumber() + 1);
  dropWindow();
  Points.join();
}

void Timeline::addPoint(bool IsChange) {
  Control.savePoint([&] {
    dropWindow();
    Points.add(save(IsChange));
  });
}

void Timeline::change(const std::function<void()> &Function) {
  Points.forgetLater();
  Function();
  Output.forgetLater();
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
