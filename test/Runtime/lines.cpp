// The lines of many threads stay whole, however long they are and in however
// many pieces they are printed.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 4x32 --quiet %t.elf > %t.out
// RUN: sort %t.out | uniq -c | FileCheck %s
// CHECK: {{^ *}}128 {{x{300}}} end{{$}}
// CHECK-NEXT: {{^ *}}128 pieces of a line{{$}}
// CHECK-NOT: {{.}}

#include <stdio.h>

int main() {
  printf("pieces");
  printf(" of");
  fputs(" a line\n", stdout);
  for (int I = 0; I < 300; ++I)
    putchar('x');
  printf(" end");
}
