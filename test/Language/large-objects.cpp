// Frames, arguments and results of more than the 32 KiB that an offset reaches.
// RUN: %compare %s %t
#include <cstdio>

struct Large { char C[100000]; };
static Large Global;

__attribute__((noinline)) Large change(Large L, int I) {
  L.C[I] = L.C[I + 1] + 1;
  return L;
}
__attribute__((noinline)) int dynamic(int N) {
  char *First = (char *)__builtin_alloca(50000 + N);
  char *Second = (char *)__builtin_alloca(0);
  First[49999] = 3;
  return First[49999] + (Second != nullptr);
}
__attribute__((noinline)) int many(int N) {
  volatile int A[20000], B[20000];
  for (int I = 0; I < 20000; I += 1999)
    A[I] = I * N, B[19999 - I] = I + N;
  return A[1999 * 5] + B[19999 - 1999 * 7];
}

int main() {
  Global.C[99999] = 5;
  Large L = change(Global, 99998);
  L = change(L, 99997);
  std::printf("%d %d %d\n", L.C[99997], dynamic(1), many(3));
}
