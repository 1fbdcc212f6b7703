// Clang's generic builtins.
// RUN: %compare %s %t --native clang
#include <float.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t Hash = 1;
static void add(uint64_t V) { Hash = (Hash ^ V) * 1099511628211u; }
static const uint64_t Values[] = {
    0, 1, 2, 5, 0x7f, 0x80, 0xff, 0x7fff, 0x8000, 0x7fffffff, 0x80000000,
    0xffffffff, 0x100000000, 0x7fffffffffffffff, 0x8000000000000000, -1,
    0x123456789abcdef0, 0x00ff00ff00ff00ff};
enum { N = sizeof Values / sizeof *Values };

#define OVERFLOW(T, A, B)                                                      \
  { T R;                                                                       \
    add(__builtin_add_overflow((T)A, (T)B, &R)); add(R);                       \
    add(__builtin_sub_overflow((T)A, (T)B, &R)); add(R);                       \
    add(__builtin_mul_overflow((T)A, (T)B, &R)); add(R); }

__attribute__((noinline)) static void bits(uint64_t A, uint64_t B) {
  uint32_t W = (uint32_t)A;
  uint16_t H = (uint16_t)A;
  uint8_t C = (uint8_t)A;
  add(__builtin_popcount(W)); add(__builtin_popcountll(A));
  add(__builtin_parity(W)); add(__builtin_parityll(A));
  add(__builtin_ffs(W)); add(__builtin_ffsll(A));
  if (W) { add(__builtin_clz(W)); add(__builtin_ctz(W)); }
  if (A) { add(__builtin_clzll(A)); add(__builtin_ctzll(A)); }
  add(__builtin_clzg(W, 99)); add(__builtin_ctzg(C, 77)); add(__builtin_clzg(A, -1));
  add(__builtin_popcountg(H)); add(__builtin_clrsb(W)); add(__builtin_clrsbll(A));
  add(__builtin_bswap16(H)); add(__builtin_bswap32(W)); add(__builtin_bswap64(A));
  add(__builtin_bitreverse8(C)); add(__builtin_bitreverse16(H));
  add(__builtin_bitreverse32(W)); add(__builtin_bitreverse64(A));
  add(__builtin_rotateleft8(C, B & 7)); add(__builtin_rotateright16(H, B & 15));
  add(__builtin_rotateleft32(W, B & 31)); add(__builtin_rotateright64(A, B & 63));
  OVERFLOW(int8_t, A, B) OVERFLOW(uint8_t, A, B) OVERFLOW(int16_t, A, B)
  OVERFLOW(int32_t, A, B) OVERFLOW(uint32_t, A, B) OVERFLOW(int64_t, A, B)
  OVERFLOW(uint64_t, A, B)
  int16_t Narrow;
  add(__builtin_mul_overflow((int64_t)A, (uint32_t)B, &Narrow)); add(Narrow);
  unsigned Carry;
  add(__builtin_addc(W, (unsigned)B, C & 1, &Carry)); add(Carry);
  unsigned long long Long;
  add(__builtin_subcll(A, B, C & 1, &Long)); add(Long);
  add(__builtin_elementwise_add_sat((int32_t)A, (int32_t)B));
  add(__builtin_elementwise_sub_sat((uint16_t)A, (uint16_t)B));
  add(__builtin_elementwise_add_sat((int64_t)A, (int64_t)B));
  add(__builtin_elementwise_abs((int32_t)(A & 0x7fffffff) - 5));
}
__attribute__((noinline)) static void floats(float F, double D) {
  add(__builtin_isnan(F)); add(!!__builtin_isinf(D)); add(__builtin_isfinite(F));
  add(__builtin_isnormal(D)); add(!!__builtin_signbit(F)); add(__builtin_isinf_sign(F));
  add(__builtin_fpclassify(0, 1, 2, 3, 4, F)); add(__builtin_fpclassify(0, 1, 2, 3, 4, D));
  add(__builtin_isunordered(F, D)); add(__builtin_isgreater(F, 0.5f));
  add(__builtin_islessgreater(D, 0.5)); add(__builtin_issubnormal(F));
  float G = __builtin_copysignf(3, F);
  uint32_t U; memcpy(&U, &G, 4); add(U);
  double E = __builtin_copysign(D, -1.0);
  if (E == E) { uint64_t V; memcpy(&V, &E, 8); add(V); }
  G = __builtin_elementwise_max(F, 1.0f);
  if (G == G) add((uint64_t)(G > 2)); 
  if (F == F && F < 1e9f && F > -1e9f) {
    add((int)__builtin_floorf(F)); add((int)__builtin_ceil(D)); add((int)__builtin_rint(D));
    add((int)__builtin_roundf(F)); add(__builtin_lrintf(F)); add((int)__builtin_truncf(F));
    add((int)__builtin_roundeven(D)); add(__builtin_lround(D));
  }
}
__attribute__((noinline)) static void *address(void) { return __builtin_return_address(0); }
__attribute__((noinline)) static void *frame(int *Local) {
  char *F = __builtin_frame_address(0);
  return (uintptr_t)Local - (uintptr_t)F + 4096 < 8192 ? F : 0;
}
static int constant(int V) { return __builtin_constant_p(V) ? V : -V; }
__attribute__((noinline)) static int assume(int V) {
  __builtin_assume(V > 0);
  if (__builtin_expect(V == 3, 0)) return 7;
  if (__builtin_expect_with_probability(V == 4, 1, 0.9)) return 8;
  if (V > 100) __builtin_unreachable();
  return __builtin_choose_expr(sizeof(V) == 4, V, "no");
}

int main(void) {
  for (int I = 0; I < N; ++I)
    for (int J = 0; J < N; ++J) {
      volatile uint64_t A = Values[I], B = Values[J];
      bits(A, B);
    }
  printf("%016llx\n", (unsigned long long)Hash);
  volatile float Floats[] = {0, -0.0f, 1, -2.5f, 0.5f, 1.5f, FLT_MIN, FLT_MIN / 8,
                             FLT_MAX, 1e8f, -__builtin_inff(), __builtin_nanf("")};
  for (int I = 0; I < 12; ++I)
    floats(Floats[I], Floats[I] * 1.25);
  printf("%016llx\n", (unsigned long long)Hash);
  int Local = 0;
  char Buffer[64], Other[64] = "source of the copy";
  printf("%d %d\n", address() != 0, frame(&Local) != 0);
  __builtin_memcpy(Buffer, Other, 64);
  __builtin_memmove(Buffer + 3, Buffer, 40);
  __builtin_memset(Buffer + 50, 'x', 3);
  __builtin_memcpy_inline(Buffer + 54, Other, 5);
  printf("%s %d %zu %zu\n", Buffer, __builtin_memcmp(Buffer, Other, 10) > 0,
         __builtin_strlen(Other), __builtin_object_size(Buffer, 0));
  __builtin_prefetch(Buffer, 0, 3);
  printf("%d %d %d\n", abs(constant(5)), assume(3), assume(50));
  int *Aligned = __builtin_assume_aligned(&Local, 4);
  *Aligned = 9;
  printf("%d %d\n", Local, __builtin_types_compatible_p(int, signed int));
  void *Saved = __builtin_alloca(10);
  uintptr_t Number = (uintptr_t)Saved;
  printf("%d %d %d\n", __builtin_align_up(Number, 32) - Number < 32,
         (int)(__builtin_align_down(Number, 64) & 63), __builtin_is_aligned(Number, 2));
  printf("%d %s %d\n", __builtin_LINE() > 0, __builtin_FUNCTION(),
         __builtin_offsetof(struct { char A; int B; }, B));
  uint64_t T = __builtin_readcyclecounter();
  printf("%d\n", __builtin_readcyclecounter() >= T);
  printf("%d\n", (int)__builtin_bit_cast(unsigned, 1.0f));
  volatile int Two = 2;
  printf("%u\n", __builtin_nondeterministic_value(Two) * 0 + 1);
  printf("%g %g\n", __builtin_powif(1.5f, 5), __builtin_powi(0.5, -Two));
  printf("%g\n", __builtin_elementwise_fma(1.5f, 2.0f, 0.25f));
  unsigned char Ignored = __builtin_flt_rounds();
  printf("%d\n", Ignored);
}
