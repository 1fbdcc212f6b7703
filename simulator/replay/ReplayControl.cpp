//===- ReplayControl.cpp - What long runs of a replay share ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/ReplayControl.h"

#include <utility>

namespace tp {

void ReplayOutput::write(int Fd, std::string_view Bytes) {
  Written += Bytes.size();
  if (Written <= Shown)
    return;
  Shown = Written;
  if (Target)
    Target(Fd, Bytes);
}

void RunControl::set(const std::atomic<bool> *Flag, ProgressFunction Function) {
  UserFlag = Flag;
  Report = std::move(Function);
}

void RunControl::begin(bool MayMakePoints) {
  MakesPoints = MayMakePoints;
  StopNow = userStops();
  PointIsDue = false;
}

void RunControl::report(const Progress &Now) {
  if (Report)
    Report(Now);
  const Clock::duration Since = Clock::now() - LastPoint;
  PointIsDue = MakesPoints && Since > PointInterval &&
               Since > PointCost * PointCostFactor;
  if (PointIsDue || userStops())
    StopNow = true;
}

} // namespace tp
