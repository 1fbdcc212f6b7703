/* Outlined code does the same; it is off unless asked for, and the last option
   wins.
RUN: tpcc -O2 %s -o %t.plain.elf
RUN: tpcc -O2 -moutline %s -o %t.short.elf
RUN: tpcc -O2 -moutline -fno-lto %s -o %t.parts.elf
RUN: tpcc -O2 -moutline -mno-outline %s -o %t.last.elf
RUN: cmp %t.plain.elf %t.last.elf
RUN: llvm-nm %t.short.elf | FileCheck %s
RUN: llvm-nm %t.parts.elf | FileCheck %s
RUN: llvm-nm %t.plain.elf | FileCheck %s --check-prefix=PLAIN
RUN: tpsim %t.plain.elf --quiet --chip 1x1 > %t.plain.out
RUN: tpsim %t.short.elf --quiet --chip 1x1 | diff %t.plain.out -
RUN: tpsim %t.parts.elf --quiet --chip 1x1 | diff %t.plain.out -
RUN: FileCheck %s --check-prefix=OUTPUT < %t.plain.out
RUN: llvm-dwarfdump --verify %t.short.elf

CHECK: OUTLINED_FUNCTION
PLAIN-NOT: OUTLINED
OUTPUT: 10
OUTPUT: 100
*/

#include <stdio.h>

volatile int Sink[4];

__attribute__((noinline)) static void show(void) {
  printf("%d\n", Sink[0] + Sink[1] + Sink[2] + Sink[3]);
}

#define STORE(Unit)                                                            \
  Sink[0] = 1 * (Unit);                                                        \
  Sink[1] = 2 * (Unit);                                                        \
  Sink[2] = 3 * (Unit);                                                        \
  Sink[3] = 4 * (Unit);                                                        \
  show();

int main(void) {
  STORE(1)
  STORE(10)
  STORE(1)
  STORE(10)
  return 0;
}
