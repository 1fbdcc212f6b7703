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

#include <initializer_list>
#include <setjmp.h>
#include <stdio.h>
#ifdef THREADS
#include <tp/atomic.h>
#include <tp/barrier.h>
#include <tp/thread.h>
#endif

#define NOINLINE __attribute__((noinline))

// Nothing that a caller keeps may come through by accident.
__attribute__((always_inline)) static inline void overwriteSavedRegisters() {
#ifdef __tp__
  float Zero = 0;
#define OVERWRITE(N) __asm__ volatile("addi r" #N ", r0, 1234" ::: "r" #N)
  OVERWRITE(16);
  OVERWRITE(17);
  OVERWRITE(18);
  OVERWRITE(19);
  OVERWRITE(20);
  OVERWRITE(21);
  OVERWRITE(22);
  OVERWRITE(23);
#undef OVERWRITE
#define OVERWRITE(N) __asm__ volatile("mov_s f" #N ", %0" ::"f"(Zero) : "f" #N)
  OVERWRITE(20);
  OVERWRITE(21);
  OVERWRITE(22);
  OVERWRITE(23);
  OVERWRITE(24);
  OVERWRITE(25);
  OVERWRITE(26);
  OVERWRITE(27);
  OVERWRITE(28);
  OVERWRITE(29);
  OVERWRITE(30);
  OVERWRITE(31);
#undef OVERWRITE
#endif
}

struct Escape {
  jmp_buf Buffer;
  volatile int Depth;
};

NOINLINE int descend(Escape &Way, int Depth, int Value) {
  int Local[4] = {Depth, Value, Depth * Value, 7};
  Way.Depth = Depth;
  if (Depth == 0) {
    overwriteSavedRegisters();
    longjmp(Way.Buffer, Value);
  }
  int Below = descend(Way, Depth - 1, Value);
  return Below + Local[Value & 3];
}

NOINLINE float opaque(int Seed, int Number) {
  volatile float Result = Seed * 0.5f + Number;
  return Result;
}

NOINLINE int opaqueInteger(int Seed, int Number) {
  volatile int Result = Seed * 1000 + Number;
  return Result;
}

// Many values that live across the call in saved registers.
NOINLINE unsigned tryAll(int Seed) {
  int A = Seed * 3, B = Seed * 5, C = Seed ^ 99, D = Seed + 1, E = Seed * Seed;
  auto Value = [&](int Number) { return opaque(Seed, Number); };
  float F0 = Value(0), F1 = Value(1), F2 = Value(2), F3 = Value(3),
        F4 = Value(4), F5 = Value(5), F6 = Value(6), F7 = Value(7),
        F8 = Value(8), F9 = Value(9), F10 = Value(10), F11 = Value(11);
  int I0 = opaqueInteger(Seed, 20), I1 = opaqueInteger(Seed, 21),
      I2 = opaqueInteger(Seed, 22), I3 = opaqueInteger(Seed, 23),
      I4 = opaqueInteger(Seed, 24), I5 = opaqueInteger(Seed, 25),
      I6 = opaqueInteger(Seed, 26), I7 = opaqueInteger(Seed, 27);
  volatile int Round = 0;
  volatile unsigned Sum = 0;
  Escape Way;
  int Status = setjmp(Way.Buffer);
  Sum = Sum * 31 + Status;
  Round = Round + 1;
  if (Round < 6)
    descend(Way, Round * 2, Round == 3 ? 0 : Round * 10);
  unsigned Result = Sum * 7 + A + B + C + D + E + Way.Depth;
  for (float F : {F0, F1, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11})
    Result = Result * 3 + static_cast<int>(F * 8);
  for (int I : {I0, I1, I2, I3, I4, I5, I6, I7})
    Result = Result * 3 + I;
  return Result;
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
