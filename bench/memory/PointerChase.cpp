//===- PointerChase.cpp - The latency of loads over their working set -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// For each working set all threads link its lines into one ring, far apart from
// one another; then one thread follows it, once to warm the caches up and once
// with a clock. Prints bytes and hundredths of a cycle per load.
//
//===----------------------------------------------------------------------===//

#include "tp/barrier.h"
#include "tp/thread.h"

#include <stdio.h>

using namespace tp;

namespace {
struct alignas(64) Line {
  Line *Next;
};
constexpr uint32_t KiB = 1024;
constexpr uint32_t WorkingSets[] = {
    1 * KiB,   2 * KiB,   4 * KiB,   8 * KiB,   12 * KiB,   16 * KiB,
    20 * KiB,  24 * KiB,  32 * KiB,  64 * KiB,  128 * KiB,  256 * KiB,
    384 * KiB, 512 * KiB, 640 * KiB, 768 * KiB, 1024 * KiB, 2048 * KiB};
constexpr uint32_t Unrolled = 16;
Line Lines[2048 * KiB / sizeof(Line)];
} // namespace

static uint32_t greatestCommonDivisor(uint32_t A, uint32_t B) {
  while (B != 0) {
    const uint32_t Rest = A % B;
    A = B;
    B = Rest;
  }
  return A;
}

static void link(uint32_t Count) {
  // By the golden ratio: no two neighbours in the ring are near each other.
  uint32_t Step = Count * 5 / 8 + 1;
  while (greatestCommonDivisor(Count, Step) != 1)
    ++Step;
  for (uint32_t I = threadId(); I < Count; I += threadCount())
    Lines[I].Next = &Lines[(I + Step) % Count];
  barrier();
}

static Line *follow(Line *At, uint32_t Count) {
  for (uint32_t Left = Count / Unrolled; Left != 0; --Left)
#pragma clang loop unroll(full)
    for (uint32_t I = 0; I != Unrolled; ++I)
      At = At->Next;
  return At;
}

int main() {
  for (uint32_t Bytes : WorkingSets) {
    const uint32_t Count = Bytes / sizeof(Line);
    link(Count);
    if (threadId() == 0) {
      Line *At = follow(Lines, Count);
      const uint64_t Before = cycleCount() + (At == nullptr);
      At = follow(At, Count);
      const uint64_t After = cycleCount() + (At == nullptr);
      printf("%u %u\n", Bytes,
             static_cast<uint32_t>((After - Before) * 100 / Count));
    }
    barrier();
  }
  return 0;
}
