// Attributes of functions and variables: aliases, weak symbols, sections,
// constructors with priorities, cleanup, and hints.
// RUN: %compare %s %t
#include <stdint.h>
#include <stdio.h>

static int Order;
__attribute__((constructor(200))) static void second(void) { Order = Order * 10 + 2; }
__attribute__((constructor(101))) static void first(void) { Order = Order * 10 + 1; }
__attribute__((constructor)) static void third(void) { Order = Order * 10 + 3; }
__attribute__((destructor)) static void last(void) { printf("destructor %d\n", Order); }

int original(int V) { return V * 3; }
int alias(int V) __attribute__((alias("original")));
static int hidden(int V) __attribute__((alias("original"), unused));
extern int renamed(int V) __asm__("other_name");
__attribute__((used)) int other_name(int V) { return V + 1000; }
int Variable = 17;
extern int SameVariable __attribute__((alias("Variable")));
__attribute__((weak)) int weak(int V) { return V - 1; }
extern int missing(int) __attribute__((weak));
extern int Absent __attribute__((weak));
static int target(int V) { return V ^ 0xff; }
static int reference(int) __attribute__((weakref("target")));

__attribute__((section("numbers"), used)) static int N1 = 1;
__attribute__((section("numbers"), used)) static int N2 = 20;
__attribute__((section("numbers"), used)) static int N3 = 300;
extern int Start __asm__("__start_numbers"), Stop __asm__("__stop_numbers");
__attribute__((section(".text.special"), noinline)) int special(int V) { return V * 7; }
__attribute__((section("zeros"))) static int Zero[4];

static void cleaned(int *V) { printf("cleanup %d\n", *V); }
__attribute__((noinline)) int cleanup(int V) {
  __attribute__((cleanup(cleaned))) int A = V;
  for (int I = 0; I < 2; ++I) {
    __attribute__((cleanup(cleaned))) int B = I + 10;
    if (V > 5)
      return A + B;
  }
  return A;
}
__attribute__((always_inline)) static inline int inlined(int V) { return V * V; }
__attribute__((flatten)) int flat(int V) { return inlined(V) + original(V); }
__attribute__((noinline, cold)) int cold(int V) { return V - 3; }
__attribute__((hot, pure)) int hot(const int *P) { return *P + 5; }
__attribute__((const, noinline)) int pureConst(int V) { return V << 3; }
__attribute__((malloc, returns_nonnull, noinline)) void *memory(void) {
  static int Storage[4];
  return Storage;
}
__attribute__((noreturn, noinline)) void stop(void);
__attribute__((nonnull(1), noinline)) int nonnull(int *P) { return P ? *P : -1; }
__attribute__((optnone, noinline)) int unoptimized(int V) {
  int Sum = 0;
  for (int I = 0; I < V; ++I) Sum += I;
  return Sum;
}
__attribute__((minsize, noinline)) int small(int V) { return V * 100 / 7 % 13; }
typedef int Int4 __attribute__((mode(SI)));
typedef int Int8 __attribute__((mode(DI)));
typedef int Loose __attribute__((aligned(1)));
typedef int May __attribute__((may_alias));
__attribute__((noinline)) int punned(float *F) { return *(May *)F; }
__attribute__((naked)) int nakedFunction(int V);
#ifdef __tp__
int nakedFunction(int V) { __asm__("addi r4, r4, 5\n\tjr ra"); }
#else
int plain(int V) { return V + 5; }
int nakedFunction(int V) { __asm__("jmp plain"); }
#endif
_Thread_local int PerThread = 4;
__attribute__((aligned(256))) static char Aligned;
__attribute__((visibility("hidden"))) int Hidden = 2;
__attribute__((common)) int Common;

int main(void) {
  printf("%d %d %d %d\n", Order, alias(5), renamed(1), SameVariable);
  SameVariable = 18;
  printf("%d %d %d %d %d\n", Variable, weak(3), missing == 0, &Absent == 0, reference(1));
  int Sum = 0;
  for (int *P = &Start; P != &Stop; ++P)
    Sum += *P;
  printf("%d %d %d\n", Sum, special(6), Zero[3]);
  printf("%d\n", cleanup(3));
  printf("%d\n", cleanup(7));
  printf("%d %d %d %d\n", flat(4), cold(1), hot(&Variable), pureConst(5));
  *(int *)memory() = 6;
  printf("%d %d %d %d\n", *(int *)memory(), nonnull(&Variable), unoptimized(10), small(55));
  float F = 1.0f;
  printf("%x %d %d %d\n", punned(&F), (int)sizeof(Int8), (int)sizeof(Int4), nakedFunction(1));
  char Bytes[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  printf("%x %d\n", *(Loose *)(Bytes + 1), ++PerThread);
  printf("%d %d %d\n", (int)((uintptr_t)&Aligned & 255), Hidden, Common);
}
