// H3 without a fused multiply-add: a sort's comparator is inlined into its
// loop, where the reciprocal of the extent is hoisted; the check afterwards
// calls the comparator, which divides. The two disagree about which elements
// are equal, so what the sort left alone is out of order for the check, as for
// any later binary search.
//
// With the pass both orders are the same: cured. Natively stock clang escapes:
// x86 code generation makes one reciprocal of the comparator's two divisions.
//
// RUN: %compile_tp %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: %compile_tp %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %compile_native %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %compile_native %s -o %t.off
// RUN: %t.off | FileCheck %s

// CHECK: out of order: 0 of
// WITHOUT: out of order: {{[1-9][0-9]*}} of

#include <stdio.h>

constexpr int Elements = 64, Arrays = 100;

static inline bool isLess(float a, float b, float lowest, float extent) {
  return (a - lowest) / extent < (b - lowest) / extent;
}

[[gnu::noinline]] static void sort(float *values, float lowest, float extent) {
  for (int i = 1; i < Elements; ++i) {
    float value = values[i];
    int place = i;
    for (; place > 0 && isLess(value, values[place - 1], lowest, extent);
         --place)
      values[place] = values[place - 1];
    values[place] = value;
  }
}

int main() {
  bool (*volatile comparator)(float, float, float, float) = isLess;
  unsigned state = 7;
  auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) * 0x1p-24f;
  };
  int outOfOrder = 0;
  for (int array = 0; array < Arrays; ++array) {
    float lowest = random() * 0x1p-10f, extent = 1 + random();
    float values[Elements];
    // Neighbouring numbers in random order: many quotients are equal.
    float first = 1 + random();
    for (float &value : values)
      value = first + (int)(random() * Elements) * 0x1p-23f;
    sort(values, lowest, extent);
    for (int i = 1; i < Elements; ++i)
      outOfOrder += comparator(values[i], values[i - 1], lowest, extent);
  }
  printf("out of order: %d of %d\n", outOfOrder, Arrays * (Elements - 1));
}
