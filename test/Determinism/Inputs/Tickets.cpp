//===- Tickets.cpp - Atomic operations on what all threads share ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Who gets which ticket depends on the cycle of each atomic, and everything
// else on that: sums, a list linked by compare and exchange, a stream.
//
//===----------------------------------------------------------------------===//

#include "tp/atomic.h"
#include "tp/barrier.h"
#include "tp/stream.h"
#include "tp/thread.h"

#include <stdio.h>

using namespace tp;

namespace {
constexpr uint32_t Tickets = 4096, Buckets = 16;
uint32_t NextTicket;
uint32_t Head;
uint32_t Sums[Buckets];
uint32_t Latest;
struct {
  Stream Ring = {0, 0, 64, 0};
  uint32_t Words[64] = {};
} Handed;
} // namespace

/// Of each ticket the thread that got it and the one before in the list.
[[gnu::used]] uint32_t Results[2 * Tickets];

int main() {
  for (uint32_t Ticket;
       (Ticket = atomicAdd(&NextTicket, 1)) < Tickets;) {
    Results[2 * Ticket] = threadId();
    uint32_t Before;
    do {
      Before = atomicLoad(&Head);
      Results[2 * Ticket + 1] = Before;
    } while (Ticket % 64 == 0 &&
             atomicCompareExchange(&Head, Before, Ticket) != Before);
    atomicAdd(&Sums[Ticket % Buckets], Ticket ^ threadId());
    atomicMax(&Latest, Ticket * 3 ^ threadId());
    if (streamPush(&Handed.Ring, Ticket * 5))
      sleep(Ticket & 7);
    if (Ticket % 4 == 0)
      Results[2 * Ticket] ^= streamPop(&Handed.Ring) << 16;
  }
  barrier();
  if (threadId() == 0)
    for (uint32_t Bucket = 0; Bucket != Buckets; ++Bucket)
      printf("%2u %10u\n", Bucket, Sums[Bucket]);
  return 0;
}
