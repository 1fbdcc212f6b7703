// setjmp and longjmp keep what a function keeps for its caller, from any depth,
// in every thread for itself.
// RUN: %host_cxx -w -O1 -x c++ %s -o %t.host && %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out
// RUN: tpcc -O3 -fno-lto %s -o %t3.elf
// RUN: tpsim --chip 1x1 --quiet %t3.elf > %t3.out
// RUN: diff %t.expected %t3.out
// RUN: tpcc -O2 -DTHREADS %s -o %t.threads.elf
// RUN: tpsim --chip 4x32 --quiet %t.threads.elf | FileCheck %s
// CHECK: 128 threads right

#include <setjmp.h>
#include <stdio.h>
#ifdef THREADS
#include <tp/atomic.h>
#include <tp/barrier.h>
#include <tp/thread.h>
#endif

#define NOINLINE __attribute__((noinline))

struct Escape {
  jmp_buf Buffer;
  volatile int Depth;
};

NOINLINE int descend(Escape &Way, int Depth, int Value) {
  int Local[4] = {Depth, Value, Depth * Value, 7};
  Way.Depth = Depth;
  if (Depth == 0)
    longjmp(Way.Buffer, Value);
  int Below = descend(Way, Depth - 1, Value);
  return Below + Local[Value & 3];
}

// Many values that live across the call in saved registers.
NOINLINE unsigned tryAll(int Seed) {
  int A = Seed * 3, B = Seed * 5, C = Seed ^ 99, D = Seed + 1, E = Seed * Seed;
  float F = Seed * 0.5f, G = Seed * 0.25f, H = Seed + 0.125f;
  volatile int Round = 0;
  volatile unsigned Sum = 0;
  Escape Way;
  int Status = setjmp(Way.Buffer);
  Sum = Sum * 31 + Status;
  Round = Round + 1;
  if (Round < 6)
    descend(Way, Round * 2, Round == 3 ? 0 : Round * 10);
  unsigned Result = Sum * 7 + A + B + C + D + E + Way.Depth;
  return Result + static_cast<int>(F * 8 + G * 8 + H * 8);
}

NOINLINE int nested(int Value) {
  jmp_buf Outer;
  volatile int Steps = 0;
  if (int Status = setjmp(Outer))
    return Status * 100 + Steps;
  jmp_buf Inner;
  if (int Status = _setjmp(Inner)) {
    Steps = Steps + 1;
    longjmp(Outer, Status + 1);
  }
  Steps = Steps + 1;
  _longjmp(Inner, Value);
}

#ifdef THREADS
uint32_t NumRight = 0;
int main() {
  int Id = static_cast<int>(tp::threadId());
  unsigned First = tryAll(Id), Second = tryAll(Id);
  if (First == Second && nested(Id + 1) == (Id + 2) * 100 + 2)
    tp::atomicAdd(&NumRight, 1u);
  tp::barrier();
  if (Id == 0)
    printf("%u threads right\n", NumRight);
}
#else
int main() {
  for (int Seed = 0; Seed != 10; ++Seed)
    printf("%u %d\n", tryAll(Seed), nested(Seed));
}
#endif
