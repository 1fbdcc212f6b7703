// A NaN can become an index by a conversion, which is checked, or by its bits:
// these are a number like any other, and the access traps if it is outside.

// RUN: tpcc -O2 -ftp-check-fp %s -o %t.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %t.elf -- | FileCheck %s

#include "Inputs/cases.h"

int Bins[16];
NOINLINE int &binOf(float X) { return Bins[int(X * 16)]; }
NOINLINE int &bitsOf(float X) {
  return Bins[__builtin_bit_cast(uint32_t, X)];
}

int main(int, char **Arguments) {
  const char *Case = Arguments[1];
  // CHECK: converted: 1
  // CHECK-NEXT: NaN converted to an integer: nan (0x7fc00000) to int32_t
  // CHECK-NEXT: in binOf(float) at {{.*}}memory-index.cpp:10:48
  CASE("converted", ++binOf(floatOf(NaN)))
  // CHECK: inside: 0
  CASE("inside", ++binOf(floatOf(0x3F000000)))
  // CHECK: bits: 1
  // CHECK-NEXT: {{null dereference|access outside memory}}
  CASE("bits", ++bitsOf(floatOf(0x7FBFFFFF)))
  return 2;
}
