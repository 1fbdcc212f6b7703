// Vector extensions of odd element types and sizes: arithmetic, comparisons,
// selections, shuffles, conversions, subscripts, arguments and results.
// RUN: %compare %s %t --native clang
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint32_t Hash = 1;
static void add(const void *P, unsigned N) {
  for (unsigned I = 0; I < N; ++I)
    Hash = (Hash ^ ((const uint8_t *)P)[I]) * 16777619u;
}
static uint32_t Seed = 1;
static uint32_t next(void) { return (Seed = Seed * 1664525 + 1013904223) >> 8; }

#define INTEGERS(NAME, T, MASK, N)                                             \
  typedef T NAME __attribute__((ext_vector_type(N)));                          \
  typedef MASK NAME##Mask __attribute__((ext_vector_type(N)));                 \
  struct Holder##NAME { char C; NAME V; };                                     \
  __attribute__((noinline)) NAME call##NAME(int A, NAME V, float F, NAME W,    \
                                            struct Holder##NAME H) {           \
    return V * (T)A + W * (T)F - H.V;                                          \
  }                                                                            \
  static void hash##NAME(NAME V) {                                             \
    for (int I = 0; I < N; ++I) { T E = V[I]; add(&E, sizeof E); }             \
  }                                                                            \
  static void test##NAME(void) {                                               \
    NAME A, B;                                                                 \
    for (int I = 0; I < N; ++I) { A[I] = (T)next(); B[I] = (T)(next() | 1); }  \
    hash##NAME(A + B); hash##NAME(A - B); hash##NAME(A * B);                   \
    hash##NAME(A / B); hash##NAME(A % B); hash##NAME(-A); hash##NAME(~A);      \
    hash##NAME((A & B) ^ (A | B)); hash##NAME(A << (B & (T)7));                \
    hash##NAME(A >> (B & (T)7));                                               \
    NAME##Mask M = A < B;                                                      \
    hash##NAME((NAME)(M & (A == B)) | (NAME)(A >= B));                         \
    hash##NAME(M ? A : B);                                                     \
    struct Holder##NAME H = {1, B};                                            \
    hash##NAME(call##NAME(3, A, 2.0f, B, H));                                  \
    hash##NAME(__builtin_shufflevector(A, B, SHUFFLE##N));                     \
    hash##NAME(__builtin_elementwise_max(A, B));                               \
    T Sum = __builtin_reduce_xor(A); add(&Sum, sizeof Sum);                    \
    A[next() % N] = 5; hash##NAME(A);                                          \
    A += 3; A *= B; hash##NAME(A);                                             \
    printf(#NAME " %08x\n", Hash);                                             \
  }
#define SHUFFLE2 3, 0
#define SHUFFLE3 2, 4, 0
#define SHUFFLE4 7, 0, 5, 1
#define SHUFFLE5 9, 0, 4, 6, 1
#define SHUFFLE8 1, 15, 2, 14, 0, 0, 7, 8
#define SHUFFLE16 1, 31, 2, 14, 0, 0, 7, 8, 9, 20, 21, 22, 4, 5, 6, 3
INTEGERS(char3, int8_t, char, 3)
INTEGERS(uchar16, uint8_t, char, 16)
INTEGERS(short5, int16_t, int16_t, 5)
INTEGERS(int2, int32_t, int32_t, 2)
INTEGERS(uint3, uint32_t, int32_t, 3)
INTEGERS(long2, int64_t, int64_t, 2)

typedef float float3 __attribute__((ext_vector_type(3)));
typedef float float4 __attribute__((ext_vector_type(4)));
typedef double double3 __attribute__((ext_vector_type(3)));
typedef _Float16 half3 __attribute__((ext_vector_type(3)));
typedef int int3 __attribute__((ext_vector_type(3)));
typedef int int4 __attribute__((ext_vector_type(4)));
typedef _Bool bool8 __attribute__((ext_vector_type(8)));
typedef _Bool bool5 __attribute__((ext_vector_type(5)));
typedef short gnu4 __attribute__((vector_size(8)));

__attribute__((noinline)) float3 cross(float3 A, float3 B) {
  return A.yzx * B.zxy - A.zxy * B.yzx;
}
__attribute__((noinline)) double3 widen(float3 A, half3 H) {
  return __builtin_convertvector(A, double3) * 2.0 +
         __builtin_convertvector(H, double3);
}
__attribute__((noinline)) bool8 flip(bool8 A, bool8 B, int I) {
  A[I] = !A[I];
  return (A & ~B) | (bool8)(A ^ B);
}
__attribute__((noinline)) float element(float4 V, int I) { return V[I]; }
__attribute__((noinline)) float4 put(float4 V, int I, float F) {
  V[I] = F;
  return V;
}
float4 Global[3] = {{1, 2, 3, 4}, {5, 6, 7, 8}};

int main(void) {
  testchar3(); testuchar16(); testshort5(); testint2(); testuint3(); testlong2();
  float3 F = cross((float3){1, 2, 3}, (float3){-2, 5, .5f});
  printf("%g %g %g %d\n", F.x, F.y, F.z, (int)sizeof F);
  half3 H = {1, -2.5, 0.1};
  double3 D = widen(F, H + H * H);
  printf("%g %g %g\n", D.x, D.y, D.z);
  int3 I = __builtin_convertvector(F * 10, int3);
  printf("%d %d %d\n", I.x, I.y, I.z);
  int3 M = F > 0 && F < 5;
  printf("%d %d %d\n", M.x, M.y, M.z);
  float3 S = M ? F : -F;
  S.zx = S.xz;
  S.xy += (__typeof__(S.xy)){10, 20};
  printf("%g %g %g\n", S.x, S.y, S.z);
  printf("%g %g\n", __builtin_reduce_add(I) / 2.0,
         (double)__builtin_elementwise_sqrt(__builtin_elementwise_abs(S)).y);
  bool8 X = {1, 0, 1, 1, 0, 0, 0, 1}, Y = {1, 1, 0, 0, 1, 1, 0, 1};
  X = flip(X, Y, 5);
  for (int K = 0; K < 8; ++K)
    putchar('0' + X[K]);
  putchar('\n');
  bool5 Z = {1, 0, 1, 1, 0};
  Z = ~Z;
  printf("%d%d%d%d%d\n", Z[0], Z[1], Z[2], Z[3], Z[4]);
  for (int K = 0; K < 4; ++K)
    Global[2] = put(Global[K & 1], K, element(Global[2], 3 - K) + K);
  printf("%g %g %g %g\n", Global[2].x, Global[2].y, Global[2].z, Global[2].w);
  gnu4 G = {1, -2, 3, -4};
  G = G * G + (gnu4){1, 1, 1, 1} * 3;
  printf("%d %d %d %d\n", G[0], G[1], G[2], G[3]);
  int4 Q = {1, 2, 3, 4};
  float4 R = __builtin_bit_cast(float4, Q << 23);
  printf("%a %a\n", R.x, R.w);
  int4 Masked = Q.wzyx & 3;
  printf("%d %d %d %d\n", Masked.x, Masked.y, Masked.z, Masked.w);
  float4 *Pointer = &Global[1];
  Pointer->w /= 3;
  printf("%a %d\n", Pointer->w, (int)((uintptr_t)Pointer & 15));
}
