// __bf16 and _Float16: storage, conversions, arithmetic, arguments, vectors.
// RUN: %compare %s %t --native clang -Xclang -ffloat16-excess-precision=none -Xclang -fbfloat16-excess-precision=none
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#ifndef __tp__
// The host's libgcc may be too old to have them.
static float fromBits(uint32_t Bits) { float F; memcpy(&F, &Bits, 4); return F; }
static uint32_t toBits(float F) { uint32_t Bits; memcpy(&Bits, &F, 4); return Bits; }
__bf16 __truncsfbf2(float F) {
  uint32_t Bits = toBits(F);
  uint16_t High = (Bits + 0x7fff + (Bits >> 16 & 1)) >> 16;
  if (F != F)
    High = Bits >> 16 | 0x40;
  __bf16 Result;
  memcpy(&Result, &High, 2);
  return Result;
}
__bf16 __truncdfbf2(double D) {
  float F = (float)D;
  uint32_t Bits = toBits(F);
  // Rounded to odd, so that the second rounding is the only one.
  if ((double)F != D && !(Bits & 1))
    F = fromBits(__builtin_fabs((double)F) > __builtin_fabs(D) ? Bits - 1 : Bits + 1);
  return __truncsfbf2(F);
}
#endif

#define TEST(T)                                                                \
  static uint16_t bits_##T(T V) { uint16_t B; memcpy(&B, &V, 2); return B; }   \
  static T from_##T(uint16_t B) { T V; memcpy(&V, &B, 2); return V; }          \
  struct S_##T { char C; T A, B[3]; };                                         \
  __attribute__((noinline)) T sum_##T(int I, T A, T B, struct S_##T S) {       \
    return A + B * S.A - S.B[I];                                               \
  }                                                                            \
  __attribute__((noinline)) struct S_##T make_##T(T A) {                       \
    struct S_##T S = {1, A, {A + A, A * A, A - 1}};                            \
    return S;                                                                  \
  }                                                                            \
  static void test_##T(void) {                                                 \
    uint32_t Hash = 1;                                                         \
    for (uint32_t I = 0; I < 65536; I += 97)                                   \
      for (uint32_t J = 1; J < 65536; J += 7919) {                             \
        T A = from_##T(I), B = from_##T(J);                                    \
        T Results[] = {A + B, A - B, A * B, A / B, -A};                        \
        for (int K = 0; K < 5; ++K)                                            \
          if (Results[K] == Results[K])                                        \
            Hash = Hash * 31 + bits_##T(Results[K]);                           \
        Hash = Hash * 31 + (A < B) + 2 * (A == B) + 4 * (A >= B);              \
      }                                                                        \
    printf(#T " %08x\n", Hash);                                                \
    for (int I = -3; I < 4; ++I) {                                             \
      T A = (T)(I * 1.37f), B = (T)(I * 1234.567), C = (T)I;                   \
      printf("%a %a %a %d %u\n", (double)A, (double)B, (double)(float)C,       \
             (int)B, (unsigned)(C * C));                                       \
      struct S_##T S = make_##T(A);                                            \
      printf("%a\n", (double)sum_##T(I & 1, A, B, S));                         \
      A++;                                                                     \
      A += B;                                                                  \
      printf("%a %d\n", (double)A, A ? 1 : 0);                                 \
      printf("%a %a\n", (double)(T)(long long)(I * 100001LL),                  \
             (double)(T)(unsigned long long)(I & 3));                          \
      printf("%lld\n", (long long)(T)(I * 100));                               \
    }                                                                          \
  }
TEST(_Float16)
TEST(__bf16)

typedef _Float16 H4 __attribute__((ext_vector_type(4)));
__attribute__((noinline)) H4 scale(H4 V, _Float16 F) { return V * F + V; }

int main(void) {
  test__Float16();
  test___bf16();
  H4 V = {1, 2.5, -3, 0.1};
  V = scale(V, 1.5);
  printf("%a %a %a %a\n", (double)V.x, (double)V.y, (double)V.z, (double)V.w);
  __bf16 Local[5] = {1, 2, 3};
  float Total = 0;
  for (int I = 0; I < 5; ++I)
    Total += (float)Local[I];
  printf("%g\n", Total);
}
