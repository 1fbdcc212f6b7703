// That a fault is suppressed with one stack does not hide it with another.
//
// RUN: tpcc -O0 -g %s -o %t.elf
// RUN: echo 'memory:expected' > %t.txt
// RUN: not tpsim --chip 1x1 --quiet --check=memory --check-suppressions=%t.txt \
// RUN:   %t.elf 2>&1 | FileCheck %s
// RUN: echo 'memory:*expected' > %t.txt
// RUN: tpsim --chip 1x1 --quiet --check=memory --check-suppressions=%t.txt \
// RUN:   %t.elf 2>&1 | FileCheck %s --check-prefix=NONE

#include <stdlib.h>

static int last(const int *Values, int Count) { return Values[Count]; }
static int expected(const int *Values) { return last(Values, 4); }
static int unexpected(const int *Values) { return last(Values, 4); }

int main() {
  auto *Values = static_cast<int *>(calloc(4, sizeof(int)));
  // CHECK: error: heap-out-of-bounds: load of 4 bytes
  // CHECK: in last(int const*, int)
  // CHECK-NEXT: in unexpected(int const*)
  // CHECK: checks: 1 fault, 1 suppressed
  // NONE: checks: 0 faults, 1 suppressed
  volatile int Sink = expected(Values) + unexpected(Values);
  return 0 * Sink;
}
