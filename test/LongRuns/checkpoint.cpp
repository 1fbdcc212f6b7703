// A restored run goes on to the identical output, statistics and memory.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: tpsim --quiet --chip 4x32 --host-threads 1 %t.elf --stats %t.json --dump-memory Words=%t.words > %t.out
// RUN: tpsim --quiet --chip 4x32 --host-threads 1 --checkpoint %t.save --checkpoint-every 3000 %t.elf --stats %t.saved.json > %t.saved.out
// RUN: cmp %t.json %t.saved.json
// RUN: cmp %t.out %t.saved.out
// RUN: tpsim --quiet --chip 4x32 --host-threads 3 --restore %t.save %t.elf --stats %t.restored.json --dump-memory Words=%t.restored.words > %t.restored.out
// RUN: cmp %t.json %t.restored.json
// RUN: cmp %t.out %t.restored.out
// RUN: cmp %t.words %t.restored.words
// RUN: FileCheck %s < %t.out
// CHECK: round 0 sum 8128
// CHECK: round 9 sum 81280

// Where a cycle limit cuts a run, in the middle of a window, it can be
// lengthened; the checkpoint can be written on itself.
// RUN: not tpsim --quiet --chip 4x32 --max-cycles 3333 --checkpoint %t.limit %t.elf > %t.part
// RUN: not tpsim --quiet --chip 4x32 --max-cycles 5555 --restore %t.limit --checkpoint %t.limit %t.elf > %t.part
// RUN: tpsim --quiet --chip 4x32 --restore %t.limit %t.elf --stats %t.limit.json > %t.limit.out
// RUN: cmp %t.json %t.limit.json
// RUN: cmp %t.out %t.limit.out

// A chip with caches and DRAM.
// RUN: tpsim --quiet --chip trax-32x32 --set tm.count=4 --host-threads 1 %t.elf --stats %t.caches.json > %t.caches.out
// RUN: tpsim --quiet --chip trax-32x32 --set tm.count=4 --checkpoint %t.caches --checkpoint-every 1777 --host-threads 2 %t.elf > /dev/null
// RUN: tpsim --quiet --chip trax-32x32 --set tm.count=4 --restore %t.caches --host-threads 1 %t.elf --stats %t.caches2.json > %t.caches2.out
// RUN: cmp %t.caches.json %t.caches2.json
// RUN: cmp %t.caches.out %t.caches2.out

#include <stdio.h>

volatile unsigned Words[1024];
unsigned Sum;

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  unsigned Threads = __builtin_tp_thread_count();
  for (unsigned Round = 0; Round != 10; ++Round) {
    if (Thread < 128)
      __atomic_fetch_add(&Sum, Thread, __ATOMIC_RELAXED);
    Words[(Thread + Round) % 1024] += Words[(Thread * 7) % 1024] + Thread;
    __builtin_tp_barrier();
    if (Thread == Round)
      printf("round %u sum %u\n", Round, *(volatile unsigned *)&Sum);
    __builtin_tp_barrier();
  }
}
