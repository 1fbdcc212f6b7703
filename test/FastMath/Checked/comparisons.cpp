// A NaN stops where it is compared, but not where the program looks for it.

// RUN: tpcc -O0 -ftp-check-fp %s -o %t0.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %t0.elf -- | FileCheck %s
// RUN: tpcc -O3 -ftp-check-fp %s -o %t3.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %t3.elf -- | FileCheck %s
// RUN: tpcc -O3 %s -o %tu.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %tu.elf -- \
// RUN:   | FileCheck %s --check-prefix=OFF --implicit-check-not=trap
// OFF: less: 0

#include "Inputs/cases.h"
#include <algorithm>
#include <cmath>
#include <math.h>
#include <tp/math.h>

struct Pair {
  float First, Second;
};

volatile int Sink;

NOINLINE bool less(float A, float B) { return A < B; }
NOINLINE int tests(float X, const Pair &P) {
  return (X != X) + (P.First != P.First) + !(P.Second == P.Second) +
         isnan(X) + std::isnan(P.First) + __builtin_isnan(P.Second) +
         isunordered(X, 1.0f) + !std::isfinite(X);
}
NOINLINE float smallest(float X) {
  return fminf(X, 1) + std::fmax(X, 2.0f) + tp::fmin(3.0f, X);
}

int main(int, char **Arguments) {
  const char *Case = Arguments[1];
  float N = floatOf(NaN), One = floatOf(0x3F800000);
  // CHECK: less: 1
  // CHECK-NEXT: thread 0: NaN compared: nan (0x7fc00000) < 1 (0x3f800000)
  // CHECK-NEXT: in less(float, float) at {{.*}}comparisons.cpp:24:49
  CASE("less", Sink = less(N, One))
  // CHECK: second: 1
  // CHECK-NEXT: NaN compared: 1 (0x3f800000) < nan (0x7fc00000)
  CASE("second", Sink = less(One, N))
  // CHECK: numbers: 0
  CASE("numbers", Sink = less(One, floatOf(Infinity)))
  // CHECK: less-equal: 1
  // CHECK-NEXT: NaN compared: nan (0x7fc00000) <= 2 (0x40000000)
  CASE("less-equal", Sink = N <= 2)
  // CHECK: greater: 1
  // CHECK-NEXT: NaN compared: nan (0x7fc00000) > 2 (0x40000000)
  CASE("greater", Sink = N > 2)
  // CHECK: not-greater-equal: 1
  // CHECK-NEXT: NaN compared: nan (0x7fc00000) >= 2 (0x40000000)
  CASE("not-greater-equal", Sink = !(N >= 2))
  // CHECK: equal: 1
  // CHECK-NEXT: NaN compared: nan (0x7fc00000) == 2 (0x40000000)
  CASE("equal", Sink = N == 2)
  // CHECK: double: 1
  // CHECK-NEXT: NaN compared: nan (0x7ff8000000000000) < 0.1 (0x3fb999999999999a)
  CASE("double", Sink = doubleOf(0x7FF8000000000000) < 0.1)
  // CHECK: clamp: 1
  // CHECK-NEXT: NaN compared: nan (0x7fc00000)
  CASE("clamp", Sink = int(std::clamp(N, 0.0f, 1.0f)))
  // CHECK: tests: 0
  Pair P{N, N};
  CASE("tests", Sink = tests(N, P))
  // CHECK: minimum: 0
  CASE("minimum", Sink = int(smallest(N)))
  // CHECK: minimum-of-numbers: 0
  CASE("minimum-of-numbers", Sink = int(smallest(One)))
  // The runtime's functions are not checked: they know what a NaN is.
  // CHECK: library: 0
  CASE("library", Sink = !!std::isnan(tp::sin(N)) + !!isnan(sin(double(N))))
  return 2;
}
