// Comparators, clamps and tests for empty boxes with infinities, where
// infinities are honoured.
// RUN: %tp_bin/tpcc -O2 -ffast-math -fno-finite-math-only -S -emit-llvm -o - %s | FileCheck %s
// RUN: %host_cc -O2 -ffast-math -fno-finite-math-only -S -emit-llvm -o - %with_plugin %s | FileCheck %s
// RUN: %tp_bin/tpcc -O2 -ffast-math -fno-finite-math-only -mllvm %without -S -emit-llvm -o - %s | FileCheck --check-prefix=OFF %s

// (lo + hi) - lo is NaN if lo is infinite.
// CHECK-LABEL: @center(
// CHECK: fadd float
// CHECK-NEXT: fsub float
// OFF-LABEL: @center(
// OFF-NOT: fadd
// OFF: ret float %1
float center(float lo, float hi) { return (lo + hi) - lo; }

// CHECK-LABEL: @grew(
// CHECK: fadd float
// CHECK-NEXT: fcmp ogt float
_Bool grew(float best, float add) { return best + add > best; }

// CHECK-LABEL: @is_empty(
// CHECK: fsub float
// CHECK-NEXT: fcmp oeq float {{.*}}, 0x7FF0000000000000
_Bool is_empty(float lo, float hi) { return lo - hi == __builtin_inff(); }

// CHECK-LABEL: @is_finite(
// CHECK: fsub float
// CHECK-NEXT: fcmp oeq float {{.*}}, 0.000000e+00
_Bool is_finite(float x) { return x - x == 0; }

// CHECK-LABEL: @is_nan(
// CHECK: fcmp uno float
_Bool is_nan(float x) { return x != x; }
