// H6: the reciprocal square root of 0. It is infinite; an estimate with a
// Newton step, as stock clang makes natively, gives NaN. The chip has no
// estimate, rsqrt_s is right for 0, but x / sqrt(x) of 0, a NaN, is folded to
// sqrt(x), which is 0, where the compiler sees both.
//
// The pass has one definition of 1 / sqrt(x) and never cancels: cured.
//
// RUN: %compile_tp %s -o %t.elf
// RUN: %run_tp %t.elf | FileCheck %s
// RUN: %compile_tp %without_pass %s -o %t.off.elf
// RUN: %run_tp %t.off.elf | FileCheck --check-prefix=WITHOUT %s
// RUN: %compile_native %with_plugin %s -o %t.native
// RUN: %t.native | FileCheck %s
// RUN: %compile_native %s -o %t.off
// RUN: %t.off | FileCheck --check-prefix=ESTIMATE %s

// CHECK: 1 / sqrt(0): inf
// CHECK: 0 / sqrt(0): nan
// ESTIMATE: 1 / sqrt(0): nan
// WITHOUT: 0 / sqrt(0): 0

#include <math.h>
#include <stdio.h>

[[gnu::noinline]] static float reciprocalRoot(float x) { return 1 / sqrtf(x); }

[[gnu::noinline]] static float normalized(float x) { return x / sqrtf(x); }

static const char *kind(float value) {
  unsigned magnitude = __builtin_bit_cast(unsigned, value) & 0x7FFFFFFF;
  if (magnitude == 0)
    return "0";
  return magnitude > 0x7F800000 ? "nan" : magnitude == 0x7F800000 ? "inf" : "x";
}

int main() {
  volatile float zero = 0;
  printf("1 / sqrt(0): %s\n", kind(reciprocalRoot(zero)));
  printf("0 / sqrt(0): %s\n", kind(normalized(zero)));
}
