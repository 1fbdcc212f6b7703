//===- WindowSchedule.cpp - Which TMs have something to do when -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/WindowSchedule.h"
#include "simulator/core/Thread.h"

#include <algorithm>
#include <functional>

namespace tp {

WindowSchedule::WindowSchedule(uint32_t TmCount, uint64_t WindowCycles)
    : WindowCycles(WindowCycles), Cycles(TmCount, NeverCycle),
      Horizon(WindowCycles) {
  for (uint32_t Tm = 0; Tm != TmCount; ++Tm)
    wake(Tm, 0);
}

void WindowSchedule::clear() {
  std::fill(Cycles.begin(), Cycles.end(), NeverCycle);
  Soon.clear();
  Later.clear();
}

void WindowSchedule::insert(const Entry &E) {
  if (E.Cycle < Horizon) {
    Soon.push_back(E);
  } else {
    Later.push_back(E);
    std::push_heap(Later.begin(), Later.end(), std::greater<>());
  }
}

void WindowSchedule::popLater() {
  std::pop_heap(Later.begin(), Later.end(), std::greater<>());
  Later.pop_back();
}

void WindowSchedule::wake(uint32_t Tm, uint64_t Cycle) {
  if (Cycle >= Cycles[Tm])
    return;
  Cycles[Tm] = Cycle;
  insert({Cycle, Tm});
}

uint64_t WindowSchedule::first() {
  uint64_t First = NeverCycle;
  for (const Entry &E : Soon)
    if (E.Cycle < First && isCurrent(E))
      First = E.Cycle;
  while (!Later.empty() && !isCurrent(Later.front()))
    popLater();
  return Later.empty() ? First : std::min(First, Later.front().Cycle);
}

const std::vector<uint32_t> &WindowSchedule::take(uint64_t WindowEnd) {
  Due.clear();
  auto Take = [&](const Entry &E) {
    if (!isCurrent(E))
      return;
    Due.push_back(E.Tm);
    Cycles[E.Tm] = NeverCycle;
  };
  Before.swap(Soon);
  Soon.clear();
  Horizon = WindowEnd + WindowCycles;
  for (const Entry &E : Before)
    if (E.Cycle < WindowEnd)
      Take(E);
    else
      insert(E);
  for (; !Later.empty() && Later.front().Cycle < WindowEnd; popLater())
    Take(Later.front());
  return Due;
}

void WindowSchedule::serialize(Archive &A) {
  std::vector<uint64_t> Saved = Cycles;
  A(Saved);
  if (!A.isRestoring() || Saved.size() != Cycles.size())
    return;
  clear();
  for (uint32_t Tm = 0; Tm != Saved.size(); ++Tm)
    wake(Tm, Saved[Tm]);
}

} // namespace tp
