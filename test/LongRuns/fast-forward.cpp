// Without timing up to a marker, then in cycles.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: tpsim --quiet --chip 4x32 %t.elf --stats %t.all.json
// RUN: tpsim --quiet --chip 4x32 --fast-forward 1 %t.elf --stats %t.json > %t.out
// RUN: FileCheck %s --check-prefix=OUT < %t.out
// RUN: FileCheck %s --check-prefix=ALL < %t.all.json
// RUN: FileCheck %s --check-prefix=FAST < %t.json
// OUT: before
// OUT-NEXT: after 8128
// ALL: "mul_s": {
// ALL: "markers": {
// ALL-NEXT: "1": 128
// FAST-NOT: "mul_s"
// FAST: "markers": {
// FAST-NEXT: "2": 128
// FAST-NOT: "mul_s"

// RUN: not tpsim --quiet --chip 4x32 --fast-forward 5 %t.elf 2>&1 | FileCheck %s --check-prefix=NEVER
// NEVER: error: --fast-forward 5: all threads halted before that marker
// RUN: not tpsim --fast-forward 70000 %t.elf 2>&1 | FileCheck %s --check-prefix=RANGE
// RANGE: error: --fast-forward '70000': expected a whole number from 0 to 65535

#include <stdio.h>

unsigned Sum;
volatile float Products[128];

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  if (Thread == 0)
    printf("before\n");
  for (unsigned I = 0; I != 100; ++I)
    Products[Thread] = (Products[Thread] + 1) * 0.5f;
  __builtin_tp_prof(1);
  __atomic_fetch_add(&Sum, Thread, __ATOMIC_RELAXED);
  __builtin_tp_barrier();
  __builtin_tp_prof(2);
  if (Thread == 0)
    printf("after %u\n", *(volatile unsigned *)&Sum);
}
