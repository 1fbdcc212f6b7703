// Arrays of variable length, alloca, and both with more alignment than the
// stack has; also together with large frames and stack arguments.
// RUN: %compare %s %t
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

__attribute__((noinline)) int misaligned(const void *P, unsigned Alignment) {
  return (int)((uintptr_t)P & (Alignment - 1));
}
__attribute__((noinline)) int vla(int N, int M) {
  int A[N][M];
  for (int I = 0; I < N; ++I)
    for (int J = 0; J < M; ++J)
      A[I][J] = I * J + 1;
  int (*P)[M] = A;
  int Sum = (int)(sizeof A / sizeof A[0]) + (int)(sizeof *P / sizeof(int));
  for (int I = 0; I < N; ++I)
    Sum += P[I][M - 1 - I % M];
  return Sum;
}
__attribute__((noinline)) int parameters(int N, int A[N][2 * N]) { return A[1][N]; }
__attribute__((noinline)) int loop(int N) {
  int Sum = 0;
  for (int I = 1; I <= N; ++I) {
    char Text[I * 40];
    memset(Text, I, sizeof Text);
    Sum += Text[I * 40 - 1] + misaligned(Text, 4) * 0;
    if (I == 7) continue;
    if (I == 30) break;
  }
  return Sum;
}
struct Four { int V[4]; };
__attribute__((noinline)) int aligned(int N, int a, int b, int c, int d, int e,
                                      int f, int g, int On, struct Four S) {
  _Alignas(64) int Fixed[4] = {1, 2, 3, N};
  int Variable[N];
  char *Over = __builtin_alloca_with_align(N, 256 * 8);
  _Alignas(128) struct { char C; int V; } Local = {1, 2};
  memset(Variable, 1, sizeof Variable);
  memset(Over, 2, N);
  return misaligned(Fixed, 64) + misaligned(Over, 256) + misaligned(&Local, 128) +
         Variable[N - 1] + Over[N - 1] + Fixed[3] + On + S.V[3] + a + b + c + d +
         e + f + g + Local.V;
}
__attribute__((noinline)) int nested(int N) {
  char *P = __builtin_alloca(N * 3 + 1);
  memset(P, N, N * 3 + 1);
  int Below = N ? nested(N - 1) : 0;
  for (int I = 0; I <= N * 3; ++I)
    if (P[I] != N)
      return -1000;
  return Below + P[0];
}
__attribute__((noinline)) int large(int N) {
  volatile char Big[3000];
  int Variable[N];
  _Alignas(32) int Aligned[8];
  Big[0] = 1; Big[2999] = 2; Variable[N - 1] = 3; Aligned[7] = 4;
  return Big[0] + Big[2999] + Variable[N - 1] + Aligned[7] + misaligned(Aligned, 32);
}
__attribute__((noinline)) int variadic(int N, ...) {
  va_list Arguments;
  va_start(Arguments, N);
  _Alignas(64) double Values[N];
  for (int I = 0; I < N; ++I)
    Values[I] = va_arg(Arguments, double);
  va_end(Arguments);
  return (int)Values[N - 1] + misaligned(Values, 8);
}
__attribute__((noinline)) int leave(int N) {
  int Sum = 0;
again:;
  int A[N];
  A[N - 1] = N;
  Sum += A[N - 1];
  if (--N > 0)
    goto again;
  return Sum;
}

int main(void) {
  printf("%d %d\n", vla(3, 5), vla(7, 2));
  int Square[3][6];
  for (int I = 0; I < 18; ++I)
    Square[I / 6][I % 6] = I;
  printf("%d %d\n", parameters(3, Square), loop(40));
  struct Four S = {{0, 0, 0, 9}};
  printf("%d\n", aligned(10, 1, 2, 3, 4, 5, 6, 7, 8, S));
  printf("%d %d %d %d\n", nested(20), large(5), variadic(3, 1.5, 2.5, 3.5),
         leave(9));
}
