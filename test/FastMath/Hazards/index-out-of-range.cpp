// H2: an index that leaves its array. The caller keeps only centroids whose
// bin, computed by the called function, exists; the loop that uses the bin as
// an index computes it again, with a hoisted reciprocal, and gets Bins.
//
// With the pass the guard and the use agree: the guard protects. What is not
// cured: the last bin + 1 itself, for centroids a few ulps below the highest.
// It exists in IEEE arithmetic too, because the subtraction rounds; always
// clamp (-Wtp-fp-conversion says where).
//
// RUN: %compile_tp %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: %compile_tp %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %compile_native %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %compile_native %s -o %t.off
// RUN: %t.off | FileCheck --check-prefix=WITHOUT %s

// CHECK: guarded indexes out of range: 0 of
// WITHOUT: guarded indexes out of range: {{[1-9][0-9]*}} of

#include <stdio.h>

constexpr int Bins = 12, Steps = 4, Ranges = 2000;

static inline int bin(float centroid, float lowest, float highest) {
  return (int)(Bins * ((centroid - lowest) / (highest - lowest)));
}

[[gnu::noinline]] static bool isInside(float centroid, float lowest,
                                       float highest) {
  return bin(centroid, lowest, highest) < Bins;
}

/// Counts in one array more than there are bins, to see them.
[[gnu::noinline]] static void count(const float *centroids, int number,
                                    float lowest, float highest, int *counts) {
  for (int i = 0; i < number; ++i)
    ++counts[bin(centroids[i], lowest, highest)];
}

static float below(float value, int steps) {
  return __builtin_bit_cast(float, __builtin_bit_cast(int, value) - steps);
}

int main() {
  int counts[Bins + 1] = {}, used = 0;
  unsigned state = 7;
  auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) * 0x1p-24f;
  };
  for (int range = 0; range < Ranges; ++range) {
    float lowest = random(), highest = lowest + random() + 0.5f;
    float kept[Steps];
    int number = 0;
    for (int step = 1; step <= Steps; ++step) {
      float centroid = below(highest, step);
      if (isInside(centroid, lowest, highest))
        kept[number++] = centroid;
    }
    count(kept, number, lowest, highest, counts);
    used += number;
  }
  printf("guarded indexes out of range: %d of %d\n", counts[Bins], used);
}
