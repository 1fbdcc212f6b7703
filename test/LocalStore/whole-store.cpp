// Every thread has all that its stack leaves free, and a chip whose local store
// is smaller than stack and thread_local objects does not take the program.
//
// RUN: tpcc -O2 %s -o %t.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf
// RUN: tpcc -O0 -c %s -o %t.o && tpcc %t.o -o %t.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf

// RUN: sed 's/bytes: 16 KiB/bytes: 1 KiB/' %source_dir/simulator/chips/4x32.yaml > %t.yaml
// RUN: tpcc -O2 %s -o %t.elf -DLARGE
// RUN: not tpsim --chip %t.yaml --quiet %t.elf 2>&1 | FileCheck %s
// CHECK: tpsim: error: {{.*}}.elf: the program needs {{1[0-9]+}} bytes of local store for its stack and thread_local objects, the chip has 1024; choose a chip with more local_store.bytes (--chip, --set)

#include "tp/local_store.h"
#include <assert.h>

#ifdef LARGE
thread_local char Private[900];
#else
thread_local char Private[9];
#endif

__attribute__((noinline)) static unsigned useStack(unsigned X) {
  volatile unsigned Array[50];
  for (unsigned I = 0; I != 50; ++I)
    Array[I] = X + I;
  return Array[X % 50];
}

static char pattern(uint32_t I) {
  return static_cast<char>(I * 7 + tp::threadId());
}

int main() {
  const tp::LocalStoreSpace Space = tp::freeLocalStore();
  const auto Begin = reinterpret_cast<uint32_t>(Space.Begin);
  assert(Begin == 0 - tp::localStoreBytes());
  assert(Space.Bytes % 16 == 0);
  for (uint32_t I = 0; I != Space.Bytes; ++I)
    Space.Begin[I] = pattern(I);
  for (char &C : Private)
    C = static_cast<char>(useStack(tp::threadId()));
  for (uint32_t I = 0; I != Space.Bytes; ++I)
    assert(Space.Begin[I] == pattern(I));
  for (char C : Private)
    assert(C == static_cast<char>(2 * tp::threadId() -
                                  tp::threadId() / 50 * 50));
  return 0;
}
