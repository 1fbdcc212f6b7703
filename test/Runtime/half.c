// _Float16 is stored as half precision and computed with as float, as on the
// host.

// RUN: %host_cc %s -o %t.host && %t.host > %t.expected
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf | diff %t.expected -
// RUN: tpcc -O2 %s -o %t2.elf && tpsim --chip 1x1 --quiet %t2.elf | diff %t.expected -

#include <stdio.h>

__attribute__((noinline)) static _Float16 fromFloat(float Value) {
  return (_Float16)Value;
}
__attribute__((noinline)) static _Float16 fromDouble(double Value) {
  return (_Float16)Value;
}
__attribute__((noinline)) static float product(_Float16 A, _Float16 B) {
  return A * B;
}

int main(void) {
  volatile float One = 1.1f;
  volatile double Two = 2.3;
  _Float16 Stored[2] = {fromFloat(One), fromDouble(Two)};
  printf("%zu %a %a %a\n", sizeof(Stored), (double)(float)Stored[0],
         (double)(float)Stored[1], (double)product(Stored[0], Stored[1]));
  return 0;
}
