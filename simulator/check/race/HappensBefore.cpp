//===- HappensBefore.cpp - Which accesses threads have ordered ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/HappensBefore.h"

namespace tp {

HappensBefore::HappensBefore(uint32_t ThreadCount, size_t BudgetBytes)
    : Threads(ThreadCount), Ordered(ThreadCount, 0), BudgetBytes(BudgetBytes) {}

void HappensBefore::beginEpoch(uint32_t Thread) {
  Latest = std::max(Latest, ++Threads[Thread].Own);
}

void HappensBefore::orderAll() {
  for (uint32_t I = 0; I != Threads.size(); ++I) {
    ThreadClocks &T = Threads[I];
    Ordered[I] = T.Own;
    T.Known.reset();
    T.Fence = Release();
    T.Found.reset();
    beginEpoch(I);
  }
  Variables.clear();
}

void HappensBefore::keepBudget() {
  constexpr size_t VariableBytes =
      sizeof(std::pair<const uint32_t, Release>) + 4 * sizeof(void *);
  if (VectorClock::chunks() * VectorClock::ChunkBytes +
          Variables.size() * VariableBytes <=
      BudgetBytes)
    return;
  ++Overflows;
  orderAll();
}

HappensBefore::Release HappensBefore::merged(const Release &First,
                                             const Release &Second) {
  auto Known = First.Known ? std::make_shared<VectorClock>(*First.Known)
                           : std::make_shared<VectorClock>();
  Known->raise(First.Thread, First.Own);
  if (Second.Known)
    Known->join(*Second.Known);
  return {std::move(Known), Second.Thread, Second.Own};
}

void HappensBefore::fence(uint32_t Thread) {
  ThreadClocks &T = Threads[Thread];
  if (T.Found) {
    if (T.Known)
      T.Found->join(*T.Known);
    T.Known = std::move(T.Found);
  }
  T.Fence = {T.Known, Thread, T.Own};
  beginEpoch(Thread);
  keepBudget();
}

void HappensBefore::atomicLoad(uint32_t Thread, uint32_t Address,
                               bool Acquires) {
  auto Variable = Variables.find(Address);
  if (Variable == Variables.end())
    return;
  const Release &R = Variable->second;
  ThreadClocks &T = Threads[Thread];
  if (Acquires) {
    T.Known = merged(R, {T.Known, R.Thread, R.Own}).Known;
    return;
  }
  if (!T.Found)
    T.Found = std::make_unique<VectorClock>();
  if (R.Known)
    T.Found->join(*R.Known);
  T.Found->raise(R.Thread, R.Own);
}

void HappensBefore::atomicStore(uint32_t Thread, uint32_t Address) {
  const Release &Fence = Threads[Thread].Fence;
  if (Fence.Own == 0)
    Variables.erase(Address);
  else
    Variables[Address] = Fence;
  keepBudget();
}

void HappensBefore::atomicChange(uint32_t Thread, uint32_t Address) {
  atomicLoad(Thread, Address, /*Acquires=*/false);
  const Release &Fence = Threads[Thread].Fence;
  if (Fence.Own == 0)
    return;
  auto [Variable, IsNew] = Variables.try_emplace(Address, Fence);
  // What was released on the word before stays released.
  if (!IsNew)
    Variable->second = merged(Variable->second, Fence);
  keepBudget();
}

} // namespace tp
