// The lines of many threads stay whole, however long they are and in however
// many pieces they are printed.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 4x32 --quiet %t.elf > %t.out
// RUN: sort %t.out | uniq -c | sed s/xxxxxxxxxx/X/g | FileCheck %s
// CHECK: {{^ *}}128 pieces of a line{{$}}
// CHECK-NEXT: {{^ *}}128 XXXXXXXXXXXXXXXXXXXXXXXXXXXXXX end{{$}}
// CHECK-NOT: {{.}}

#include <stdio.h>

int main() {
  printf("pieces");
  printf(" of");
  fputs(" a line\n", stdout);
  for (int I = 0; I < 300; ++I)
    putchar('x');
  printf(" end\n");
}
