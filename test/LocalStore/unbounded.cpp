// A stack without bound is an error only of a program that asks for what it
// leaves free; the message names why, and the linker takes the user's word.
//
// RUN: not tpcc -O1 %s -o %t.elf -DRECURSION 2>&1 | FileCheck %s --check-prefix=RECURSION
// RECURSION: tpcc: error: the program asks for the local store that its stack leaves free (freeLocalStore), but the stack has no bound:
// RECURSION-NEXT: {{^}}  recursion: {{(isEven|isOdd)}}(unsigned int) -> {{(isEven|isOdd)}}(unsigned int) -> {{(isEven|isOdd)}}(unsigned int){{$}}
// RECURSION-NEXT: {{^}}  reached by _start -> __tp_start_thread -> main -> {{.*}}(unsigned int){{$}}
// RECURSION-NEXT: {{^}}  change that, or set a bound yourself with -Wl,-z,stack-size=<bytes>{{$}}
// RECURSION-NOT: {{.}}

// RUN: not tpcc -O1 %s -o %t.elf -DPOINTER 2>&1 | FileCheck %s --check-prefix=POINTER
// POINTER: recursion: again(int) -> visit(int (*)(int), int) -> (pointer) -> again(int){{$}}

// RUN: not tpcc -O1 %s -o %t.elf -DALLOCA 2>&1 | FileCheck %s --check-prefix=ALLOCA
// ALLOCA: clear(unsigned int) takes stack of a size that it computes (alloca or an array of variable length)
// ALLOCA-NEXT: reached by _start -> __tp_start_thread -> main -> clear(unsigned int)

// RUN: not tpcc -O1 %s -o %t.elf -DHUGE 2>&1 | FileCheck %s --check-prefix=HUGE
// HUGE: it may take {{2[0-9]+}} bytes, more than the largest local store has

// RUN: tpcc -O1 %s -o %t.elf -DRECURSION -Wl,-z,stack-size=4000
// RUN: llvm-nm %t.elf | FileCheck %s --check-prefix=GIVEN
// GIVEN: 00000fa0 A __tp_stack_bytes
// RUN: tpsim --chip 1x1 --quiet %t.elf
// RUN: tpcc -O1 %s -o %t.elf -DRECURSION -z stack-size=0x80
// RUN: not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck %s --check-prefix=TRAP
// TRAP: trapped at cycle {{[0-9]+}}: stack overflow: the stack pointer fell to 0xffffff
// TRAP-NEXT: the program's own data begin below 0xffffff{{[0-9a-f]+}} (__tp_stack_limit); link it with a larger -Wl,-z,stack-size=<bytes>
// TRAP-NEXT: in is{{Even|Odd}}(unsigned int)

// Without freeLocalStore() nobody asks.
// RUN: tpcc -O1 %s -o %t.elf -DRECURSION -DUNUSED -Wl,-Map=%t.map
// RUN: llvm-nm %t.elf | FileCheck %s --check-prefix=UNUSED --implicit-check-not=__tp_stack_limit
// RUN: tpsim --chip 1x1 --quiet %t.elf
// RUN: FileCheck %s --check-prefix=MAP < %t.map
// UNUSED: A __tp_stack_top
// MAP: The stack of a thread has no bound:
// MAP-NEXT: recursion: is

// RUN: not tpcc %s -DRECURSION -Wl,-z,stack-size=1M 2>&1 | FileCheck %s --check-prefix=NUMBER
// RUN: not tpcc %s -DRECURSION -Wl,-z,stack-size=1048592 2>&1 | FileCheck %s --check-prefix=NUMBER
// NUMBER: error: '-z stack-size={{1M|1048592}}' is not a number of bytes from 0 to 1048576
// RUN: not tpcc %s -DRECURSION -z now 2>&1 | FileCheck %s --check-prefix=KEYWORD
// KEYWORD: error: unknown linker option '-z now'; there is -z stack-size=<bytes>

#include "tp/local_store.h"

#define NOINLINE __attribute__((noinline))

static void useStack(volatile char *Frame) {
  __asm__ volatile("" : : "r"(Frame) : "memory");
}

#ifdef RECURSION
bool isOdd(unsigned X);
NOINLINE bool isEven(unsigned X) {
  volatile char Frame[20];
  bool Result = X == 0 || !isOdd(X - 1);
  useStack(Frame);
  return Result;
}
NOINLINE bool isOdd(unsigned X) {
  volatile char Frame[20];
  bool Result = X != 0 && !isEven(X - 1);
  useStack(Frame);
  return Result;
}
static int run(int X) { return isEven(static_cast<unsigned>(X + 20)); }
#elif defined(POINTER)
NOINLINE int visit(int (*Function)(int), int X) {
  return X > 3 ? X : Function(X) + 1;
}
int (*volatile Function)(int);
NOINLINE int again(int X) { return visit(Function, X + 1) + 1; }
static int run(int X) {
  Function = again;
  return visit(Function, X);
}
#elif defined(ALLOCA)
NOINLINE void clear(unsigned Bytes) {
  useStack(static_cast<char *>(__builtin_alloca(Bytes)));
}
static int run(int X) {
  clear(static_cast<unsigned>(X));
  return X;
}
#else
static int run(int X) {
  volatile char Frame[2000000];
  useStack(Frame);
  return X;
}
#endif

int main(int ArgumentCount, char **) {
#ifndef UNUSED
  if (tp::freeLocalStore().Bytes == 0)
    return 2;
#endif
  return run(ArgumentCount) == 0;
}
