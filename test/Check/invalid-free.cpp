// Memory that is no block of the heap must not be given back.
//
// RUN: tpcc -O0 -g -ftp-check-objects %s -o %t.elf
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- stack 2>&1 \
// RUN:   | FileCheck %s --check-prefix=STACK
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- global 2>&1 \
// RUN:   | FileCheck %s --check-prefix=GLOBAL
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.elf -- argument 2>&1 \
// RUN:   | FileCheck %s --check-prefix=ARGUMENT
// RUN: tpsim --chip 1x1 --quiet --check=all %t.elf 2>&1 | count 0

#include <stdlib.h>
#include <string.h>

static int Table[16];

[[clang::optnone]] [[gnu::noinline]] static void destroy(void *Memory) {
  free(Memory);
}

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  int values[4] = {1, 2, 3, 4};
  int *Block = static_cast<int *>(malloc(8));
  memcpy(Block, values, 8);
  if (!strcmp(Fault, "stack"))
    // STACK: error: invalid-free: memory is given back that was not allocated
    // STACK-NEXT: 8 bytes into the stack object 'values' of 16 bytes
    // STACK: in destroy(void*) at
    // STACK: in main at {{.*}}invalid-free.cpp:[[@LINE+2]]:
    // STACK: the object began to live by thread 0
    destroy(values + 2);
  if (!strcmp(Fault, "global"))
    // GLOBAL: error: invalid-free: memory is given back that was not allocated
    // GLOBAL-NEXT: at the start of 'Table' of 64 bytes
    // GLOBAL: in main at {{.*}}invalid-free.cpp:[[@LINE+1]]:
    destroy(Table);
  if (!strcmp(Fault, "argument"))
    // ARGUMENT: error: invalid-free: memory is given back that was not
    // ARGUMENT-NEXT: into the arguments of
    destroy(Arguments[1]);
  destroy(Block);
  return Table[0];
}
