// H3: a comparator that is no strict weak order. Where the target has a fused
// multiply-add, a.x * b.y - a.y * b.x of equal arguments is the rounding error
// of one product instead of 0, and an element is less than itself: at clang's
// default, without any flag of fast math.
//
// With the pass no difference of products is fused: cured.
//
// RUN: tpcc -O2 -mfma -ffp-contract=on %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: tpcc -O2 -mfma -ffp-contract=on %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %host_cxx -O2 -mfma %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %host_cxx -O2 -mfma %s -o %t.off
// RUN: %t.off | FileCheck --check-prefix=WITHOUT %s
//
// RUN: %compile_tp -mfma %s -o %t.fast.elf
// RUN: %run_tp %t.fast.elf | FileCheck %s

// CHECK: less than themselves: 0 of
// CHECK: less both ways: 0
// WITHOUT: less than themselves: {{[1-9][0-9]*}} of

#include <stdio.h>

struct Point {
  float x, y;
};

[[gnu::noinline]] static bool isLess(const Point &a, const Point &b) {
  return a.x * b.y - a.y * b.x > 0;
}

int main() {
  constexpr int Points = 10000;
  unsigned state = 7;
  auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) * 0x1p-24f;
  };
  int themselves = 0, bothWays = 0;
  for (int i = 0; i < Points; ++i) {
    Point a = {random(), random()}, b = {a.x * 2, a.y * 2};
    themselves += isLess(a, a);
    bothWays += isLess(a, b) && isLess(b, a);
  }
  printf("less than themselves: %d of %d\nless both ways: %d\n", themselves,
         Points, bothWays);
}
