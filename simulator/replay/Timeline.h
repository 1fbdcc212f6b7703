//===- Timeline.h - An engine at any cycle of its run -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// An engine can go on only from the beginning of an arbitration window: in the
// window it simulates one thread after the other. Cutting a run off at any
// cycle is exact, though. So the state of a cycle is the state of its window's
// beginning, which is kept, and a run from there that is cut off. Whoever goes
// on begins again at the window's beginning.
//
// If the user changes something, the run goes on from where it was cut off: at
// a point that stays.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_TIMELINE_H
#define TP_SIMULATOR_REPLAY_TIMELINE_H

#include "simulator/replay/EngineSnapshot.h"
#include "simulator/replay/EventCollector.h"
#include "simulator/replay/GlobalHistory.h"
#include "simulator/replay/Replay.h"
#include "simulator/replay/ReplayControl.h"
#include "simulator/replay/SavedPoints.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace tp {

/// Moves an engine to any cycle of its run.
class Timeline {
public:
  /// What must outlive it does so for Engine too.
  Timeline(const ChipConfig &Chip, const Program &Text, Memory &Global,
           ReplayOptions Request);

  const std::string &error() const { return Machine.error(); }
  Engine &engine() { return Machine; }
  const Engine &engine() const { return Machine; }
  GlobalHistory &history() { return History; }
  /// Where the engine is.
  uint64_t cycle() const { return Machine.cycles(); }

  /// For long runs: ends them when \p Flag is true, which may be null.
  void setControl(const std::atomic<bool> *Flag, ProgressFunction Function) {
    Control.set(Flag, std::move(Function));
  }

  /// Goes to a cycle. If the run ends before, how; the engine is then at the
  /// end. Stopped: somewhere before.
  RunResult goTo(uint64_t Cycle);
  /// Runs from the cycle \p From, or somewhat before, to the end of the window
  /// in which \p Wanted may have found its first event, at most to \p Limit (0:
  /// none; then Paused). The engine is then somewhere: goTo() follows.
  RunResult search(EventCollector &Wanted, uint64_t From, uint64_t Limit);
  /// The cycle of the last point before \p Cycle; 0 if there is none.
  uint64_t pointBefore(uint64_t Cycle) const;

  /// Lets \p Function change the engine or the memory where it is.
  void change(const std::function<void()> &Function);

  CheckpointUse use() const;

private:
  /// The beginning of the window that the engine is in, above the last point.
  struct WindowBegin {
    uint64_t Cycle = 0;
    EngineSnapshot State;
    uint64_t Written = 0;
  };

  bool isBoundary(uint64_t Cycle) const {
    return Cycle % Chip.ArbitrationWindow == 0;
  }
  /// Where a run to the cycle must begin.
  uint64_t beginFor(uint64_t Cycle) const;
  /// Goes to the last saved state that is not behind \p Begin, or stays.
  void restoreFor(uint64_t Begin);
  void restorePoint(size_t Number);
  void restoreWindow(const WindowBegin &Begin);
  void keepWindow();
  void dropWindow();
  /// Runs to \p Target, whole windows only unless it is inside of one.
  RunResult advance(uint64_t Target);
  RunResult runTo(uint64_t Target);
  /// Where a point is to be made in any case.
  uint64_t nextNewPoint() const;
  /// The engine has come to the next point.
  void joinPoint();
  void addPoint(bool IsChange);
  SavedPoint save(bool IsChange);

  const ChipConfig &Chip;
  const ReplayOptions Request;
  Engine Machine;
  GlobalHistory History;
  SavedPoints Points;
  std::optional<WindowBegin> Window;
  /// The engine cannot go on.
  bool IsCut = false;

  ReplayOutput Output;
  RunControl Control;
  EventCollector *Collector = nullptr;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_TIMELINE_H
