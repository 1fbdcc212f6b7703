// Packed and over-aligned structs, bit-fields and unions.
// RUN: %compare %s %t
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint32_t hash(const void *P, unsigned N) {
  uint32_t H = 2166136261u;
  for (unsigned I = 0; I < N; ++I)
    H = (H ^ ((const uint8_t *)P)[I]) * 16777619u;
  return H;
}

struct __attribute__((packed)) Packed {
  uint8_t A; uint32_t B; uint16_t C; int64_t D; float E; double F;
  struct { uint8_t G; uint32_t H; } __attribute__((packed)) I[3];
};
#pragma pack(push, 2)
struct Two { uint8_t A; uint32_t B; double C; };
#pragma pack(pop)
struct Partly { uint8_t A; uint32_t B __attribute__((packed)); uint16_t C; };
struct __attribute__((aligned(64))) Line { uint32_t A; uint8_t B; };
struct Raised { char A; _Alignas(16) int B; char C; };
struct Fields {
  uint32_t A : 3; int32_t B : 7; uint32_t : 0; uint32_t C : 31, D : 1;
  uint64_t E : 40; int64_t F : 23; uint8_t G : 5; _Bool H : 1;
};
struct __attribute__((packed)) PackedFields {
  uint32_t A : 13; uint64_t B : 51; int16_t C : 9; uint32_t D : 27; int8_t E : 4;
};
struct Straddle { uint8_t A; uint32_t B : 24; volatile uint16_t C : 12, D : 4; };
union Any {
  uint8_t B[12]; float F; double D; int64_t L; struct { uint16_t A, B, C; } S;
  struct { uint32_t Low : 12, High : 20; } T;
};
union Transparent { int *I; float *F; } __attribute__((transparent_union));

__attribute__((noinline)) int read(union Transparent T) { return *T.I; }
__attribute__((noinline)) struct Packed change(struct Packed P, struct Fields *F,
                                               struct PackedFields G) {
  P.B += F->C; P.C = F->E >> 20; P.D -= G.B; P.E *= 2; P.F += P.E;
  P.I[1].H = G.D; P.I[2].G = G.E;
  F->B -= 100; F->F = P.D; F->E *= 3; F->G++; F->H ^= 1; F->D = G.A; F->C <<= 3;
  return P;
}
__attribute__((noinline)) union Any other(union Any A, int I) {
  union Any R = A;
  R.B[I] = 255; R.S.C ^= A.T.Low; R.T.High += 77;
  return R;
}
__attribute__((noinline)) uint32_t increment(uint32_t *P) { return ++*P; }

int main(void) {
  printf("%zu %zu %zu %zu %zu %zu %zu %zu %zu\n", sizeof(struct Packed),
         sizeof(struct Two), sizeof(struct Partly), sizeof(struct Line),
         sizeof(struct Raised), sizeof(struct Fields),
         sizeof(struct PackedFields), sizeof(struct Straddle), sizeof(union Any));
  printf("%zu %zu %zu %zu %zu\n", offsetof(struct Packed, I),
         offsetof(struct Two, C), offsetof(struct Partly, C),
         offsetof(struct Raised, C), _Alignof(struct Raised));
  struct Packed P;
  memset(&P, 0, sizeof P);
  P.A = 1; P.B = 0x12345678; P.C = 0xabcd; P.D = -123456789012345; P.E = 1.5f;
  P.F = 2.25; P.I[0].H = 7; P.I[2].H = 0xfedcba98;
  struct Fields F;
  memset(&F, 0, sizeof F);
  F.A = 13; F.B = -60; F.C = 0x7654321; F.D = 1; F.E = 0x123456789a; F.F = -77777;
  F.G = 31; F.H = 1;
  struct PackedFields G;
  memset(&G, 0, sizeof G);
  G.A = 8000; G.B = 0x7123456789abc; G.C = -200; G.D = 0x5555555; G.E = -8;
  P = change(P, &F, G);
  printf("%08x %08x %08x\n", hash(&P, sizeof P), hash(&F, sizeof F),
         hash(&G, sizeof G));
  printf("%d %d %u %u %llx %lld %u %d\n", F.A, F.B, F.C, F.D,
         (unsigned long long)F.E, (long long)F.F, F.G, F.H);
  printf("%d %llx %d %d %d\n", G.A, (unsigned long long)G.B, G.C, G.D, G.E);
  printf("%d\n", F.B < -100 ? 1 : F.G + F.A);
  struct Two T[3];
  memset(T, 0, sizeof T);
  for (int I = 0; I < 3; ++I) {
    T[I].B = 0x01020304 * I; T[I].C = I / 3.0;
  }
  double *Inner = (void *)0;
  T[1].C += T[2].C * 2;
  printf("%08x\n", hash(T, sizeof T));
  struct Partly Q;
  memset(&Q, 0, sizeof Q);
  Q.B = 0xdeadbeef; Q.C = 3;
  Q.B = Q.B * 3 + Q.C;
  printf("%08x %d\n", hash(&Q, sizeof Q), Inner == 0);
  struct Line L[2] = {{1, 2}, {3, 4}};
  struct Raised R = {1, 2, 3};
  printf("%d %d %u\n", (int)((uintptr_t)L & 63), (int)((uintptr_t)&R & 15),
         increment(&L[1].A));
  struct Straddle S;
  memset(&S, 0, sizeof S);
  S.B = 0xffeedd; S.C = 0x123; S.D = 9; S.C += 0xf00; S.D--;
  printf("%08x %x %x %x\n", hash(&S, sizeof S), S.B, S.C, S.D);
  union Any A;
  memset(&A, 0, sizeof A);
  A.D = 3.14159;
  A = other(A, 9);
  printf("%08x %d %d\n", hash(&A, sizeof A), A.T.Low, A.T.High);
  int I = 42;
  printf("%d\n", read(&I));
  // Unaligned words in memory.
  uint8_t Bytes[32];
  for (int K = 0; K < 32; ++K)
    Bytes[K] = K * 11;
  uint64_t Sum = 0;
  for (int K = 0; K < 20; ++K) {
    struct __attribute__((packed)) { uint64_t V; } *W = (void *)(Bytes + K);
    struct __attribute__((packed)) { float V; } *X = (void *)(Bytes + K + 1);
    Sum += W->V;
    X->V += 1.0f;
  }
  printf("%llx %08x\n", (unsigned long long)Sum, hash(Bytes, 32));
}
