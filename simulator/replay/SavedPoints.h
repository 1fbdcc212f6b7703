//===- SavedPoints.h - States along a run -----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Between each two points lies a layer of the pages of global memory that have
// changed: with the contents of its beginning if the machine is behind it, else
// with those of its end. The machine is behind one of the points, the anchor;
// what has changed since is in the history's only open layer.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_SAVEDPOINTS_H
#define TP_SIMULATOR_REPLAY_SAVEDPOINTS_H

#include "simulator/replay/EngineSnapshot.h"
#include "simulator/replay/GlobalHistory.h"
#include "simulator/replay/Replay.h"

#include <cstdint>
#include <vector>

namespace tp {

/// A state of a run, but global memory.
struct SavedPoint {
  /// Moment::Time.
  uint64_t Time = 0;
  EngineSnapshot State;
  /// Bytes that the program had written to its output.
  uint64_t Written = 0;
  /// The user has changed something here.
  bool IsChange = false;
  /// To the next point.
  MemoryLayer ToNext;
};

/// The saved states of a run and the memory between them.
class SavedPoints {
public:
  /// \p Budget: bytes of host memory. \p History must outlive it.
  SavedPoints(GlobalHistory &History, uint64_t Budget)
      : History(History), Budget(Budget) {}

  /// The first one, where the machine is.
  void begin(SavedPoint First);
  const SavedPoint &anchor() const { return Points[Anchor]; }
  /// The point behind the anchor; null if there is none.
  const SavedPoint *next() const {
    return Anchor + 1 < Points.size() ? &Points[Anchor + 1] : nullptr;
  }
  /// The number of the last point that is not behind \p Time.
  size_t lastUpTo(uint64_t Time) const;
  uint64_t timeOf(size_t Number) const { return Points[Number].Time; }
  size_t anchorNumber() const { return Anchor; }

  /// Makes global memory that of a point, which is the anchor then.
  const SavedPoint &restore(size_t Number);
  const SavedPoint &restoreNext() { return restore(Anchor + 1); }
  /// The machine has come to the next point by itself.
  void join();
  /// A point where the machine is. There must be none behind the anchor.
  void add(SavedPoint New);
  /// Saves the anchor again, where the user has changed even more.
  void replaceAnchor(SavedPoint New);
  /// Forgets what is behind the anchor.
  void forgetLater() { Points.resize(Anchor + 1); }

  CheckpointUse use() const { return {Points.size(), bytes(), Budget}; }

private:
  uint64_t bytes() const;
  /// Drops points until the rest is within the budget: near \p Now they may lie
  /// close together, far from it not.
  void thin(uint64_t Now);
  void remove(size_t Number);

  GlobalHistory &History;
  const uint64_t Budget;
  std::vector<SavedPoint> Points;
  size_t Anchor = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_SAVEDPOINTS_H
