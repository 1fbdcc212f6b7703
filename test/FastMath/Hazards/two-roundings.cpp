// H1: one source expression with two roundings. The loop that counts bins
// hoists 1 / (highest - lowest) and multiplies; the predicate that partitions
// is called through a pointer and divides. They disagree for centroids on the
// boundary of a bin, and the partition loses primitives.
//
// With the pass both multiply by the same reciprocal: cured.
//
// RUN: %compile_tp %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: %compile_tp %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %compile_native %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %compile_native %s -o %t.off
// RUN: %t.off | FileCheck --check-prefix=WITHOUT %s

// CHECK: bad splits: 0 of
// WITHOUT: bad splits: {{[1-9][0-9]*}} of

#include <stdio.h>

constexpr int Bins = 16, Primitives = 320;

/// Clamped: always a bin.
static inline int bin(float centroid, float lowest, float highest) {
  int index = (int)(Bins * ((centroid - lowest) / (highest - lowest)));
  return index < Bins ? (index > 0 ? index : 0) : Bins - 1;
}

[[gnu::noinline]] static void count(const float *centroids, float lowest,
                                    float highest, int *counts) {
  for (int i = 0; i < Primitives; ++i)
    ++counts[bin(centroids[i], lowest, highest)];
}

[[gnu::noinline]] static bool isLeft(float centroid, float lowest,
                                     float highest, int split) {
  return bin(centroid, lowest, highest) < split;
}

float Centroids[Primitives];
bool (*volatile Predicate)(float, float, float, int) = isLeft;

int main() {
  int bad = 0, splits = 0;
  // Tiles of different widths on a wall: regular, so on the boundaries.
  for (int width = 1; width <= 40; ++width) {
    float lowest = 0.1f * width, highest = lowest + Primitives * 0.05f * width;
    for (int i = 0; i < Primitives; ++i)
      Centroids[i] = lowest + i * 0.05f * width;
    int counts[Bins] = {};
    count(Centroids, lowest, highest, counts);
    int expected = 0;
    for (int split = 1; split < Bins; ++split) {
      expected += counts[split - 1];
      int left = 0;
      for (float centroid : Centroids)
        left += Predicate(centroid, lowest, highest, split);
      bad += left != expected;
      ++splits;
    }
  }
  printf("bad splits: %d of %d\n", bad, splits);
}
