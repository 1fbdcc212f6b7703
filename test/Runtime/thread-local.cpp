// Every thread has its own copy of thread_local objects: initialised data,
// zeroed data, and objects with constructors and destructors.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 4x32 --quiet %t.elf | FileCheck %s
// RUN: tpcc -O0 %s -o %t0.elf
// RUN: tpsim --chip 4x32 --quiet %t0.elf | FileCheck %s

// CHECK: 128 threads, 128 made, 0 wrong
// CHECK-NEXT: 128 ended
// CHECK-NOT: {{.}}

#include <stdio.h>
#include <stdlib.h>
#include <tp/atomic.h>
#include <tp/barrier.h>
#include <tp/thread.h>

uint32_t Made, Ended, Wrong;

struct Counter {
  uint32_t Value;
  Counter() : Value(tp::threadId() * 3) { tp::atomicAdd(&Made, 1u); }
  ~Counter() {
    if (tp::atomicAdd(&Ended, 1u) + 1 == tp::threadCount())
      printf("%u ended\n", Ended);
  }
};

thread_local uint32_t Initialised = 1000;
thread_local char Text[6] = "hello";
thread_local uint32_t Zeroed[4];
thread_local Counter Object;

__attribute__((noinline)) uint32_t step(uint32_t By) {
  Zeroed[2] += By;
  return Initialised += By;
}

int main() {
  uint32_t Id = tp::threadId();
  bool Right = step(Id) == 1000 + Id && Zeroed[2] == Id && Zeroed[0] == 0 &&
               Text[4] == 'o' && Text[5] == 0;
  tp::barrier();
  Right = Right && step(1) == 1001 + Id && Object.Value == Id * 3;
  if (!Right)
    tp::atomicAdd(&Wrong, 1u);
  tp::barrier();
  if (Id == 0)
    printf("%u threads, %u made, %u wrong\n", tp::threadCount(), Made, Wrong);
}
