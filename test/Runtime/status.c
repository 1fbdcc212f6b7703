// The program's status is the first one, by thread, that is not 0.
// RUN: tpcc -O2 %s -o %t.elf
// RUN: tpsim --chip 1x1 --quiet %t.elf
// RUN: not tpsim --chip 4x32 --quiet %t.elf
// RUN: %python %S/Inputs/expect_status.py 7 tpsim --chip 4x32 --quiet %t.elf

#include <stdlib.h>

static void leave(unsigned Id) {
  if (Id == 5)
    exit(7);
}

int main(void) {
  unsigned Id = __builtin_tp_thread_id();
  leave(Id);
  return Id > 5 ? 9 : 0;
}
