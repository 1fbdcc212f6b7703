// A failed assertion tells its place and ends the program.
// RUN: tpcc -O2 -g %s -o %t.elf
// RUN: not tpsim --chip 1x1 %t.elf > %t.out 2> %t.err
// RUN: FileCheck %s --check-prefix=OUT < %t.out
// RUN: FileCheck %s --check-prefix=ERR < %t.err
// RUN: tpcc -O2 -DNDEBUG %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf

// OUT: before
// ERR: assert.c:[[#@LINE+9]]: main: Assertion `Value == 2' failed.

#include <assert.h>
#include <stdio.h>

int main(void) {
  volatile int Value = 1;
  printf("before");
  /* The next line is the one that the message names. */
  assert(Value == 2);
  return 0;
}
