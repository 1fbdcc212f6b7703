// Static constructors run once, before any thread's main and in order; static
// destructors and atexit functions run once, after every thread's main.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 4x32 --quiet %t.elf | FileCheck %s
// RUN: tpcc -O0 %s -o %t0.elf
// RUN: tpsim --chip 1x1 --quiet %t0.elf | FileCheck %s

// CHECK: {{^}}first made
// CHECK-NEXT: second made
// CHECK-NEXT: all mains ran: 1
// CHECK-NEXT: atexit
// CHECK-NEXT: second ends
// CHECK-NEXT: first ends
// CHECK-NOT: {{.}}

#include <stdio.h>
#include <stdlib.h>
#include <tp/atomic.h>
#include <tp/barrier.h>
#include <tp/thread.h>

struct Named {
  const char *Name;
  int Value;
  explicit Named(const char *Name) : Name(Name), Value(42) {
    printf("%s made\n", Name);
  }
  ~Named() { printf("%s ends\n", Name); }
};

Named First("first");
Named Second("second");
uint32_t Mains;

int main() {
  if (First.Value != 42 || Second.Value != 42)
    return 1;
  tp::atomicAdd(&Mains, 1u);
  tp::barrier();
  if (tp::threadId() == 0) {
    atexit([] { puts("atexit"); });
    printf("all mains ran: %d\n", Mains == tp::threadCount());
  }
}
