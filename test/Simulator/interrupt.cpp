// Ctrl-C ends the run with status 130, and the statistics so far are written.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: %python %S/Inputs/expect_status.py 130 %python %S/Inputs/interrupt.py tpsim --chip 4x32 %t.elf --stats %t.json > %t.out 2> %t.err
// RUN: FileCheck %s --check-prefix=ERR < %t.err
// RUN: FileCheck %s --check-prefix=JSON < %t.json
// RUN: %python %S/Inputs/check_statistics.py %t.json
// ERR: run ended: interrupted, status 130
// ERR: tpsim: error: interrupted
// JSON: "outcome": "interrupted"
// JSON: "exit_status": 130

#include <stdio.h>

int main() {
  if (__builtin_tp_thread_id() == 0)
    printf("started\n");
  for (volatile int Forever = 1; Forever;)
    ;
}
