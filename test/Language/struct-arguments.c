// Structs by value as arguments and results: every size to 40 bytes, several
// alignments, mixed with other arguments, through pointers and recursion.
// RUN: %compare %s %t
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint32_t Hash = 1;
static void add(uint32_t V) { Hash = (Hash ^ V) * 16777619u; }

#define SIZE(N)                                                                \
  struct B##N { uint8_t V[N]; };                                               \
  __attribute__((noinline)) struct B##N turn##N(int A, struct B##N S, float F, \
                                                struct B##N *P, struct B##N T){\
    struct B##N R;                                                             \
    for (int I = 0; I < N; ++I)                                                \
      R.V[I] = S.V[N - 1 - I] + T.V[I] * A + (int)F + P->V[I];                 \
    S.V[0] = 99;                                                               \
    return R;                                                                  \
  }                                                                            \
  static void test##N(void) {                                                  \
    struct B##N S, T;                                                          \
    for (int I = 0; I < N; ++I) { S.V[I] = I * 7 + N; T.V[I] = I ^ 5; }        \
    struct B##N (*volatile Pointer)(int, struct B##N, float, struct B##N *,    \
                                    struct B##N) = turn##N;                    \
    S = Pointer(3, S, 2.5f, &S, turn##N(1, T, 1.0f, &S, S));                   \
    for (int I = 0; I < N; ++I) add(S.V[I] + 256 * T.V[I]);                    \
    printf("%d: %08x\n", N, Hash);                                             \
  }
#define SIZES(X) X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(9) X(11) X(12) \
  X(13) X(15) X(16) X(17) X(20) X(24) X(31) X(32) X(40) X(67) X(200)
SIZES(SIZE)

struct Empty {};
struct Floats { float X, Y, Z; };
struct Mixed { char A; double B; short C; float D; int64_t E; };
struct Half { uint16_t A; struct { char B; uint16_t C; } D; };
struct __attribute__((aligned(32))) Wide { int V[3]; };
struct Nested { struct Floats F[2]; union { int I; float G; } U; struct Wide W; };
typedef struct { _Bool A; void *P; enum { Red, Green } E; } Others;

__attribute__((noinline)) struct Floats cross(struct Floats A, struct Floats B) {
  return (struct Floats){A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z,
                         A.X * B.Y - A.Y * B.X};
}
__attribute__((noinline)) struct Mixed mixed(struct Mixed M, int I, double D,
                                             struct Mixed N, int64_t L) {
  M.B += N.B * D;
  M.E -= N.E + L;
  M.C += I;
  M.D = N.D / 2;
  M.A ^= N.A;
  return M;
}
__attribute__((noinline)) struct Nested nested(struct Empty E, struct Nested N,
                                               struct Half H, struct Wide W) {
  add(((uintptr_t)&W & 31) + ((uintptr_t)&N & 31));
  N.F[1] = cross(N.F[0], N.F[1]);
  N.W.V[2] += W.V[0] + H.A + H.D.C;
  N.U.I ^= H.D.B;
  return N;
}
__attribute__((noinline)) Others others(Others O, Others *P) {
  O.P = P;
  O.A = !O.A;
  O.E = P->E == Red ? Green : Red;
  return O;
}
// A struct that is an argument and changes while it is passed on.
__attribute__((noinline)) int depth(struct Mixed M, int N) {
  if (N == 0)
    return M.C;
  M.C += N;
  int Below = depth(M, N - 1);
  return Below * 2 + M.C;
}
__attribute__((noinline)) int64_t words(int64_t A, int B, int64_t C, int D,
                                        int64_t E, int F, int64_t G, char H,
                                        short I, int64_t J, float K, double L,
                                        float M) {
  return A + 2 * B + 3 * C + 4 * D + 5 * E + 6 * F + 7 * G + 8 * H + 9 * I +
         10 * J + (int64_t)(K * 11 + L * 12 + M * 13);
}

int main(void) {
#define CALL(N) test##N();
  SIZES(CALL)
  struct Floats F = cross((struct Floats){1, 2, 3}, (struct Floats){-4, 5, .5f});
  printf("%g %g %g\n", F.X, F.Y, F.Z);
  struct Mixed M = {'a', 1.25, 300, 2.5f, -5000000000};
  M = mixed(M, 3, 0.5, mixed(M, 1, 2, M, 7), 1ll << 40);
  printf("%d %g %d %g %lld\n", M.A, M.B, M.C, M.D, (long long)M.E);
  struct Nested N = {{{1, 2, 3}, {4, 5, 7}}, {42}, {{1, 2, 3}}};
  N = nested((struct Empty){}, N, (struct Half){7, {1, 2}}, (struct Wide){{9}});
  printf("%g %g %d %d %d\n", N.F[1].X, N.F[1].Z, N.U.I, N.W.V[2],
         (int)((uintptr_t)&N & 31));
  Others O = {1, 0, Red};
  Others R = others(O, &O);
  printf("%d %d %d\n", R.A, R.P == &O, R.E);
  printf("%d\n", depth(M, 6));
  printf("%lld\n", (long long)words(1, 2, 3000000000, 4, 5, 6, 7, -8, -9,
                                    -10000000000, 1.5f, 2.5, 3.5f));
  printf("%08x\n", Hash);
}
