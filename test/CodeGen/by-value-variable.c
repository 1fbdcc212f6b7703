// A variable that is passed by value and never read otherwise is no temporary:
// what the callee changes must be a copy.
//
// RUN: tpcc -O2 -fno-lto -S -emit-llvm %s -o - | FileCheck %s
// RUN: tpcc -O1 %s -o %t.elf && tpsim %t.elf --quiet --chip 1x1 | FileCheck %s --check-prefix=OUTPUT
// RUN: tpcc -O3 %s -o %t.elf && tpsim %t.elf --quiet --chip 1x1 | FileCheck %s --check-prefix=OUTPUT

#include <stdio.h>

struct Vector {
  int X, Y, Z;
};

__attribute__((noinline)) struct Vector make(int X) {
  struct Vector Made = {X, 2 * X, 3 * X};
  return Made;
}

__attribute__((noinline)) int use(struct Vector V) {
  V.X += 1;
  volatile int *Y = &V.Y;
  *Y += 5;
  return V.X + V.Y;
}

// CHECK-LABEL: @main(
// CHECK: memcpy
// CHECK: call {{.*}}@use(
int main(void) {
  struct Vector V = make(1);
  int Digits = 0;
  for (int I = 0; I < 3; ++I)
    Digits = Digits * 100 + use(V);
  // OUTPUT: 90909
  printf("%d\n", Digits);
}
