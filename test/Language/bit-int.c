// _BitInt of many widths, to thousands of bits.
// RUN: %compare %s %t --native clang -std=c2x
#include <stdint.h>
#include <stdio.h>

static uint32_t Hash = 1;
static void add(uint32_t V) { Hash = (Hash ^ V) * 16777619u; }
static uint32_t Seed = 12345;
static uint32_t next(void) { return Seed = Seed * 1664525 + 1013904223; }

#define WIDTH(N)                                                               \
  typedef unsigned _BitInt(N) U##N;                                            \
  typedef _BitInt(N) S##N;                                                     \
  static void hash##N(U##N V) {                                                \
    for (int I = 0; I < N; I += 24)                                            \
      add((uint32_t)(V >> I) & 0xffffff);                                      \
  }                                                                            \
  __attribute__((noinline)) static U##N random##N(void) {                      \
    U##N V = 0;                                                                \
    for (int I = 0; I < N; I += 24)                                            \
      V |= (U##N)((U##N)(next() >> 8) << I);                                   \
    return V >> (next() >> 8) % N;                                             \
  }                                                                            \
  __attribute__((noinline)) static S##N negate##N(int A, S##N B, char C) {     \
    return (S##N)(-B + A - C);                                                 \
  }                                                                            \
  struct Holder##N { char C; S##N V; char D; };                                \
  __attribute__((noinline)) static struct Holder##N hold##N(struct Holder##N H)\
  { H.V = (S##N)(H.V + H.C); H.D ^= H.C; return H; }                           \
  static void test##N(void) {                                                  \
    for (int I = 0; I < 8; ++I) {                                              \
      U##N A = random##N(), B = random##N();                                   \
      hash##N(A + B); hash##N(A - B); hash##N(A * B);                          \
      if (B != 0) { hash##N(A / B); hash##N(A % B); }                          \
      S##N X = (S##N)A, Y = (S##N)B;                                           \
      if (Y != 0 && Y != -1) { hash##N((U##N)(X / Y)); hash##N((U##N)(X % Y)); }\
      unsigned Shift = (next() >> 8) % N;                                      \
      hash##N(A << Shift); hash##N(A >> Shift); hash##N((U##N)(X >> Shift));   \
      hash##N(A & B); hash##N(A | B); hash##N(A ^ B); hash##N(~A);             \
      add((A < B) | (X < Y) << 1 | (A == B) << 2 | (X >= Y) << 3);             \
      if (N <= 128) {                                                          \
        double D = (double)X;                                                  \
        add((uint32_t)(D == D) + (D < 0));                                     \
        hash##N((U##N)(S##N)(D / 4));                                          \
      }                                                                        \
      hash##N((U##N)negate##N(Shift & 1, X, A & 1));                           \
      struct Holder##N H = {1, X, 3};                                          \
      H = hold##N(H);                                                          \
      hash##N((U##N)H.V); add(H.D);                                            \
      X++; hash##N((U##N)X); X <<= 1; hash##N((U##N)X);                        \
    }                                                                          \
    printf("%d bits: %08x\n", N, Hash);                                        \
  }
#define WIDTHS(X) X(3) X(17) X(33) X(65) X(128) X(150)
WIDTHS(WIDTH)

static unsigned _BitInt(1001) Factorial = 1;

int main(void) {
#define CALL(N) test##N();
  WIDTHS(CALL)
  for (int I = 2; I <= 300; ++I)
    Factorial *= I;
  for (int I = 0; I < 1001; I += 32)
    add((uint32_t)(Factorial >> I));
  printf("300! modulo 2^1001: %08x\n", Hash);
  unsigned _BitInt(1) Bit = 1;
  Bit++;
  printf("%d\n", (int)Bit);
  _BitInt(24) Sum = 0;
  for (_BitInt(24) I = 1; I < 3000; ++I)
    Sum += I;
  printf("%d %d\n", (int)Sum, (int)(8388607wb + 0wb));
}
