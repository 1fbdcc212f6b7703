//===- Neighbours.cpp - Threads of a TM read what others write ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Nothing keeps the accesses in order: what a thread reads depends on the cycle
// in which it does. Each steers by what it has read.
//
//===----------------------------------------------------------------------===//

#include "tp/barrier.h"
#include "tp/thread.h"

using namespace tp;

namespace {
constexpr uint32_t MaxThreads = 8192;
constexpr uint32_t Rounds = 40;
} // namespace

[[gnu::used]] volatile uint32_t Results[MaxThreads];
/// Bytes of one word belong to different threads.
volatile uint8_t Marks[MaxThreads];

int main() {
  const uint32_t First = tmId() * tpCount();
  const uint32_t Me = threadId();
  uint32_t State = Me * 2654435761u + 1;
  for (uint32_t Round = 0; Round != Rounds; ++Round) {
    const uint32_t Other = First + (State >> 16) % tpCount();
    State = State * 1664525 + Results[Other] + Marks[Other ^ (Round & 1)];
    Marks[Me] = static_cast<uint8_t>(State >> 24);
    if (State % 4 != 0)
      Results[Me] = State;
    if (State % 16 == 5)
      sleep(State >> 8 & 31);
    if (State % 64 == 7)
      sync();
  }
  Results[Me] = State;
  return 0;
}
