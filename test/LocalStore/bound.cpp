// The linker's bound is what the stack really takes, to the 16 bytes. The
// program goes down the deepest chain of calls of each kind.
//
// RUN: %python %S/Inputs/check_bound.py %t.elf tpcc -O0 %s -DKIND=plain
// RUN: tpcc -O1 -S %s -o %t.s -DKIND=throughPointer
// RUN: %python %S/Inputs/check_bound.py %t.elf tpcc %t.s
// RUN: %python %S/Inputs/check_bound.py %t.elf tpcc -O0 %s -DKIND=throughObject
// RUN: %python %S/Inputs/check_bound.py %t.elf tpcc -O2 %s -DKIND=tailCalls
// RUN: %python %S/Inputs/check_bound.py %t.elf tpcc -O2 %s -DKIND=huge

#include "tp/local_store.h"
#include <stdarg.h>

#define NOINLINE __attribute__((noinline))

template <unsigned Words> NOINLINE int useStack(int X) {
  volatile int Array[Words];
  for (unsigned I = 0; I != Words; ++I)
    Array[I] = X + static_cast<int>(I);
  return Array[static_cast<unsigned>(X) % Words];
}

NOINLINE int plain(int X) { return useStack<50>(X) + useStack<70>(X); }

// Functions of other types with larger frames are not reached.
NOINLINE float other(float X) { return useStack<500>(static_cast<int>(X)); }
float (*volatile Other)(float) = other;

int (*volatile Pointers[])(int) = {useStack<80>, useStack<90>, useStack<30>};
NOINLINE int throughPointer(int X) {
  return Pointers[X % 3](X) + Pointers[(X + 1) % 3](X) +
         Pointers[(X + 2) % 3](X);
}

struct Shape {
  virtual int area(int, int) const = 0;
};
struct Square : Shape {
  int area(int A, int) const override { return useStack<60>(A); }
};
struct Circle : Shape {
  int area(int, int B) const override { return useStack<20>(B); }
};
NOINLINE int throughObject(int X) {
  const Square S;
  const Circle C;
  const Shape *volatile Shapes[] = {&S, &C};
  return Shapes[0]->area(X, 1) + Shapes[1]->area(X, 2);
}

// With optimization each gives back its frame before it jumps, also in a
// circle.
NOINLINE int countDown(int X);
NOINLINE int tailCallee(int X) {
  useStack<40>(X);
  [[clang::musttail]] return countDown(X);
}
NOINLINE int countDown(int X) {
  if (X == 0)
    return useStack<44>(X);
#ifdef __OPTIMIZE__
  [[clang::musttail]] return tailCallee(X - 1);
#else
  return X;
#endif
}
NOINLINE int tailCalls(int X) {
  useStack<45>(X);
  return countDown(X);
}

NOINLINE int sum(int Count, ...) {
  va_list List;
  va_start(List, Count);
  int Sum = useStack<40>(Count);
  for (int I = 0; I != Count; ++I)
    Sum += va_arg(List, int);
  va_end(List);
  return Sum;
}
NOINLINE int variadic(int X) {
  return sum(12, X, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, X);
}

// The frame's size does not fit in one instruction.
NOINLINE int huge(int X) { return useStack<20000>(X) + useStack<3>(X); }

volatile int Result;

int main() {
  volatile int X = 5;
  Result = KIND(X);
  // None of it was in the free part.
  const tp::LocalStoreSpace Space = tp::freeLocalStore();
  for (uint32_t I = 0; I != Space.Bytes; ++I)
    if (Space.Begin[I])
      return 1;
  return Other(1.0f) < 0;
}
