// Clang's fixed-point numbers (-ffixed-point) and matrices (-fenable-matrix).
// RUN: %compare %s %t --native clang -ffixed-point -fenable-matrix
#include <stdio.h>

static _Accum A = 1.5k;
static _Fract F = 0.25r;
static _Sat unsigned short _Accum S = 200.5uhk;
static long _Accum L = 3.75lk;
typedef float Square __attribute__((matrix_type(4, 4)));
typedef double Wide __attribute__((matrix_type(2, 3)));
typedef double High __attribute__((matrix_type(3, 2)));

__attribute__((noinline)) _Accum mix(_Accum X, _Fract Y, short _Accum Z) {
  return X * Y + Z / 3;
}
__attribute__((noinline)) Square multiply(Square X, Square Y) { return X * Y + X; }

int main(void) {
  A *= 3;
  F += 0.125r;
  S += S;
  L /= 2;
  L <<= 1;
  printf("%d %d %d %d %d\n", (int)(A * 100), (int)(F * 1000.0k), (int)S, (int)L, A > 4.0k);
  printf("%d\n", (int)(mix(A, F, -7.5hk) * 1000));
  Square X, Y;
  Wide W;
  High H;
  for (int I = 0; I < 4; ++I)
    for (int J = 0; J < 4; ++J) {
      X[I][J] = I + J;
      Y[I][J] = I * J + 1;
    }
  for (int I = 0; I < 2; ++I)
    for (int J = 0; J < 3; ++J) {
      W[I][J] = I + J;
      H[J][I] = I * J;
    }
  X = multiply(X, __builtin_matrix_transpose(Y));
  printf("%g %g\n", X[2][3], (W * H)[1][1]);
}
