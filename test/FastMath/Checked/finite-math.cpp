// Under -ffinite-math-only an infinity or NaN stops where it comes up. No pass
// may believe that it cannot come up.

// RUN: tpcc -w -O0 -ffast-math -ftp-check-fp %s -o %t0.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %t0.elf -- | FileCheck %s
// RUN: tpcc -w -O3 -ffast-math -ftp-check-fp %s -o %t3.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %t3.elf -- | FileCheck %s
// RUN: tpcc -w -O2 -ftp-fp=fast -ftp-check-fp %s -o %tf.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %tf.elf -- | FileCheck %s
// Also without the canonicalizer.
// RUN: tpcc -w -O3 -ffinite-math-only -ftp-check-fp \
// RUN:   -mllvm -tp-fp-canonicalize=0 %s -o %to.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %to.elf -- | FileCheck %s
// Nobody has promised anything.
// RUN: tpcc -w -O3 -ftp-fp=reproducible -ftp-check-fp %s -o %tr.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %tr.elf -- \
// RUN:   | FileCheck %s --check-prefix=REPRODUCIBLE --implicit-check-not=trap
// REPRODUCIBLE: product: 0

#include "Inputs/cases.h"
#include <math.h>

volatile float Sink;

NOINLINE float product(float A, float B) { return A * B; }
NOINLINE float sum(float A, float B) { return A + B; }
NOINLINE bool isEmpty(const float *Bounds) {
  return Bounds[0] - Bounds[1] == INFINITY;
}
NOINLINE float returned(const float *P) { return *P; }
NOINLINE float chosen(bool B, const float *P, float X) { return B ? *P : X; }
NOINLINE float negated(const float *P) { return -*P; }
NOINLINE double doubles(const double *P) { return *P * *P; }
NOINLINE float square(float A) { return A * A; }
NOINLINE float root(float A) { return sqrtf(A); }
NOINLINE float smaller(const float *P, float A) { return fminf(*P, A); }

NOINLINE float several(float A, float B, float C) {
  return A * A + sqrtf(B) + C * C;
}

int main(int, char **Arguments) {
  const char *Case = Arguments[1];
  static float Buffer[2];
  static double Doubles[1];
  float Big = floatOf(0x7F000000), One = floatOf(0x3F800000);
  // CHECK: product: 1
  // CHECK-NEXT: thread 0: infinity produced under finite math: 1.7014118e+38 (0x7f000000) * 1.7014118e+38 (0x7f000000) = inf (0x7f800000)
  // CHECK-NEXT: in product(float, float) at {{.*}}finite-math.cpp:25:53
  CASE("product", Sink = product(Big, Big))
  // CHECK: finite: 0
  CASE("finite", Sink = product(Big, One) + sum(One, One) + square(One) +
                        root(One))
  // CHECK: sum: 1
  // CHECK-NEXT: infinity produced under finite math: {{.*}} (0xff000000) + {{.*}} (0xff000000) = -inf (0xff800000)
  CASE("sum", Sink = sum(-Big, -Big))
  // CHECK: root: 1
  // CHECK-NEXT: NaN produced under finite math: square root of -1 (0xbf800000) = {{-?}}nan
  CASE("root", Sink = root(-One))
  // CHECK: argument: 1
  // CHECK-NEXT: infinity used under finite math: argument inf (0x7f800000) of a call
  // CHECK-NEXT: in main at {{.*}}finite-math.cpp:[[#@LINE+1]]:
  CASE("argument", memcpy(Buffer, &Infinity, 4); Sink = product(Buffer[0], One))
  // CHECK: empty: 1
  // CHECK-NEXT: infinity used under finite math: 1 (0x3f800000) == inf (0x7f800000)
  // CHECK-NEXT: in isEmpty(float const*) at {{.*}}finite-math.cpp:28:
  CASE("empty", Buffer[0] = 2; Buffer[1] = One; Sink = isEmpty(Buffer))
  // CHECK: returned: 1
  // CHECK-NEXT: NaN used under finite math: returned value nan (0x7fc00000)
  // CHECK-NEXT: in returned(float const*) at {{.*}}finite-math.cpp:30:
  CASE("returned", memcpy(Buffer, &NaN, 4); Sink = returned(Buffer))
  // CHECK: chosen: 1
  // CHECK-NEXT: infinity used under finite math: selected value inf (0x7f800000)
  // CHECK-NEXT: in chosen(bool, float const*, float) at {{.*}}finite-math.cpp:31:
  CASE("chosen", memcpy(Buffer, &Infinity, 4); Sink = chosen(One > 0, Buffer, 1))
  // CHECK: not-chosen: 0
  CASE("not-chosen", memcpy(Buffer, &Infinity, 4); Sink = chosen(One < 0, Buffer, 1))
  // CHECK: negated: 1
  // CHECK-NEXT: infinity used under finite math: -(inf (0x7f800000)) = -inf (0xff800000)
  CASE("negated", memcpy(Buffer, &Infinity, 4); Sink = negated(Buffer))
  // CHECK: smaller: 1
  // CHECK-NEXT: infinity used under finite math: minimum of inf (0x7f800000) and 1 (0x3f800000)
  CASE("smaller", memcpy(Buffer, &Infinity, 4); Sink = smaller(Buffer, One))
  // CHECK: doubles: 1
  // CHECK-NEXT: infinity produced under finite math: 1e+200 (0x6974e718d7d7625a) * 1e+200 (0x6974e718d7d7625a) = inf (0x7ff0000000000000)
  CASE("doubles", Doubles[0] = doubleOf(0x6974E718D7D7625A); Sink = doubles(Doubles))
  // CHECK: nan-test: 1
  // CHECK-NEXT: NaN used under finite math: nan (0x7fc00000) != nan (0x7fc00000)
  CASE("nan-test", memcpy(Buffer, &NaN, 4); Sink = Buffer[0] != Buffer[0])
  // Of several that fail the first is reported, whichever checks share a branch.
  // CHECK: first: 1
  // CHECK-NEXT: infinity produced under finite math: 1.7014118e+38 (0x7f000000) * 1.7014118e+38 (0x7f000000) = inf (0x7f800000)
  // CHECK-NEXT: in several(float, float, float) at {{.*}}finite-math.cpp:[[#SEVERAL:]]:
  CASE("first", Sink = several(Big, -One, Big))
  // CHECK: second: 1
  // CHECK-NEXT: NaN produced under finite math: square root of -1 (0xbf800000) = {{-?}}nan
  // CHECK-NEXT: in several(float, float, float) at {{.*}}finite-math.cpp:[[#SEVERAL]]:
  CASE("second", Sink = several(One, -One, Big))
  // CHECK: third: 1
  // CHECK-NEXT: infinity produced under finite math: -1.7014118e+38 (0xff000000) * -1.7014118e+38 (0xff000000) = inf (0x7f800000)
  CASE("third", Sink = several(One, One, -Big))
  // CHECK: none: 0
  CASE("none", Sink = several(One, One, One))
  // CHECK: builtin: 1
  // CHECK-NEXT: infinity produced under finite math: 1 / square root of 0 (0x00000000) = inf (0x7f800000)
  CASE("builtin", Sink = __builtin_tp_rsqrt(floatOf(0)))
  return 2;
}
