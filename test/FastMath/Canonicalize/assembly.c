// What the rewrites become on the chip.
// RUN: %tp_bin/tpcc -O2 -ffast-math -S -o - %s | FileCheck %s
// RUN: %tp_bin/tpcc -O2 -ffast-math -mfma -S -o - %s | FileCheck --check-prefix=FMA %s
// RUN: %tp_bin/tpcc -O2 -ffast-math -mllvm %without -S -o - %s | FileCheck --check-prefix=OFF %s
// RUN: %tp_bin/tpcc -O2 -ffast-math -mfma -mllvm %without -S -o - %s | FileCheck --check-prefix=OFF-FMA %s

// CHECK-LABEL: fourth_power:
// CHECK: mul_s [[SQUARE:f[0-9]+]], f4, f4
// CHECK-NEXT: mul_s f4, [[SQUARE]], [[SQUARE]]
// CHECK-NEXT: ret
float fourth_power(float x) { return x * x * x * x; }

// One reciprocal.
// CHECK-LABEL: quotient:
// CHECK-NOT: div_s
// CHECK: rcp_s
// CHECK-NOT: rcp_s
// CHECK: ret
// OFF-LABEL: quotient:
// OFF: div_s
float quotient(float x, float y, float z) { return x / y / z; }

// CHECK-LABEL: reciprocal_root:
// CHECK: rsqrt_s f4, f4
// CHECK-NEXT: ret
// OFF-LABEL: reciprocal_root:
// OFF-NOT: rsqrt_s
// OFF: ret
float reciprocal_root(float x) { return 1 / __builtin_sqrtf(x); }

// In double precision by name, but rounded once: the same function.
// CHECK-LABEL: wide_root:
// CHECK: rsqrt_s f4, f4
// OFF-LABEL: wide_root:
// OFF-NOT: rsqrt_s
// OFF: ret
float wide_root(float x) { return 1 / __builtin_sqrt(x); }

// A quotient is a product with the reciprocal, also if there is only one.
// CHECK-LABEL: single:
// CHECK: rcp_s [[R:f[0-9]+]], f5
// CHECK-NEXT: mul_s f4, f4, [[R]]
// OFF-LABEL: single:
// OFF: div_s f4, f4, f5
float single(float x, float y) { return x / y; }

// FMA-LABEL: multiply_add:
// FMA: madd_s
float multiply_add(float a, float b, float c) { return a * b + c; }

// Equal products differ by zero.
// CHECK-LABEL: cross:
// CHECK-COUNT-2: mul_s
// CHECK: sub_s
// FMA-LABEL: cross:
// FMA-NOT: madd_s
// FMA: ret
// OFF-FMA-LABEL: cross:
// OFF-FMA: madd_s
float cross(float a, float b, float c, float d) { return a * b - c * d; }

// CHECK-LABEL: clamp:
// CHECK: max_s
// CHECK: min_s
// CHECK-NEXT: ret
float clamp(float x) { return __builtin_fminf(__builtin_fmaxf(x, 0), 1); }
