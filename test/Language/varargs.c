// Variadic functions: every kind of argument, va_copy, lists passed on.
// RUN: %compare %s %t
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>

struct Small { char A[3]; };
struct Pair { int A, B; };
struct Big { double D; char C; int64_t L[3]; };
struct __attribute__((aligned(32))) Wide { int V; };
struct Empty {};
union Either { float F; int64_t L; };

static void list(const char *Format, va_list Arguments) {
  for (; *Format; ++Format)
    switch (*Format) {
    case 'i': printf("%d ", va_arg(Arguments, int)); break;
    case 'l': printf("%lld ", (long long)va_arg(Arguments, int64_t)); break;
    case 'd': printf("%g ", va_arg(Arguments, double)); break;
    case 'p': printf("%s ", va_arg(Arguments, const char *)); break;
    case 's': { struct Small S = va_arg(Arguments, struct Small);
                printf("{%d %d %d} ", S.A[0], S.A[1], S.A[2]); break; }
    case 'P': { struct Pair S = va_arg(Arguments, struct Pair);
                printf("{%d %d} ", S.A, S.B); break; }
    case 'B': { struct Big S = va_arg(Arguments, struct Big);
                printf("{%g %d %lld} ", S.D, S.C, (long long)S.L[2]); break; }
    case 'W': { struct Wide S = va_arg(Arguments, struct Wide);
                printf("{%d %d} ", S.V, (int)((uintptr_t)&S & 31)); break; }
    case 'e': va_arg(Arguments, struct Empty); printf("{} "); break;
    case 'u': printf("%lld ", (long long)va_arg(Arguments, union Either).L); break;
    case 'I': { __int128 V = va_arg(Arguments, __int128);
                printf("%llx:%llx ", (unsigned long long)(V >> 64),
                       (unsigned long long)V); break; }
    case 'f': printf("%d ", va_arg(Arguments, int (*)(int))(20)); break;
    }
  puts("");
}
__attribute__((noinline)) void show(const char *Format, ...) {
  va_list Arguments, Copy;
  va_start(Arguments, Format);
  va_copy(Copy, Arguments);
  list(Format, Arguments);
  va_end(Arguments);
  list(Format, Copy);
  va_end(Copy);
}
__attribute__((noinline)) double after(int A, int64_t B, float C, int D, int E,
                                       int F, int G, int H, int64_t I, double J,
                                       float K, int Count, ...) {
  va_list Arguments;
  va_start(Arguments, Count);
  double Sum = A + B + C + D + E + F + G + H + I + J + K;
  while (Count--)
    Sum = Sum * 2 + va_arg(Arguments, double) + va_arg(Arguments, int);
  va_end(Arguments);
  return Sum;
}
__attribute__((noinline)) struct Big result(struct Big B, ...) {
  va_list Arguments;
  va_start(Arguments, B);
  B.L[2] += va_arg(Arguments, int) * va_arg(Arguments, struct Big).L[1];
  va_end(Arguments);
  return B;
}
static void step(va_list *Arguments, int *Sum) { *Sum += va_arg(*Arguments, int); }
__attribute__((noinline)) int pointer(int Count, ...) {
  va_list Arguments;
  int Sum = 0;
  va_start(Arguments, Count);
  while (Count--)
    step(&Arguments, &Sum);
  va_end(Arguments);
  return Sum;
}
static int twice(int V) { return 2 * V; }

int main(void) {
  struct Small S = {{1, 2, 3}};
  struct Pair P = {4, 5};
  struct Big B = {1.5, 'x', {6, 7, 8}};
  struct Wide W = {9};
  union Either U = {.L = -10000000000};
  show("ii", 1, -2);
  show("ildp", 1, (int64_t)-20000000000, 3.25, "text");
  show("lili", (int64_t)1, 2, (int64_t)3, 4);
  show("didid", 1.5, 2, 2.5, 3, 3.5);
  show("sisPsB", S, 7, S, P, S, B);
  show("iWiWe", 1, W, 2, W, (struct Empty){});
  show("eiuId", (struct Empty){}, 3, U, ((__int128)5 << 64) + 6, 0.5);
  show("iIiI", 1, (__int128)-2, 3, (__int128)4);
  show("fBfi", twice, B, twice, 1);
  show("iiidiiididididid", 1, 2, 3, 4., 5, 6, 7, 8., 9, 10., 11, 12., 13, 14., 15, 16.);
  show("iii", 'c', (short)-3, (unsigned char)200);
  show("dd", 1.5f, (float)0.1f);
  printf("%g\n", after(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 3, .5, 1, .25, 2, 4., 3));
  B = result(B, 3, B);
  printf("%g %lld\n", B.D, (long long)B.L[2]);
  printf("%d %d\n", pointer(0), pointer(5, 1, 2, 3, 4, 5));
}
