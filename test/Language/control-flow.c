// Switches, loops, goto, computed goto, recursion, tail calls, function
// pointers.
// RUN: %compare %s %t
#include <stdint.h>
#include <stdio.h>

enum Code { Push, Add, Mul, Dup, Loop, Swap, End };
static int run(const signed char *Code, int Count) {
  static const void *const Labels[] = {&&push, &&add, &&mul, &&dup,
                                       &&loop, &&swap, &&end};
  static const int Offsets[] = {&&push - &&end, &&add - &&end};
  int Stack[16], *Top = Stack;
  const signed char *Start = Code;
  if (Offsets[0] == Offsets[1])
    return -1;
#define NEXT goto *Labels[(int)*Code++]
  NEXT;
push: *Top++ = *Code++; NEXT;
add: --Top; Top[-1] += Top[0]; NEXT;
mul: --Top; Top[-1] *= Top[0]; NEXT;
dup: *Top = Top[-1]; ++Top; NEXT;
swap: { int T = Top[-1]; Top[-1] = Top[-2]; Top[-2] = T; } NEXT;
loop: if (--Count > 0) Code = Start + 2; NEXT;
end: return Top[-1];
}
__attribute__((noinline)) int dense(int V) {
  switch (V) {
  case 0: return 17; case 1: return 4; case 2: return 99; case 3: return -7;
  case 4: V *= 3; // fall through
  case 5: V += 2; break;
  case 6 ... 9: return V * V;
  case 10: for (;; ++V) { if (V % 7 == 0) goto out; }
  default: return -1;
  }
  return V;
out:
  return V * 100;
}
__attribute__((noinline)) int table(unsigned V, int X) {
#define C(N) case N: return X * (N * 37 % 11) + N * N;
#define C8(N) C(N) C(N + 1) C(N + 2) C(N + 3) C(N + 4) C(N + 5) C(N + 6) C(N + 7)
  switch (V) {
    C8(0) C8(8) C8(16) C8(24) C8(32) C8(40) C8(48) C8(56) C8(64) C8(72) C8(80)
  }
  return -V;
}
__attribute__((noinline)) const char *sparse(int64_t V) {
  switch (V) {
  case -5000000000: return "a"; case 3: return "b"; case 1ll << 40: return "c";
  case 0x7fffffffffffffff: return "d"; case 1000000: return "e"; case 70: return "f";
  default: return "-";
  }
}
static int even(unsigned N);
static int odd(unsigned N) { return N == 0 ? 0 : even(N - 1); }
static int even(unsigned N) { return N == 0 ? 1 : odd(N - 1); }
static int ackermann(int M, int N) {
  return M == 0 ? N + 1 : ackermann(M - 1, N == 0 ? 1 : ackermann(M, N - 1));
}
typedef double (*Function)(double, int);
static double power(double X, int N) { return N ? X * power(X, N - 1) : 1; }
static double times(double X, int N) { return X * N; }
static Function choose(int N) { return N & 1 ? power : times; }
static void hanoi(int N, int A, int B, int C, int *Moves) {
  if (N == 0) return;
  hanoi(N - 1, A, C, B, Moves);
  *Moves += A * 100 + B;
  hanoi(N - 1, C, B, A, Moves);
}

int main(void) {
  static const signed char Program[] = {Push, 3, Dup, Mul, Push, -2, Swap, Add,
                                        Loop, End};
  printf("%d %d\n", run(Program, 1), run(Program, 4));
  int Sum = 0;
  for (int I = -2; I < 13; ++I)
    Sum = Sum * 3 + dense(I);
  for (unsigned I = 0; I < 100; ++I)
    Sum = Sum * 3 + table(I, I + 1);
  printf("%d\n", Sum);
  int64_t Values[] = {-5000000000, 3, 1ll << 40, 0x7fffffffffffffff, 1000000, 70,
                      705032704, 0};
  for (int I = 0; I < 8; ++I)
    printf("%s", sparse(Values[I]));
  printf("\n%d %d %d\n", even(1000), odd(77), ackermann(2, 9));
  printf("%g %g\n", choose(1)(1.5, 5), choose(2)(1.5, 5));
  int Moves = 0;
  hanoi(10, 1, 2, 3, &Moves);
  printf("%d\n", Moves);
  // Duff's device.
  char To[20] = {0};
  const char *From = "duff's device works";
  int Count = 19, Rounds = (Count + 7) / 8;
  char *T = To;
  switch (Count % 8) {
  case 0: do { *T++ = *From++;
  case 7: *T++ = *From++;
  case 6: *T++ = *From++;
  case 5: *T++ = *From++;
  case 4: *T++ = *From++;
  case 3: *T++ = *From++;
  case 2: *T++ = *From++;
  case 1: *T++ = *From++;
          } while (--Rounds > 0);
  }
  puts(To);
  int I = 0;
again:
  if (I < 100) { I += I / 2 + 1; goto again; }
  do { if (I & 1) continue; --I; } while (I-- > 50);
  printf("%d\n", I);
}
