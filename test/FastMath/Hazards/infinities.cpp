// H4: infinities die although finite-math-only is off. Reassociation folds
// (low + high) - low to high, which is wrong where low is infinite.
//
// The pass never cancels: cured.
//
// RUN: %compile_tp %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: %compile_tp %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %compile_native %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %compile_native %s -o %t.off
// RUN: %t.off | FileCheck --check-prefix=WITHOUT %s

// CHECK: offset of the middle of an infinite interval: nan
// CHECK: costs more than infinitely much: 0
// WITHOUT: offset of the middle of an infinite interval: 1

#include <math.h>
#include <stdio.h>

[[gnu::noinline]] static float offset(float low, float high) {
  return (low + high) - low;
}

[[gnu::noinline]] static bool costsMore(float best, float cost) {
  return best + cost > best;
}

int main() {
  volatile float infinite = INFINITY;
  float middle = offset(infinite, 1);
  printf("offset of the middle of an infinite interval: %s\n",
         middle != middle ? "nan" : middle == 1 ? "1" : "other");
  printf("costs more than infinitely much: %d\n", costsMore(infinite, 1));
}
