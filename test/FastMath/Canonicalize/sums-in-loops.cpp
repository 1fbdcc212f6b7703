// Sums in loops: eight lanes and a tree, the rest in order; the same bits at
// every level, on the chip and natively, with the loop inlined or not.
// RUN: %host_cxx -O0 -ffast-math -S -emit-llvm -o - %with_plugin %s \
// RUN:   -DNO_MAIN | FileCheck %s
// RUN: %host_cxx -O0 -ffast-math -S -emit-llvm -o - %with_plugin %s \
// RUN:   -DNO_MAIN -mllvm %without | FileCheck --check-prefix=OFF %s

// RUN: %host_cxx -O0 -ffast-math -mno-daz-ftz %with_plugin %s -o %t.0
// RUN: %t.0 > %t.expected
// RUN: %host_cxx -O3 -ffast-math -mno-daz-ftz %with_plugin %s -o %t.3
// RUN: %t.3 > %t.optimized
// RUN: diff %t.expected %t.optimized
// RUN: %tp_bin/tpcc -O0 -ffast-math -w %s -o %t.tp0
// RUN: tpsim --quiet --chip 1x1 %t.tp0 > %t.chip
// RUN: diff %t.expected %t.chip
// RUN: %tp_bin/tpcc -O3 -ffast-math -w %s -o %t.tp3
// RUN: tpsim --quiet --chip 1x1 %t.tp3 > %t.chip-optimized
// RUN: diff %t.expected %t.chip-optimized
// In order, the bits are others.
// RUN: %host_cxx -O3 %s -o %t.in-order
// RUN: %t.in-order > %t.other
// RUN: not diff %t.expected %t.other

#include <initializer_list>
#include <stdio.h>
#include <string.h>

// CHECK-LABEL: define {{.*}}@dot(
// CHECK-COUNT-7: phi float {{.*}}[ -0.000000e+00
// CHECK-LABEL: define {{.*}}@three(
// CHECK-NOT: -0.000000e+00
// CHECK-LABEL: define {{.*}}@total(
// CHECK-COUNT-3: phi double {{.*}}[ -0.000000e+00
// CHECK-LABEL: define {{.*}}@conditional(
// CHECK-NOT: -0.000000e+00
// CHECK-LABEL: define {{.*}}@strict(
// CHECK-NOT: -0.000000e+00
// OFF-NOT: phi float {{.*}}[ -0.000000e+00
extern "C" {

float dot(const float *A, const float *B, int Count) {
  float Sum = 0;
  for (int I = 0; I < Count; ++I)
    Sum += A[I] * B[I];
  return Sum;
}

float three(const float *A) { return A[0] + A[1] + A[2]; }

double total(const double *First, const double *Last) {
  double Sum = 1;
  while (First != Last)
    Sum += *First++;
  return Sum;
}

// A branch in the loop: in order.
float conditional(const float *A, int Count) {
  float Sum = 0;
  for (int I = 0; I < Count; ++I)
    if (A[I] > 0.25f)
      Sum += A[I];
  return Sum;
}

float strict(const float *A, int Count) {
#pragma clang fp reassociate(off)
  float Sum = 0;
  for (int I = 0; I < Count; ++I)
    Sum += A[I];
  return Sum;
}
}

#ifndef NO_MAIN
template <typename T> static void print(const char *Name, T Value) {
  unsigned long long Bits = 0;
  memcpy(&Bits, &Value, sizeof(Value));
  printf("%s %llx\n", Name, Bits);
}

int main() {
  static float A[64], B[64];
  static double D[64];
  unsigned Word = 1;
  for (int I = 0; I < 64; ++I) {
    Word = Word * 1664525u + 1013904223u;
    A[I] = float(Word >> 8) * 0x1p-24f;
    B[I] = 1.0f - A[I] * A[I];
    D[I] = double(A[I]) * B[I];
  }
  for (int Count : {0, 1, 7, 8, 9, 24, 61}) {
    print("dot", dot(A, B, Count));
    print("total", total(D, D + Count));
    print("conditional", conditional(A, Count));
    print("strict", strict(A, Count));
  }
}
#endif
