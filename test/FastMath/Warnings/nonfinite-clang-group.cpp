// Ours speaks in the place of clang's -Wnan-infinity-disabled, so that no place
// has two warnings, and follows its name in options and pragmas.

// RUN: tpcc -ffast-math -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: clang++ -fplugin=%tp_bin/../lib/TPFloatingPoint.so -ffast-math \
// RUN:   -fsyntax-only %s 2>&1 | FileCheck %s
// CHECK-NOT: nan-infinity-disabled
// CHECK: :[[@LINE+9]]:20: warning: infinity {{.*}} [-Wtp-fp-nonfinite]
// CHECK-NOT: nan-infinity-disabled
// CHECK-NOT: warning:
// CHECK: :[[@LINE+13]]:26: warning: this test for NaN {{.*}} [-Wtp-fp-nonfinite]
// CHECK-NOT: nan-infinity-disabled
// CHECK-NOT: warning:
// CHECK: 2 warnings generated.

#include <cmath>
float a() { return INFINITY; }

#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wnan-infinity-disabled"
float quiet() { return INFINITY; }
#pragma clang diagnostic pop

bool b(float X) { return std::isnan(X); }

// RUN: tpcc -ffast-math -Wno-nan-infinity-disabled -fsyntax-only %s 2>&1 \
// RUN:   | count 0
// RUN: tpcc -ffast-math -Wno-tp-fp-nonfinite -fsyntax-only %s 2>&1 | count 0
// RUN: not tpcc -ffast-math -Werror=nan-infinity-disabled -fsyntax-only %s 2>&1 \
// RUN:   | FileCheck --check-prefix=ERROR %s
// ERROR: error: infinity {{.*}} [-Werror,-Wtp-fp-nonfinite]

// RUN: tpcc -ffast-math -Wno-nan-infinity-disabled -Wtp-fp-nonfinite \
// RUN:   -fsyntax-only %s 2>&1 | FileCheck --check-prefix=AGAIN %s
// AGAIN: warning: infinity {{.*}} [-Wtp-fp-nonfinite]
