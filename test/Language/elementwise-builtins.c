// Elementwise builtins of vectors: the functions of <math.h>, bits, saturation.
// RUN: %compare %s %t --native clang
#include <stdio.h>
typedef float f4 __attribute__((ext_vector_type(4)));
typedef double d2 __attribute__((ext_vector_type(2)));
typedef unsigned u4 __attribute__((ext_vector_type(4)));
typedef unsigned short us3 __attribute__((ext_vector_type(3)));
volatile float vf=0.7f; volatile double vd=0.7; volatile unsigned vu=0x1234;
#define T(N)                                                                   \
  { f4 R = __builtin_elementwise_##N(x); d2 S = __builtin_elementwise_##N(y);  \
    printf(#N " %.3g %.3g\n", (double)R.y, S.x); }

int main(void) {
  f4 x = {vf, vf, .5f, .25f};
  d2 y = {vd, .5};
  u4 u = {vu, vu, 3, 4};
  us3 s = {1, vu, 70};
  T(sin) T(cos) T(tan) T(asin) T(acos) T(atan) T(sinh) T(cosh) T(tanh)
  T(exp) T(exp2) T(exp10) T(log) T(log2) T(log10) T(sqrt)
  T(floor) T(ceil) T(trunc) T(round) T(roundeven) T(rint) T(nearbyint)
  T(canonicalize) T(abs)
  f4 p = __builtin_elementwise_pow(x, x);
  d2 q = __builtin_elementwise_pow(y, y);
  printf("%.3g %.3g\n", (double)p.x, q.x);
  p = __builtin_elementwise_atan2(p, __builtin_elementwise_fmod(x, x * 0.3f));
  q = __builtin_elementwise_atan2(y, y + 1);
  printf("%.3g %.3g\n", (double)p.x, q.x);
  p = __builtin_elementwise_minimum(__builtin_elementwise_maximum(x, p), x + p);
  q = __builtin_elementwise_maximum(y, __builtin_elementwise_minimum(q, y));
  q = __builtin_elementwise_minimumnum(y, __builtin_elementwise_maxnum(y, q));
  printf("%.3g %.3g\n", (double)p.x, q.x);
  p = __builtin_elementwise_fma(p, x, x) - __builtin_elementwise_copysign(x, -p);
  printf("%.3g\n", (double)p.x);
  u = __builtin_elementwise_popcount(u) + __builtin_elementwise_bitreverse(u);
  u = __builtin_elementwise_fshl(u, u, (u4){1, 2, 3, 4});
  s = __builtin_elementwise_add_sat(s, s);
  printf("%x %d %u\n", u.x, s.y, __builtin_reduce_max(u));
}
