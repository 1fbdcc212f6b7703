//===- SavedPoints.cpp - States along a run -------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/SavedPoints.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace tp {

void SavedPoints::begin(SavedPoint First) {
  Points.push_back(std::move(First));
  History.open();
}

size_t SavedPoints::lastUpTo(uint64_t Time) const {
  size_t Number = Points.size() - 1;
  while (Points[Number].Time > Time)
    --Number;
  return Number;
}

const SavedPoint &SavedPoints::restore(size_t Number) {
  History.undo();
  for (; Anchor > Number; --Anchor)
    History.swap(Points[Anchor - 1].ToNext);
  for (; Anchor < Number; ++Anchor)
    History.swap(Points[Anchor].ToNext);
  return Points[Anchor];
}

void SavedPoints::join() {
  Points[Anchor].ToNext = History.close();
  History.open();
  ++Anchor;
}

void SavedPoints::add(SavedPoint New) {
  assert(!next() && "not the end");
  Points.push_back(std::move(New));
  join();
  thin(anchor().Time);
}

void SavedPoints::replaceAnchor(SavedPoint New) {
  Points[Anchor - 1].ToNext.add(History.close());
  History.open();
  Points[Anchor] = std::move(New);
}

uint64_t SavedPoints::bytes() const {
  uint64_t Sum = History.bytes();
  for (const SavedPoint &P : Points)
    Sum += P.State.bytes() + P.ToNext.bytes();
  return Sum;
}

void SavedPoints::remove(size_t Number) {
  MemoryLayer &First = Points[Number - 1].ToNext;
  MemoryLayer &Second = Points[Number].ToNext;
  if (Number > Anchor)
    std::swap(First, Second);
  First.add(std::move(Second));
  Points.erase(Points.begin() + ptrdiff_t(Number));
  if (Number < Anchor)
    --Anchor;
}

void SavedPoints::thin(uint64_t Now) {
  while (bytes() > Budget) {
    size_t Worst = 0;
    double LeastGap = 0;
    for (size_t I = 1; I + 1 < Points.size(); ++I) {
      if (I == Anchor || Points[I].IsChange)
        continue;
      const auto Before = double(Points[I - 1].Time);
      const auto Behind = double(Points[I + 1].Time);
      const double Gap =
          (Behind - Before) / (std::abs(double(Now) - Before) + 1);
      if (Worst == 0 || Gap < LeastGap) {
        Worst = I;
        LeastGap = Gap;
      }
    }
    if (Worst == 0)
      return;
    remove(Worst);
  }
}

} // namespace tp
