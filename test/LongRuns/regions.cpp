// Statistics of what is between two markers.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: tpsim --quiet --chip 4x32 --regions 1:2 %t.elf --stats %t.json > %t.out
// RUN: FileCheck %s < %t.json
// RUN: %python %S/../Simulator/Inputs/check_statistics.py %t.json --part
// CHECK: "instructions_by_opcode": {
// CHECK: "mul": {
// CHECK-NEXT: "executed": 12800,

// The whole run has 128 * 598 divisions; in the region are the few of the
// window in which it ends.
// RUN: FileCheck %s --check-prefix=REST < %t.json
// REST: "divu": {
// REST-NEXT: "executed": {{[0-9]?[0-9]?[0-9]}},

// Two regions are added up, also if a checkpoint is between them or inside.
// RUN: tpcc -O1 -DROUNDS=2 %s -o %t.two.elf
// RUN: tpsim --quiet --chip 4x32 --regions 1:2 %t.two.elf --stats %t.two.json
// RUN: FileCheck %s --check-prefix=TWO < %t.two.json
// TWO: "mul": {
// TWO-NEXT: "executed": 25600,
// RUN: %python %S/Inputs/restored_regions.py %t.two.json tpsim --quiet --chip 4x32 --regions 1:2 %t.two.elf

// RUN: not tpsim --quiet --chip 4x32 --regions 3:4 %t.elf 2>&1 | FileCheck %s --check-prefix=NEVER
// NEVER: error: --regions 3:4: the program was never between these markers (passes of 3: 0, of 4: 0)
// RUN: not tpsim --regions 3 %t.elf 2>&1 | FileCheck %s --check-prefix=FORM
// RUN: not tpsim --regions 3:3 %t.elf 2>&1 | FileCheck %s --check-prefix=FORM
// FORM: error: --regions '{{3|3:3}}': expected the numbers of two different profile markers, <begin>:<end>

#ifndef ROUNDS
#define ROUNDS 1
#endif

volatile unsigned Results[128];

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  for (unsigned Round = 0; Round != ROUNDS; ++Round) {
    for (unsigned I = 1; I != 100; ++I)
      Results[Thread] = Thread / I;
    __builtin_tp_barrier();
    __builtin_tp_prof(1);
    __builtin_tp_barrier();
    for (unsigned I = 0; I != 100; ++I)
      Results[Thread] = Results[Thread] * Thread;
    __builtin_tp_barrier();
    __builtin_tp_prof(2);
    for (unsigned I = 1; I != 500; ++I)
      Results[Thread] = Thread / I;
    __builtin_tp_barrier();
  }
}
