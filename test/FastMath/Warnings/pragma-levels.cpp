// Levels in pragmas; names that nobody knows stay clang's affair.

// RUN: not tpcc -ffast-math -Wno-tp-fp-nonfinite -fsyntax-only %s 2>&1 \
// RUN:   | FileCheck %s

float a() { return __builtin_inff(); }

#pragma clang diagnostic push
#pragma clang diagnostic warning "-Wtp-fp-nonfinite"
// CHECK: :[[@LINE+12]]:34: warning: unknown warning group '-Wtp-fp-nonsense', ignored
// CHECK: :[[@LINE+12]]:34: warning: unknown warning group '-Wunheard-of', ignored
// CHECK-NOT: :{{[0-9]+}}:{{[0-9]+}}:
// CHECK: :[[@LINE+1]]:20: warning: infinity {{.*}} [-Wtp-fp-nonfinite]
float b() { return __builtin_inff(); }
#pragma clang diagnostic error "-Wtp-fp-nonfinite"
// CHECK: :[[@LINE+1]]:20: error: infinity {{.*}} [-Werror,-Wtp-fp-nonfinite]
float c() { return __builtin_inff(); }
#pragma clang diagnostic pop

float d() { return __builtin_inff(); }

#pragma clang diagnostic ignored "-Wtp-fp-nonsense"
#pragma clang diagnostic ignored "-Wunheard-of"
// CHECK: 3 warnings and 1 error generated.
