// Software doubles on the chip against the host's, by their bits.
// RUN: %host_cc -w -O1 -ffp-contract=off %s -o %t.host -lm
// RUN: %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static const double Values[] = {0.0,
                                -0.0,
                                4.9e-324,
                                2.3e-308,
                                1e-310,
                                0.1,
                                0.5,
                                1.0,
                                -1.0,
                                1.5,
                                3.0,
                                -2.7,
                                1e10,
                                123456789.125,
                                4503599627370496.5,
                                9007199254740993.0,
                                -1e15,
                                1e300,
                                1.7976931348623157e308,
                                1.0 / 0.0,
                                -1.0 / 0.0,
                                0.0 / 0.0};

static unsigned long long bits(double Value) {
  uint64_t Bits;
  if (Value != Value)
    return 0x7ff8000000000000;
  memcpy(&Bits, &Value, sizeof(Bits));
  return Bits;
}

static unsigned floatBits(float Value) {
  uint32_t Bits;
  if (Value != Value)
    return 0x7fc00000;
  memcpy(&Bits, &Value, sizeof(Bits));
  return Bits;
}

int main(void) {
  const int Count = sizeof(Values) / sizeof(Values[0]);
  for (int I = 0; I < Count; ++I) {
    volatile double A = Values[I];
    for (int J = 0; J < Count; ++J) {
      volatile double B = Values[J];
      printf("%llx %llx: %llx %llx %llx %llx %d%d%d%d%d%d\n", bits(A), bits(B),
             bits(A + B), bits(A - B), bits(A * B), bits(A / B),
             A<B, A <= B, A> B, A >= B, A == B, A != B);
    }
    printf("%x %llx\n", floatBits((float)A), bits((double)(float)A));
    if (fabs(A) < 2e9)
      printf("%d %lld\n", (int)A, (long long)A);
    if (A >= 0 && A < 4e9)
      printf("%u %llu\n", (unsigned)A, (unsigned long long)A);
    printf("%llx %llx %llx %llx %llx\n", bits(sqrt(A)), bits(floor(A)),
           bits(ceil(A)), bits(fabs(A)), bits(fmod(A, 0.7)));
  }
  volatile int32_t S = -123456789;
  volatile uint32_t U = 4000000000u;
  volatile int64_t S64 = -1234567890123456789LL;
  volatile uint64_t U64 = 18446744073709551615ULL;
  printf("%llx %llx %llx %llx %x %x\n", bits(S), bits(U), bits((double)S64),
         bits((double)U64), floatBits((float)S64), floatBits((float)U64));
  return 0;
}
