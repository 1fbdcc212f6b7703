// Integers of all widths, float and double arithmetic and conversions.
// RUN: %compare %s %t
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint64_t Hash = 1;
static void add(uint64_t V) { Hash = (Hash ^ V) * 1099511628211u; }
static void addDouble(double D) {
  uint64_t Bits;
  memcpy(&Bits, &D, 8);
  add(D == D ? Bits : 1);
}
static const uint64_t Values[] = {0, 1, 2, 3, 7, 10, 0x7f, 0x80, 0xff, 0x7fff, 0x8000,
    0xffff, 0x7fffffff, 0x80000000, 0xffffffff, 0x100000000, 0x7fffffffffffffff,
    0x8000000000000000, -1, -7, 0x123456789abcdef0, 1000000007};
enum { N = sizeof Values / sizeof *Values };
static const double Reals[] = {0.0, -0.0, 1, -1, 0.5, 1.5, 2.5, -2.5, 1e-310, 5e-324,
    1e308, 3.14159265358979, -123456.789, 4294967295.0, 1e18, -1e18, 1e-40, 1e38, 0.1,
    1.0 / 0.0, -1.0 / 0.0, 0.0 / 0.0};
enum { M = sizeof Reals / sizeof *Reals };

#define ARITHMETIC(T, S, BITS)                                                 \
  __attribute__((noinline)) static void test##T(T A, T B) {                    \
    add((T)(A + B)); add((T)(A - B)); add((T)(A * B)); add((T)~A); add((T)-A); \
    if (B) { add((T)(A / B)); add((T)(A % B)); }                               \
    if (B && (S)B != -1) { add((T)((S)A / (S)B)); add((T)((S)A % (S)B)); }     \
    add((T)(A << (B & (BITS - 1)))); add((T)(A >> (B & (BITS - 1))));          \
    add((T)((S)A >> (B & (BITS - 1)))); add(A & B); add(A | B); add(A ^ B);    \
    add((A < B) | (A <= B) << 1 | ((S)A < (S)B) << 2 | ((S)A >= (S)B) << 3 |   \
        (A == B) << 4 | (A && B) << 5 | (!A) << 6);                            \
    add((T)(A / 10)); add((T)(A % 10)); add((T)((S)A / 7)); add((T)((S)A % 16));\
    add((T)(A * 100)); add((T)((S)A / -8)); add(A > B ? A : B);                \
    add((S)A < (S)B ? A : B); add((T)((S)A < 0 ? -A : A));                     \
    addDouble((double)A); addDouble((double)(S)A); addDouble((float)A);        \
    addDouble((float)(S)A);                                                    \
    add((T)(A << 3 | A >> (BITS - 3))); add((T)((A & 0xff) << 4 | B >> 1));    \
  }
ARITHMETIC(uint8_t, int8_t, 8)
ARITHMETIC(uint16_t, int16_t, 16)
ARITHMETIC(uint32_t, int32_t, 32)
ARITHMETIC(uint64_t, int64_t, 64)

#define FLOATS(T)                                                              \
  __attribute__((noinline)) static void test##T(T A, T B) {                    \
    addDouble(A + B); addDouble(A - B); addDouble(A * B); addDouble(A / B);    \
    addDouble(A == A ? -A : 1);                                                \
    add((A < B) | (A <= B) << 1 | (A > B) << 2 | (A >= B) << 3 |               \
        (A == B) << 4 | (A != B) << 5 | (!A) << 6 | !(A < B) << 7);            \
    addDouble((float)A); addDouble((double)B);                                 \
    if (A > -2e9 && A < 2e9) { add((int32_t)A); add((int8_t)(int)A);           \
      add((int64_t)A * 3); }                                                   \
    if (A > -1 && A < 4e9) { add((uint32_t)A); add((uint64_t)A); }             \
    if (A > -9e18 && A < 9e18) add((int64_t)A);                                \
    if (A > -1 && A < 1.8e19) add((uint64_t)A);                                \
    addDouble(A < B ? A : B); addDouble(A * A + B); addDouble(A * (T)0.1);     \
  }
FLOATS(float)
FLOATS(double)

int main(void) {
  for (int I = 0; I < N; ++I)
    for (int J = 0; J < N; ++J) {
      testuint8_t(Values[I], Values[J]);
      testuint16_t(Values[I], Values[J]);
      testuint32_t(Values[I], Values[J]);
      testuint64_t(Values[I], Values[J]);
    }
  printf("%016llx\n", (unsigned long long)Hash);
  for (int I = 0; I < M; ++I)
    for (int J = 0; J < M; ++J) {
      testfloat(Reals[I], Reals[J]);
      testdouble(Reals[I], Reals[J]);
    }
  printf("%016llx\n", (unsigned long long)Hash);
  double D = 0;
  for (int I = 1; I < 1000; ++I)
    D += 1.0 / I;
  printf("%.17g %a\n", D, (double)(float)D);
}
