// 64-bit arithmetic on the chip against the host's.
// RUN: %host_cc -w -O1 %s -o %t.host && %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <stdint.h>
#include <stdio.h>

static const uint64_t Values[] = {
    0,          1,           2,          3,
    10,         0x7fffffff,  0x80000000, 0xffffffff,
    1ull << 32, 0x123456789, 1ull << 62, 0x7fffffffffffffff,
    1ull << 63, ~0ull - 1,   ~0ull,      0xfedcba9876543210,
};

int main(void) {
  const int Count = sizeof(Values) / sizeof(Values[0]);
  for (int I = 0; I < Count; ++I) {
    volatile uint64_t A = Values[I];
    volatile int64_t SA = (int64_t)A;
    for (int J = 0; J < Count; ++J) {
      volatile uint64_t B = Values[J];
      volatile int64_t SB = (int64_t)B;
      printf("%llx %llx: %llx %llx %llx %d%d%d%d", (unsigned long long)A,
             (unsigned long long)B, (unsigned long long)(A + B),
             (unsigned long long)(A - B), (unsigned long long)(A * B), A < B,
             SA < SB, A == B, SA >= SB);
      if (B != 0)
        printf(" %llx %llx", (unsigned long long)(A / B),
               (unsigned long long)(A % B));
      if (B != 0 && !(SB == -1 && A == 1ull << 63))
        printf(" %lld %lld", (long long)(SA / SB), (long long)(SA % SB));
      printf("\n");
    }
    for (int Shift = 0; Shift < 64; Shift += 9)
      printf("%llx %llx %llx\n", (unsigned long long)(A << Shift),
             (unsigned long long)(A >> Shift),
             (unsigned long long)(SA >> Shift));
    printf("%d %llx\n", __builtin_popcountll(A),
           (unsigned long long)__builtin_bswap64(A));
    if (A != 0)
      printf("%d %d\n", __builtin_clzll(A), __builtin_ctzll(A));
  }
  return 0;
}
