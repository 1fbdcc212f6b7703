// H7: a float that is out of range of int. In C++ its conversion is undefined,
// and targets differ. tpcc saturates as the chip does; natively
// -fno-strict-float-cast-overflow asks for the same. That is a choice of code
// generation, not of the pass.
//
// What the pass decides is whether one source expression is out of range in one
// place and not in another: the loop multiplies by a reciprocal that has
// overflowed, the called function divides and stays small. With the pass both
// multiply: the conversions agree. Not cured: the quotient by a number whose
// reciprocal is infinite is itself infinite under -freciprocal-math.
//
// RUN: %compile_tp %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: %compile_tp %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %compile_native %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %compile_native %s -o %t.off
// RUN: %t.off | FileCheck --check-prefix=WITHOUT %s

// CHECK: saturated: 2147483647 -2147483648 0
// CHECK: conversions that differ: 0 of
// WITHOUT: saturated: 2147483647 -2147483648 0
// WITHOUT: conversions that differ: {{[1-9][0-9]*}} of

#include <math.h>
#include <stdio.h>

constexpr int Cells = 64;

static inline int cell(float distance, float size) {
  return (int)(distance / size);
}

[[gnu::noinline]] static void cells(const float *distances, float size,
                                    int *results) {
  for (int i = 0; i < Cells; ++i)
    results[i] = cell(distances[i], size);
}

int main() {
  volatile float large = 1e20f;
  printf("saturated: %d %d %d\n", (int)large, (int)-large,
         (int)(large * 0 / (large * 0)));
  int (*volatile single)(float, float) = cell;
  volatile float tiny = 2e-39f;
  float distances[Cells];
  for (int i = 0; i < Cells; ++i)
    distances[i] = i * 2e-39f;
  int results[Cells], different = 0;
  cells(distances, tiny, results);
  for (int i = 0; i < Cells; ++i)
    different += single(distances[i], tiny) != results[i];
  printf("conversions that differ: %d of %d\n", different, Cells);
}
