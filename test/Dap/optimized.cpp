// Optimized code: inlined functions have frames of their own.
//
// RUN: tpcc -O2 -g %s -o %t.elf
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/optimized.js

volatile int Input = 5;
volatile int Output;

[[gnu::always_inline]] static inline int inner(int A) {
  Output = A; // in inner
  return A * Input;
}

[[gnu::always_inline]] static inline int middle(int B) {
  return inner(B + 1); // calls inner
}

[[gnu::noinline]] static int outer(int C) {
  int D = middle(C); // calls middle
  return D + Input;  // after middle
}

int main() {
  Output = outer(Input); // calls outer
  return 0;
}
