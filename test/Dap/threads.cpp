// Threads of a chip: each has its own stack and local store; a client can list
// and use thousands of them.
//
// RUN: tpcc -O0 -g %s -o %t.elf
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/threads.js

#include "tp/thread.h"

#include <atomic>

std::atomic<unsigned> Started;
thread_local unsigned Own;
volatile unsigned Missing;
thread_local unsigned Turns;

static void work(unsigned Number) {
  Own = Number * 2; // begin
  ++Started;        // started
}

int main() {
  work(tp::threadId());
  while (Started < tp::threadCount() + Missing)
    ++Turns; // waits
  return 0; // end
}
