// H5: the order of flags. -ffast-math -fno-finite-math-only keeps infinities:
// then the growth of an empty box is an infinity or NaN, as in IEEE arithmetic,
// but only with the pass; without it reassociation cancels the infinite bound.
//
// In the reverse order the later -ffast-math makes infinities undefined again.
// No pass can cure that, because it is what the flags say; the driver warns
// (-Wtp-fp-flag-order), and the last lines show what it warns of.
//
// RUN: %compile_tp %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: %compile_tp %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %compile_native %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %compile_native %s -o %t.off
// RUN: %t.off | FileCheck --check-prefix=WITHOUT %s

// CHECK: empty box is empty: 1
// CHECK: growth is a number: 0
// WITHOUT: empty box is empty: 1
// WITHOUT: growth is a number: 1

// RUN: tpcc -std=c++20 -O2 -fno-finite-math-only -ffast-math %s -o %t.reverse.elf 2>&1 | FileCheck --check-prefix=WARNING %s
// RUN: %run_tp %t.reverse.elf | FileCheck --check-prefix=REVERSE %s
// WARNING: warning: {{.*}}[-Wtp-fp-flag-order]
// REVERSE: empty box is empty: 0

#include <math.h>
#include <stdio.h>

struct Interval {
  float low, high;
};

[[gnu::noinline]] static bool isEmpty(const Interval &interval) {
  return interval.low - interval.high == (float)INFINITY;
}

/// How much longer an interval gets by a margin.
[[gnu::noinline]] static float growth(const Interval &interval, float margin) {
  return (interval.high + margin) - interval.high;
}

int main() {
  volatile float infinite = INFINITY;
  Interval empty = {infinite, -infinite};
  float grown = growth(empty, 1);
  printf("empty box is empty: %d\n", isEmpty(empty));
  unsigned exponent = __builtin_bit_cast(unsigned, grown) >> 23 & 255;
  printf("growth is a number: %d\n", exponent != 255);
}
