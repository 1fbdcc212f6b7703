// Accesses outside of heap blocks, to blocks given back, and bad frees are
// reported with the place, and those of the allocation and the free.
//
// RUN: tpcc -O0 -g %s -o %t.elf
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- overflow 2>&1 \
// RUN:   | FileCheck %s --check-prefix=OVERFLOW
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- underflow 2>&1 \
// RUN:   | FileCheck %s --check-prefix=UNDERFLOW
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- use 2>&1 \
// RUN:   | FileCheck %s --check-prefix=USE
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- twice 2>&1 \
// RUN:   | FileCheck %s --check-prefix=TWICE
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- middle 2>&1 \
// RUN:   | FileCheck %s --check-prefix=MIDDLE
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- shrunk 2>&1 \
// RUN:   | FileCheck %s --check-prefix=SHRUNK
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- wild 2>&1 \
// RUN:   | FileCheck %s --check-prefix=WILD
// RUN: tpsim --chip 1x1 --quiet --check=all %t.elf -- none 2>&1 | count 0

#include <stdlib.h>
#include <string.h>

static int *make(unsigned Count) {
  return static_cast<int *>(malloc(Count * sizeof(int))); // line 25
}

static void destroy(int *Values) {
  free(Values); // line 29
}

static int sum(const int *Values, unsigned Count) {
  int Sum = 0;
  for (unsigned I = 0; I < Count; ++I)
    Sum += Values[I]; // line 35
  return Sum;
}

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  int *Values = make(10); // line 41
  for (int I = 0; I != 10; ++I)
    Values[I] = I;
  bool IsWrong = sum(Values, 10) != 45;
  if (!strcmp(Fault, "overflow"))
    // OVERFLOW: error: heap-out-of-bounds: load of 4 bytes at 0x
    // OVERFLOW-NEXT: right behind a heap block of 40 bytes
    // OVERFLOW-NEXT: loaded by thread 0 (TM 0, TP 0)
    // OVERFLOW-NEXT: #0 in sum(int const*, unsigned int) at {{.*}}heap.cpp:35:
    // OVERFLOW-NEXT: #1 in main at {{.*}}heap.cpp:[[@LINE+4]]:
    // OVERFLOW: allocated by thread 0
    // OVERFLOW: in make(unsigned int) at {{.*}}heap.cpp:25:
    // OVERFLOW: in main at {{.*}}heap.cpp:41:
    sum(Values, 11);
  if (!strcmp(Fault, "underflow"))
    // UNDERFLOW: error: heap-out-of-bounds: store of 4 bytes
    // UNDERFLOW-NEXT: 4 bytes before a heap block of 40 bytes
    // UNDERFLOW: in main at {{.*}}heap.cpp:[[@LINE+1]]:
    Values[-1] = 1 | Values[-1];
  if (!strcmp(Fault, "middle"))
    // MIDDLE: error: invalid-free: memory is given back that was not allocated
    // MIDDLE-NEXT: 8 bytes into a heap block of 40 bytes
    // MIDDLE: in destroy(int*) at {{.*}}heap.cpp:29:
    // MIDDLE: in main at {{.*}}heap.cpp:[[@LINE+1]]:
    destroy(Values + 2);
  if (!strcmp(Fault, "shrunk")) {
    Values = static_cast<int *>(realloc(Values, 20));
    // SHRUNK: error: heap-out-of-bounds: load of 4 bytes
    // SHRUNK-NEXT: right behind a heap block of 20 bytes
    sum(Values, 6);
  }
  if (!strcmp(Fault, "wild"))
    // WILD: error: heap-not-allocated: store of 4 bytes
    Values[100000] = 1;
  destroy(Values);
  make(10);
  if (!strcmp(Fault, "use"))
    // USE: error: heap-use-after-free: load of 4 bytes at 0x
    // USE-NEXT: at the start of a heap block of 40 bytes that was given back
    // USE-NEXT: loaded by thread 0
    // USE-NEXT: #0 in sum(
    // USE: given back by thread 0
    // USE: in destroy(int*) at {{.*}}heap.cpp:29:
    // USE: in main at
    // USE: allocated by thread 0
    // USE: in make(unsigned int) at
    // USE: tpsim: checks: 1 fault
    IsWrong |= sum(Values, 10) == 46;
  if (!strcmp(Fault, "twice"))
    // TWICE: error: double-free: memory is given back that was given back
    // TWICE: in destroy(int*) at {{.*}}heap.cpp:29:
    // TWICE: in main at {{.*}}heap.cpp:[[@LINE+4]]:
    // TWICE: given back before by thread 0
    // TWICE: allocated by thread 0
    // TWICE: in make(unsigned int) at
    destroy(Values);
  return IsWrong;
}
