// The plug-in checks natively too: the same report, and exit status 1.

// RUN: %host_cxx -std=c++20 -O2 -g -ffp-contract=off -fplugin=%fp_plugin \
// RUN:   -fpass-plugin=%fp_plugin -mllvm -tp-fp-check %s %host_runtime \
// RUN:   -lpthread -o %t
// RUN: %run_cases %s %t | FileCheck %s --check-prefixes=CHECK,STRICT
// RUN: %host_cxx -std=c++20 -O3 -g -w -ffast-math -march=native \
// RUN:   -fplugin=%fp_plugin -fpass-plugin=%fp_plugin -mllvm -tp-fp-check %s \
// RUN:   %host_runtime -lpthread -o %t.fast
// RUN: %run_cases %s %t.fast | FileCheck %s --check-prefixes=CHECK,FAST
// A program may report in its own way.
// RUN: %host_cxx -std=c++20 -O0 -DOWN -fplugin=%fp_plugin \
// RUN:   -fpass-plugin=%fp_plugin -mllvm -tp-fp-check %s -o %t.own
// RUN: not %t.own nan | FileCheck %s --check-prefix=OWN
// OWN: code 51202: 7fc00000 in {{.*}}convert

#include "Inputs/cases.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

NOINLINE int convert(float X) { return int(X * 2); }
NOINLINE bool less(float A, float B) { return A < B; }
NOINLINE double product(double A, double B) { return A * B; }
NOINLINE int rounded(double X) { return lrint(X); }

volatile int Sink;
volatile double DoubleSink;

#ifdef OWN
extern "C" [[noreturn]] void __tp_fp_check_failed(uint32_t Code, uint64_t,
                                                  uint64_t First, uint64_t,
                                                  const char *Place) {
  printf("code %u: %llx %s\n", Code, (unsigned long long)First, Place);
  exit(1);
}
#endif

int main(int, char **Arguments) {
  const char *Case = Arguments[1];
  float One = floatOf(0x3F800000);
  // CHECK: nan: 1
  // STRICT-NEXT: error: thread 0 trapped: NaN converted to an integer: nan (0x7fc00000) to int32_t
  // FAST-NEXT: error: thread 0 trapped: NaN used under finite math: returned value nan (0x7fc00000)
  // STRICT-NEXT: {{^}}  in convert(float) at {{.*}}native.cpp:22:44
  CASE("nan", Sink = convert(floatOf(NaN)))
  // CHECK: range: 1
  // CHECK-NEXT: error: thread 0 trapped: number out of range converted to an integer: 6e+09 (0x4fb2d05e) to int32_t
  // CHECK-NEXT: {{^}}  in convert(float) at {{.*}}native.cpp:22:
  CASE("range", Sink = convert(floatOf(0x4F32D05E)))
  // CHECK: number: 0
  CASE("number", Sink = convert(One))
  // CHECK: less: 1
  // STRICT-NEXT: NaN compared: 1 (0x3f800000) < nan (0x7fc00000)
  // FAST-NEXT: NaN used under finite math: returned value nan (0x7fc00000)
  CASE("less", Sink = less(One, floatOf(NaN)))
  // STRICT: product: 0
  // FAST: product: 1
  // FAST-NEXT: infinity produced under finite math: 1e+200 (0x6974e718d7d7625a) * 1e+200 (0x6974e718d7d7625a) = inf (0x7ff0000000000000)
  // FAST-NEXT: {{^}}  in product(double, double) at {{.*}}native.cpp:24:
  double Big = doubleOf(0x6974E718D7D7625A);
  CASE("product", DoubleSink = product(Big, Big))
  CASE("rounded", Sink = rounded(One))
  return 2;
}
