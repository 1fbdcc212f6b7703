// What the program prints is alone on standard output, what it prints to
// descriptor 2 comes with tpsim's own words on standard error, and its status is
// tpsim's.

// RUN: tpcc -O2 %s -o %t.elf
// RUN: %python %S/Inputs/expect_status.py 7 tpsim --chip 1x1 %t.elf -- a 'b c' > %t.out 2> %t.err
// RUN: FileCheck %s --check-prefix=OUT < %t.out
// RUN: FileCheck %s --check-prefix=ERR < %t.err

// OUT: {{^}}3 arguments
// OUT-NEXT: {{^}}argument a
// OUT-NEXT: {{^}}argument b c
// OUT-NOT: {{.}}

// ERR: {{^}}to standard error
// ERR: run ended: finished, status 7

// With --quiet tpsim says nothing.
// RUN: not tpsim --chip 1x1 --quiet %t.elf 2> %t.quiet | FileCheck %s --check-prefix=QUIET-OUT
// QUIET-OUT: 1 arguments
// RUN: FileCheck %s --check-prefix=QUIET-ERR < %t.quiet
// QUIET-ERR: {{^}}to standard error
// QUIET-ERR-NOT: {{.}}

// Every thread runs main; lines stay whole and come in a fixed order.
// RUN: not tpsim --chip 4x32 --quiet %t.elf 2>/dev/null > %t.many
// RUN: FileCheck %s --check-prefix=MANY < %t.many
// RUN: grep -c "^1 arguments$" %t.many | FileCheck %s --check-prefix=LINES
// MANY-NOT: {{^}}{{[^1]}}
// LINES: {{^}}128{{$}}

// The status is the first that is not 0, in the order of the threads.
// RUN: %python %S/Inputs/expect_status.py 7 tpsim --chip 4x32 --quiet %t.elf > /dev/null 2>&1

#include <stdio.h>

int main(int Count, char **Arguments) {
  printf("%d arguments\n", Count);
  for (int I = 1; I < Count; ++I)
    printf("argument %s\n", Arguments[I]);
  fprintf(stderr, "to standard error\n");
  return 7 + __builtin_tp_thread_id();
}
