//===- FunctionalTimeline.h - A run without timing, anywhere ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_FUNCTIONALTIMELINE_H
#define TP_SIMULATOR_REPLAY_FUNCTIONALTIMELINE_H

#include "simulator/functional/FunctionalMachine.h"
#include "simulator/replay/FunctionalCollector.h"
#include "simulator/replay/GlobalHistory.h"
#include "simulator/replay/Replay.h"
#include "simulator/replay/ReplayControl.h"
#include "simulator/replay/SavedPoints.h"
#include "simulator/replay/StoreHistory.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace tp {

/// Moves a functional machine to any number of executed instructions. It then
/// stands before the next instruction that takes time.
class FunctionalTimeline {
public:
  /// What must outlive it does so for FunctionalMachine too.
  FunctionalTimeline(const ChipConfig &Chip, const Program &Text,
                     Memory &Global, ReplayOptions Request);

  const std::string &error() const { return Machine.error(); }
  FunctionalMachine &machine() { return Machine; }
  const FunctionalMachine &machine() const { return Machine; }
  GlobalHistory &history() { return History; }
  uint64_t time() const { return Machine.executed(); }

  /// For long runs: ends them when \p Flag is true, which may be null.
  void setControl(const std::atomic<bool> *Flag, ProgressFunction Function) {
    Control.set(Flag, std::move(Function));
  }

  /// Goes to a time. If the run ends before, how; the machine is then at the
  /// end. Stopped: somewhere before.
  RunResult goTo(uint64_t Time);
  /// Runs from the time \p From to where \p Wanted stops (Paused), at most to
  /// \p Limit. Each time is seen once.
  RunResult search(FunctionalCollector &Wanted, uint64_t From, uint64_t Limit);
  /// The time of the last point before \p Time; 0 if there is none.
  uint64_t pointBefore(uint64_t Time) const;

  /// Lets \p Function change the machine or the memory where it is.
  void change(const std::function<void()> &Function);

  CheckpointUse use() const { return Points.use(); }

private:
  /// Goes to the last point that is not behind \p Time, or stays.
  void restoreFor(uint64_t Time);
  void restored(const SavedPoint &From);
  SavedPoint save(bool IsChange);
  RunResult advance(uint64_t Target);
  RunResult runTo(uint64_t Target);
  /// Where a point is to be made in any case.
  uint64_t nextNewPoint() const;
  bool hasFound() const { return Collector && Collector->hasStopped(); }

  const ReplayOptions Request;
  FunctionalMachine Machine;
  GlobalHistory History;
  StoreHistory Stores;
  SavedPoints Points;
  /// The machine stands before an instruction that takes time.
  bool IsSettled = false;
  bool HasTrapped = false;

  ReplayOutput Output;
  RunControl Control;
  FunctionalCollector *Collector = nullptr;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_FUNCTIONALTIMELINE_H
