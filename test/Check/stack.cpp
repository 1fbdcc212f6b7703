// A stack overflow is reported with the calls that led there, and accesses to
// memory of functions that have returned are found.
//
// RUN: tpcc -O1 -g -Wl,-z,stack-size=4096 %s -o %t.elf
// RUN: not tpsim --chip 1x1 --quiet --check=stack %t.elf -- recursion 2>&1 \
// RUN:   | FileCheck %s --check-prefix=OVERFLOW
// RUN: not tpsim --chip 1x1 --quiet --check=stack %t.elf -- returned 2>&1 \
// RUN:   | FileCheck %s --check-prefix=RETURNED
// RUN: tpsim --chip 1x1 --quiet --check=all %t.elf 2>&1 | count 0

#include <string.h>

static volatile int Sink;

[[gnu::noinline]] static int depth(int Number) {
  volatile int Buffer[16];
  Buffer[Number % 16] = Number;
  return Number == 0 ? 0 : depth(Number - 1) + Buffer[Number % 16];
}

[[gnu::noinline]] static volatile int *escaped() {
  volatile int Local[4] = {1, 2, 3, 4};
  volatile int *Result = Local;
  __asm__("" : "+r"(Result));
  return Result;
}

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  if (!strcmp(Fault, "recursion"))
    // OVERFLOW: error: stack-overflow: the stack takes {{4[0-9]+}} bytes and may take 4096 bytes
    // OVERFLOW-NEXT: overflow by thread 0
    // OVERFLOW-NEXT: #0 in depth(int) at {{.*}}stack.cpp:
    // OVERFLOW: #1 in depth(int) at
    // OVERFLOW: calls are left out
    // OVERFLOW: in main
    return depth(1000) - 1;
  volatile int *Kept = escaped();
  if (!strcmp(Fault, "returned"))
    // RETURNED: error: stack-use-after-return: load of 4 bytes below the stack
    // RETURNED: in main at {{.*}}stack.cpp:[[@LINE+1]]:
    Sink = Kept[1];
  return 0;
}
