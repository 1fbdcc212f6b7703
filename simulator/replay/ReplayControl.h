//===- ReplayControl.h - What long runs of a replay share -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_REPLAYCONTROL_H
#define TP_SIMULATOR_REPLAY_REPLAYCONTROL_H

#include "simulator/core/Engine.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string_view>

namespace tp {

/// Passes on what a program writes, each byte once however often the program is
/// executed again.
class ReplayOutput {
public:
  explicit ReplayOutput(OutputFunction Target) : Target(std::move(Target)) {}

  void write(int Fd, std::string_view Bytes);
  /// Bytes that the program has written up to where the machine is.
  uint64_t written() const { return Written; }
  /// The machine is where it had written so many.
  void restore(uint64_t NewWritten) { Written = NewWritten; }
  /// From here on the program may write something else.
  void forgetLater() { Shown = Written; }

private:
  OutputFunction Target;
  uint64_t Written = 0;
  uint64_t Shown = 0;
};

/// Ends a long run if the user wants that, and now and then to save a point.
class RunControl {
public:
  /// Ends runs when \p Flag is true, which may be null.
  void set(const std::atomic<bool> *Flag, ProgressFunction Function);

  /// A run begins. \p MayMakePoints: it may be ended to save a point.
  void begin(bool MayMakePoints);
  /// What a run is told to look at and to call.
  std::atomic<bool> *flag() { return &StopNow; }
  void report(const Progress &Now);
  /// Whether the last run was ended only to save a point.
  bool isPointDue() const { return PointIsDue && !userStops(); }
  bool userStops() const { return UserFlag && *UserFlag; }
  /// Calls \p Save, which saves a point.
  template <class Callable> void savePoint(Callable Save) {
    const Clock::time_point Start = Clock::now();
    Save();
    LastPoint = Clock::now();
    PointCost = LastPoint - Start;
  }

private:
  using Clock = std::chrono::steady_clock;

  /// How long a state far from any point takes to come back to, at most; and
  /// what part of the time points may cost.
  static constexpr std::chrono::milliseconds PointInterval{300};
  static constexpr int PointCostFactor = 8;

  const std::atomic<bool> *UserFlag = nullptr;
  ProgressFunction Report;
  std::atomic<bool> StopNow = false;
  bool MakesPoints = false;
  bool PointIsDue = false;
  Clock::time_point LastPoint = Clock::now();
  Clock::duration PointCost{};
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_REPLAYCONTROL_H
