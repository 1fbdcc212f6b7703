// __int128: arithmetic, comparisons, conversions, arguments and results.
// RUN: %compare %s %t
#include <stdint.h>
#include <stdio.h>

typedef __int128 S;
typedef unsigned __int128 U;

static void show(const char *Name, U V) {
  printf("%s %016llx%016llx\n", Name, (unsigned long long)(V >> 64),
         (unsigned long long)V);
}

__attribute__((noinline)) S mix(int A, S B, float C, U D, char E, S F) {
  return A + B * 3 + (S)C + (S)(D >> 3) - E + F;
}
__attribute__((noinline)) U many(U A, U B, U C, U D) { return A ^ B + C - D; }

struct Pair { char C; S V; };
__attribute__((noinline)) struct Pair swap(struct Pair P) {
  struct Pair R = {(char)P.V, P.V * P.C};
  return R;
}

static const U Values[] = {
    0, 1, 2, 3, 10, (U)-1, (U)-2, (U)-10, (U)1 << 63, (U)1 << 64, (U)1 << 127,
    ((U)1 << 127) - 1, ((U)0x123456789abcdef0 << 64) | 0xfedcba9876543210,
    ((U)0xffffffff << 32), (U)0xdeadbeef * 0x1000000001, (U)1000000007 << 70};
enum { N = sizeof Values / sizeof *Values };

int main(void) {
  U Sum = 0;
  for (int I = 0; I < N; ++I)
    for (int J = 0; J < N; ++J) {
      volatile U VA = Values[I], VB = Values[J];
      U A = VA, B = VB;
      Sum = Sum * 31 + (A + B);
      Sum = Sum * 31 + (A - B);
      Sum = Sum * 31 + (A * B);
      if (B) {
        Sum = Sum * 31 + (A / B);
        Sum = Sum * 31 + (A % B);
        if (!(A == (U)1 << 127 && B == (U)-1)) {
          Sum = Sum * 31 + (U)((S)A / (S)B);
          Sum = Sum * 31 + (U)((S)A % (S)B);
        }
      }
      Sum = Sum * 31 + (A << (B & 127));
      Sum = Sum * 31 + (A >> (B & 127));
      Sum = Sum * 31 + (U)((S)A >> (B & 127));
      Sum = Sum * 31 + ((A & B) ^ (A | ~B));
      Sum = Sum * 31 + (A < B) + 2 * (A <= B) + 4 * ((S)A < (S)B) +
            8 * ((S)A >= (S)B) + 16 * (A == B);
      U R;
      Sum = Sum * 31 + __builtin_add_overflow(A, B, &R);
      Sum = Sum * 31 + __builtin_mul_overflow(A, B, &R) + R;
      S T;
      Sum = Sum * 31 + __builtin_mul_overflow((S)A, (S)B, &T) + (U)T;
      Sum = Sum * 31 + __builtin_sub_overflow((S)A, (S)B, &T) + (U)T;
    }
  show("sum", Sum);
  for (int I = 0; I < N; ++I) {
    volatile U V = Values[I];
    U A = V;
    show("value", A);
    show("div10", A / 10);
    show("mod1000000007", A % 1000000007);
    show("sdiv7", (U)((S)A / 7));
    printf("%a %a %a %a\n", (double)A, (double)(S)A, (double)(float)A,
           (double)(float)(S)A);
    double D = (double)(S)A * 0.37;
    if (D > -1e38 && D < 1e38)
      show("from double", (U)(S)D);
    float F = (float)(A >> 2);
    show("from float", (U)F);
    printf("%d %d %d\n", __builtin_popcountll(A) , (int)(A >> 100),
           (signed char)A);
  }
  show("mix", (U)mix(-7, Values[12], 3.75f, Values[13], 'x', -Values[5]));
  show("many", many(Values[1], Values[12], Values[14], Values[15]));
  struct Pair P = {-3, Values[12]};
  P = swap(P);
  show("pair", P.V + P.C);
  S I = -5;
  I++;
  I <<= 70;
  show("shifted", I);
  switch ((U)I >> 64) {
  case (U)0xffffffffffffff00: puts("case"); break;
  default: puts("default");
  }
}
