// On a chip that flushes subnormals, a checked function stops where it would
// lose one. The simulator does that: the program is the same on both chips.

// RUN: tpsim --print-chip --chip 4x32 \
// RUN:   | sed 's/^flush_to_zero: false/flush_to_zero: true/' > %t.yaml
// RUN: grep -q "^flush_to_zero: true" %t.yaml
// RUN: tpcc -O0 -ftp-check-fp %s -o %t0.elf
// RUN: %run_cases %s tpsim --chip %t.yaml --quiet %t0.elf -- | FileCheck %s
// RUN: tpcc -O3 -ftp-check-fp %s -o %t3.elf
// RUN: %run_cases %s tpsim --chip %t.yaml --quiet %t3.elf -- | FileCheck %s
// RUN: %run_cases %s tpsim --chip 4x32 --quiet %t3.elf -- \
// RUN:   | FileCheck %s --check-prefix=KEPT --implicit-check-not=trap
// KEPT: result: 0
// Objects from elsewhere bring their lists with them.
// RUN: tpcc -O1 -g -S -fno-lto -ftp-check-fp %s -o %t.s
// RUN: tpcc %t.s -o %ts.elf
// RUN: %run_cases %s tpsim --chip %t.yaml --quiet %ts.elf -- | FileCheck %s
// Without the option nothing happens.
// RUN: tpcc -O3 %s -o %tu.elf
// RUN: %run_cases %s tpsim --chip %t.yaml --quiet %tu.elf -- \
// RUN:   | FileCheck %s --check-prefix=KEPT --implicit-check-not=trap

// The first of many threads, for any number of host threads.
// RUN: not tpsim --chip %t.yaml --quiet --host-threads 1 %t3.elf --stats %t1.json -- all > %t1.txt 2>&1
// RUN: not tpsim --chip %t.yaml --quiet --host-threads 3 %t3.elf --stats %t3.json -- all > %t3.txt 2>&1
// RUN: cmp %t1.txt %t3.txt
// RUN: cmp %t1.json %t3.json

// RUN: tp-objdump -h %t3.elf | FileCheck %s --check-prefix=SECTION
// SECTION: .tp_fp_checked

#include "Inputs/cases.h"
#include <tp/math.h>
#include <tp/thread.h>

volatile float Sink;
NOINLINE float product(float A, float B) { return A * B; }
NOINLINE bool less(float A, float B) { return A < B; }
NOINLINE int floor(float A) { return __builtin_tp_floor_w(A); }
NOINLINE float moved(const float *P) { return __builtin_fabsf(*P); }

int main(int, char **Arguments) {
  const char *Case = Arguments[1];
  float Tiny = floatOf(0x0DA24260), Subnormal = floatOf(0x000116C2);
  CASE("all", Sink = product(Tiny, 1e-9f))
  if (tp::threadId() != 77)
    return 0;
  // CHECK: result: 1
  // CHECK-NEXT: tpsim: error: thread 77: subnormal result 1e-39 (0x000ae398) flushed to zero
  // CHECK-NEXT: in product(float, float) at {{.*}}subnormals.cpp:37:53
  // CHECK-NEXT: instruction: mul_s rd=f{{[0-9]+}}, rs=f{{[0-9]+}}: 1e-30 (0x0da24260), rt=f{{[0-9]+}}: 1e-09 (0x3089705f)
  CASE("result", Sink = product(Tiny, 1e-9f))
  // CHECK: normal: 0
  CASE("normal", Sink = product(Tiny, 1e-7f) + product(Tiny, 0))
  // CHECK: operand: 1
  // CHECK-NEXT: subnormal operand 1e-40 (0x000116c2) flushed to zero
  // CHECK-NEXT: in less(float, float) at {{.*}}subnormals.cpp:38:
  CASE("operand", Sink = less(0, Subnormal))
  // CHECK: conversion: 1
  // CHECK-NEXT: subnormal operand -1e-40 (0x800116c2) flushed to zero
  CASE("conversion", Sink = floor(floatOf(0x800116C2)))
  // Copies and signs lose nothing.
  // CHECK: copy: 0
  static float Buffer[1];
  CASE("copy", *Buffer = Subnormal; Sink = moved(Buffer))
  // The runtime is not checked: it may compute with what counts for nothing.
  // CHECK: library: 0
  CASE("library", Sink = tp::sin(floatOf(0x00800000)))
  return 2;
}
