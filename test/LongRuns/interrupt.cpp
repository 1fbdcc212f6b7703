// Ctrl-C saves the run; the restored one goes on as if nothing had been.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: tpsim --quiet --chip 4x32 %t.elf --stats %t.json > %t.out
// RUN: %python %S/../Simulator/Inputs/expect_status.py 130 %python %S/../Simulator/Inputs/interrupt.py tpsim --quiet --chip 4x32 %t.elf --checkpoint %t.save > %t.part
// RUN: tpsim --quiet --chip 4x32 %t.elf --restore %t.save --stats %t.restored.json > %t.restored.out
// RUN: cmp %t.json %t.restored.json
// RUN: cmp %t.out %t.restored.out

#include <stdio.h>

int main() {
  if (__builtin_tp_thread_id() == 0)
    for (unsigned I = 0; I != 200; ++I)
      printf("a line long enough to fill the pipe's buffers early %u\n", I);
  for (volatile unsigned I = 0; I != 30000; ++I)
    ;
}
