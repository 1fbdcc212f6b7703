// -ffp-model=strict is compiled, of any type, and gives the same numbers: the
// chip has neither exception flags nor other roundings.
//
// RUN: tpcc -O1 -S -emit-llvm -ffp-model=strict %s -o - | FileCheck --check-prefix=IR %s
// RUN: tpcc -O0 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.expected
// RUN: FileCheck %s < %t.expected
// RUN: tpcc -O0 -ffp-model=strict %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf | diff %t.expected -
// RUN: tpcc -O2 -mfma -ffp-model=strict %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf | diff %t.expected -

#include <math.h>
#include <stdio.h>

#define ARITHMETIC(Type, Name)                                                 \
  void Name(volatile Type *P) {                                                \
    Type A = P[0], B = P[1];                                                   \
    printf("%g %g %g %g %g\n", (double)(A + B), (double)(A - B),               \
           (double)(A * B), (double)(A / B), (double)-A);                      \
    printf("%d %u %lld %d %d %d\n", (int)A, (unsigned)B, (long long)A, A < B,  \
           A == B, A != A);                                                    \
    printf("%g %g %g\n", (double)(float)A, (double)(_Float16)A,                \
           (double)(Type)(int)B);                                              \
  }

// IR: @half
// IR: call half @llvm.experimental.constrained.fptrunc
// IR: @single
// IR: call float @llvm.experimental.constrained.fadd.f32
ARITHMETIC(_Float16, half)
ARITHMETIC(float, single)
ARITHMETIC(double, twice)

volatile _Float16 Halves[] = {2.5f16, 3.25f16};
volatile float Floats[] = {-2.5f, 3.25f};
volatile double Doubles[] = {1e10, 3.25};

int main(void) {
  // CHECK: 5.75 -0.75 8.125 0.769043 -2.5
  half(Halves);
  // CHECK: 0.75 -5.75 -8.125 -0.769231 2.5
  single(Floats);
  // CHECK: 1e+10 1e+10 3.25e+10 3.07692e+09 -1e+10
  twice(Doubles);
  printf("%g %g %g\n", (double)sqrtf(Floats[1]), floor(Doubles[1]),
         (double)fmaf(Floats[0], Floats[1], Floats[1]));
  return 0;
}
