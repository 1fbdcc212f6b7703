//===- Histogram.cpp - A first kernel: counting with all threads ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Rolls two dice many times on all threads of the chip and prints how often
// each sum came up. docs/writing-a-kernel.md walks through it.
//
//===----------------------------------------------------------------------===//

#include "kernels/common/Random.h"
#include "tp/atomic.h"
#include "tp/barrier.h"
#include "tp/thread.h"

#include <stdio.h>

using namespace tp;

namespace {
constexpr uint32_t Rolls = 3600;
constexpr uint32_t Sums = 13;

// Global memory: one copy, seen by all threads.
uint32_t NextRoll;
uint32_t Counts[Sums];

// The local store: a copy for each thread, read and written in one cycle.
thread_local uint32_t MyCounts[Sums];
} // namespace

int main() {
  for (uint32_t Roll; (Roll = atomicAdd(&NextRoll, 1)) < Rolls;) {
    const RandomWords Random = randomWords(Roll, 0, 0, 0);
    ++MyCounts[2 + Random.X % 6 + Random.Y % 6];
  }
  for (uint32_t Sum = 2; Sum != Sums; ++Sum)
    if (MyCounts[Sum] != 0)
      atomicAdd(&Counts[Sum], MyCounts[Sum]);

  barrier();
  if (threadId() == 0)
    for (uint32_t Sum = 2; Sum != Sums; ++Sum)
      printf("%2u %5u\n", Sum, Counts[Sum]);
  return 0;
}
